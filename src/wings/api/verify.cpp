#include "dumbbell/verify.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "api/stack.hpp"
#include "api/without_dashes.hpp"
#include "verify/input/bytes.hpp"
#include "verify/machine/environment.hpp"
#include "verify/program/claim_options.hpp"
#include "verify/program/examine.hpp"
#include "verify/program/summary.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {
namespace {

/// The bytes of a file, or of a text in memory, until the caller wants no more.
template <class From>
class StoppableBytes : public dumbbell_verify::Source {
  public:
    StoppableBytes(From from, const Stopped& stopped) : from_(std::move(from)), stopped_(stopped) {}

    std::string_view next(std::uint64_t line) override {
        if (stopped_ && stopped_()) {
            throw dumbbell_verify::Failure{dumbbell_verify::Verdict::limit, line, "limit", "it was stopped"};
        }
        return (bytes_ ? *bytes_ : bytes_.emplace(from_)).next(line);
    }
    [[nodiscard]] std::string foreign(std::string_view line, bool is_first) const override {
        return dumbbell_verify::foreign_text(line, is_first);
    }

  private:
    From from_;
    const Stopped& stopped_;
    std::optional<dumbbell_verify::Bytes> bytes_;  ///< opened when the first are wanted
};

/// By the verifier's own table of options, which refuses what does not fit.
dumbbell_verify::ClaimWords words_of(const Claim& claim) {
    std::vector<std::string> options;
    const auto add = [&](const char* option, const std::string& value) {
        options.insert(options.end(), {option, value});
    };
    if (claim.kind && !claim.kind->empty()) {
        add("--claim", *claim.kind);
    }
    if (!claim.ratio.empty()) {
        add("--ratio", claim.ratio);
    }
    if (claim.most) {
        add("--max", std::to_string(*claim.most));
    }
    if (claim.least) {
        add("--min", std::to_string(*claim.least));
    }
    std::istringstream demand(claim.demand);
    options.insert(options.end(), std::istream_iterator<std::string>(demand), {});
    dumbbell_verify::Arguments claimed(std::move(options));
    dumbbell_verify::ClaimWords words;
    while (claimed.next()) {
        if (!claim_option(claimed, words)) {
            throw std::invalid_argument("`" + claimed.word.substr(0, 60) + "` states no claim");
        }
    }
    if (!claim.kind) {
        words.try_emplace("--claim", "collisions");
    }
    return words;
}

dumbbell_verify::Job job_of(const Claim& claim, unsigned jobs, const std::string& budget) try {
    if (jobs < 1 || jobs > 1024) {
        throw std::invalid_argument("jobs is out of range: give a number of threads from 1 to 1024");
    }
    dumbbell_verify::Job job;
    job.settings.jobs = jobs;
    job.settings.max_bits = 4096;  // all that a file may ask for: the budget bounds what that costs
    dumbbell_verify::Arguments time({"--budget", budget});
    time.next();
    job.settings.budget = time.time();
    state_claim(words_of(claim), job.settings);
    return job;
} catch (const std::invalid_argument& error) {
    throw std::invalid_argument(without_dashes(error.what()));
}

using Found = dumbbell_verify::Verdict;

Verdict given(Found verdict) {
    constexpr std::array in_order{Found::verified,   Found::rejected, Found::unsupported,
                                  Found::unreadable, Found::limit,    Found::open};
    static_assert(in_order.size() == static_cast<std::size_t>(Found::rejected) + 1);
    return static_cast<Verdict>(std::ranges::find(in_order, verdict) - in_order.begin());
}

template <class From>
Verification judged(const From& from, const Claim& claim, unsigned jobs, const std::string& budget,
                    const Stopped& stopped) {
    Verification verification;
    const auto work = [&] {
        const dumbbell_verify::DefaultEnvironment environment;
        dumbbell_verify::Job job = job_of(claim, jobs, budget);
        StoppableBytes bytes(from, stopped);
        job.bytes = &bytes;
        const dumbbell_verify::Result result = examine(job);
        verification = {given(result.why.verdict), without_dashes(result_text(result)), result.proof.digest};
    };
    try {
        with_stack(work, mpfr_free_cache);
    } catch (const std::system_error& error) {
        return {Verdict::limit, error.what(), ""};
    }
    return verification;
}

}  // namespace

Verification verify(const std::string& file, const Claim& claim, unsigned jobs, const std::string& budget,
                    const Stopped& stopped) {
    if (file.find('\0') != std::string::npos) {
        throw std::invalid_argument("the name of the file has a NUL in it");
    }
    const std::string path = file == "-" ? "./-" : file;  // a path, not the standard input
    return judged(path, claim, jobs, budget, stopped);
}

Verification verify_text(std::string_view text, const Claim& claim, unsigned jobs, const std::string& budget,
                         const Stopped& stopped) {
    return judged(dumbbell_verify::Memory{text}, claim, jobs, budget, stopped);
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
