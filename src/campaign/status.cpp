#include "campaign/status.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <set>

namespace dumbbell::campaign {
namespace {

/// The number after `word=` in a line of figures.
std::size_t figure(const std::string& line, const std::string& word) {
    const std::size_t at = (" " + line).find(" " + word + "=");
    std::size_t value = 0;
    if (at != std::string::npos) {
        std::from_chars(line.data() + at + word.size() + 1, line.data() + line.size(), value);
    }
    return value;
}

/// Of the last run: when it began, when the first shard that it finished was begun, what it finished, when
/// something last happened. The time before a worker came says nothing about the rate.
struct LastRun {
    double begin = 0;
    double work_begin = std::numeric_limits<double>::infinity();
    double last = 0;
    bool ended = false;
    std::set<std::string> done;
};

void count(const JournalEntry& event, CampaignStatus& status, LastRun& run) {
    using What = JournalEntry::What;
    run.last = event.time;
    const bool has_failed = event.what == What::failed || event.what == What::rejected;
    if (event.what == What::done || has_failed) {
        CampaignStatus::Worker& worker = status.workers[event.worker];
        worker.last_heard = event.time;
        worker.done += has_failed ? 0 : 1;
        worker.failed += has_failed ? 1 : 0;
        worker.seconds += has_failed ? 0 : event.seconds;
    }
    switch (event.what) {
        case What::begin:
            run = {};
            run.begin = run.last = event.time;
            break;
        case What::end:
            run.ended = true;
            break;
        case What::done:
            run.done.insert(event.id);
            run.work_begin = std::max(run.begin, std::min(run.work_begin, event.time - event.seconds));
            break;
        case What::failed:
            ++status.failed;
            break;
        case What::rejected:
            ++status.rejected;
            break;
        case What::split:
            ++status.split;
            break;
        case What::state:
            status.running = figure(event.text, "running");
            status.connected = figure(event.text, "workers");
            break;
        case What::again:
            break;
    }
}

}  // namespace

CampaignStatus campaign_status(const CampaignFolder& folder) {
    CampaignStatus status;
    status.claim = folder.plan().claim;
    status.is_running = folder.is_locked_by_another();
    LastRun run;
    for (const JournalEntry& event : folder.journal().read()) {
        count(event, status, run);
    }
    double whole = 0;
    double done = 0;
    double done_now = 0;  // in the last run
    for (const CampaignFolder::Part& part : folder.parts()) {
        ++status.shards;
        whole += part.cost;
        if (part.finished) {
            ++status.done;
            done += part.cost;
            done_now += run.done.contains(part.id) ? part.cost : 0;
        }
    }
    const double present = seconds_since_1970();
    for (auto& [name, worker] : status.workers) {
        worker.last_heard = std::max(0.0, present - worker.last_heard);
    }
    status.share = whole > 0 ? done / whole : 0;
    if (!status.is_running) {
        status.running = status.connected = 0;
    }
    const double time = (status.is_running ? present : run.last) - run.work_begin;
    if (!run.done.empty() && time > 0) {
        status.rate = 60 * static_cast<double>(run.done.size()) / time;
        if (done_now > 0) {
            status.remaining = (whole - done) * time / done_now;
        }
    }
    return status;
}

}  // namespace dumbbell::campaign
