#include "campaign/status_report.hpp"

#include <fmt/core.h>

#include <vector>

#include "base/printable.hpp"
#include "words/printed.hpp"
#include "words/text_table.hpp"

namespace dumbbell::campaign {

std::string verdict(const CampaignStatus& status) {
    std::string text = fmt::format("{} of {} shards are done", status.done, status.shards);
    if (status.is_complete()) {
        return text + "\n";
    }
    text += fmt::format(" ({:.1f} % of the estimated work)", 100 * status.share);
    if (!status.is_running) {
        return text + "; no run is at work\n";
    }
    return text +
           (status.remaining ? fmt::format("; about {} remain\n", time_text(*status.remaining)) : "\n");
}

std::string to_text(const CampaignStatus& status) {
    std::string text = fmt::format("{}\n{}", one_line(status.claim), verdict(status));
    if (status.is_running) {
        text += fmt::format("running: {} shards on {} workers\n", status.running, status.connected);
    }
    if (status.rate) {
        text += fmt::format("rate: {:.1f} shards a minute{}\n", *status.rate,
                            status.is_running ? "" : " in the last run");
    }
    if (status.split > 0) {
        text += fmt::format("split because they were too big: {}\n", status.split);
    }
    if (status.failed + status.rejected > 0) {
        text += fmt::format("attempts that failed: {}, results that were rejected: {}\n", status.failed,
                            status.rejected);
    }
    if (!status.workers.empty()) {
        std::vector<TableLine> lines{{"worker", "shards", "failed", "seconds a shard", "last heard of"}};
        for (const auto& [name, worker] : status.workers) {
            lines.push_back({one_line(name), fmt::format("{}", worker.done), fmt::format("{}", worker.failed),
                             worker.done == 0
                                 ? "-"
                                 : fmt::format("{:.2f}", worker.seconds / static_cast<double>(worker.done)),
                             time_text(worker.last_heard) + " ago"});
        }
        text += "\n" + aligned(lines, 0);
    }
    return text;
}

Json to_json(const CampaignStatus& status) {
    Json workers = Json::array();
    for (const auto& [name, worker] : status.workers) {
        workers.add(Json::object({{"name", name},
                                  {"done", worker.done},
                                  {"failed", worker.failed},
                                  {"seconds", worker.seconds},
                                  {"last_heard_seconds_ago", worker.last_heard}}));
    }
    return Json::object({{"schema", "dumbbell-campaign-status-1"},
                         {"claim", status.claim},
                         {"complete", status.is_complete()},
                         {"shards", status.shards},
                         {"done", status.done},
                         {"split", status.split},
                         {"share", status.share},
                         {"run_at_work", status.is_running},
                         {"running", status.running},
                         {"workers_connected", status.connected},
                         {"failed_attempts", status.failed},
                         {"rejected_results", status.rejected},
                         {"shards_a_minute", status.rate},
                         {"remaining_seconds", status.remaining},
                         {"workers", workers}});
}

}  // namespace dumbbell::campaign
