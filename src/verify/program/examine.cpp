#include "verify/program/examine.hpp"

#include <atomic>
#include <condition_variable>
#include <mutex>

#include "verify/core/section.hpp"
#include "verify/machine/threads.hpp"

namespace dumbbell_verify {
namespace {
constexpr const char* names[] = {"VERIFIED", "UNREADABLE", "OPEN", "UNSUPPORTED", "LIMIT", "REJECTED"};
constexpr int exit_codes[] = {0, 2, 3, 3, 4, 1};

/// What --explain can show of a file.
std::string trees(const Verified& proof) {
    if (proof.other) return "the leaves of this file are " + std::string(proof.other->leaves());
    std::string text =
        "PIECE is from 1 to " + std::to_string(proof.claim.pieces) + ", and the trees of a piece are ";
    for (const Chart& chart : proof.section->charts) text += std::string(chart.name) + ", ";
    return text + "witness; where a lemma proves the bound there is the witness alone";
}
}  // namespace

Failure nothing_proved() {
    return {Verdict::open, 0, "nothing-proved", "no bound is proved for all that is in question"};
}

const char* verdict_name(Verdict verdict) { return names[static_cast<int>(verdict)]; }
int exit_code(Verdict verdict) { return exit_codes[static_cast<int>(verdict)]; }

Result examine(const Job& job) {
    const Request& settings = job.settings;
    Result result;
    result.job = &job;
    try {
        result.proof = job.bytes ? verify(*job.bytes, settings) : verify(job.file, settings);
        if (!settings.explain.empty() && !result.proof.explained)
            result.why = {Verdict::unreadable, 0, "usage",
                          "there is no leaf " + settings.explain + "; " + trees(result.proof)};
        else if (result.proof.says_nothing(settings.demand))
            result.why = nothing_proved();
    } catch (Failure& failure) {
        result.why = std::move(failure);
    } catch (const std::exception& error) {  // out of memory, no more threads
        result.why = {Verdict::limit, 0, "limit", error.what()};
    }
    return result;
}

std::vector<Result> examine_all(const std::vector<Job>& jobs, unsigned at_once,
                                const std::function<void(const Result&)>& report) {
    std::vector<Result> results(jobs.size());  // one without a job is not there yet
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::condition_variable arrived;
    const auto examine_next = [&] {
        const std::size_t i = next++;
        if (i >= jobs.size()) return false;
        Result result = examine(jobs[i]);
        const std::lock_guard lock(mutex);
        results[i] = std::move(result);
        arrived.notify_one();
        return true;
    };
    Crew crew;
    if (at_once > 1)
        crew.start(at_once, [&] {
            while (examine_next()) {
            }
        });
    for (const Result& result : results) {
        if (crew.empty()) examine_next();
        std::unique_lock lock(mutex);
        arrived.wait(lock, [&] { return result.job != nullptr; });
        lock.unlock();
        report(result);
    }
    return results;
}

}  // namespace dumbbell_verify
