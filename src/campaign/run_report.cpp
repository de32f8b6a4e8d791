#include "campaign/run_report.hpp"

#include <fmt/core.h>

#include "words/printed.hpp"

namespace dumbbell::campaign {
namespace {

std::size_t answers(const CampaignRun& run) { return run.accepted + run.again + run.rejected; }

/// Seconds of bookkeeping for each result that came.
double overhead(const CampaignRun& run) {
    return answers(run) == 0 ? 0 : run.own_seconds / static_cast<double>(answers(run));
}

}  // namespace

std::string verdict(const CampaignRun& run) {
    return fmt::format("{} finished in {}{}\n", plural(run.accepted, "shard"), time_text(run.seconds),
                       run.left == 0 ? "; the campaign is complete" : "");
}

std::string to_text(const CampaignRun& run) {
    std::string text = verdict(run);
    text += fmt::format("work: {:.1f} s; the manager's own: {:.2f} ms a shard\n", run.worked,
                        1000 * overhead(run));
    if (run.verifying > 0) {
        text += fmt::format("verification of what came in: {:.1f} s\n", run.verifying);
    }
    if (run.split > 0) {
        text += fmt::format("split because they were too big: {}\n", run.split);
    }
    if (run.rejected + run.failed + run.again > 0) {
        text +=
            fmt::format("results rejected: {}; attempts without a result: {}; results that came twice: {}\n",
                        run.rejected, run.failed, run.again);
    }
    if (run.engine.lost + run.engine.resent > 0) {
        text += fmt::format("workers: {} came, {} were lost; shards sent again: {}\n", run.engine.joined,
                            run.engine.lost, run.engine.resent);
    }
    return text;
}

Json to_json(const CampaignRun& run, std::string_view engine) {
    return Json::object({{"schema", "dumbbell-campaign-run-1"},
                         {"engine", engine},
                         {"complete", run.left == 0},
                         {"accepted", run.accepted},
                         {"again", run.again},
                         {"rejected", run.rejected},
                         {"failed", run.failed},
                         {"split", run.split},
                         {"given_up", run.given_up},
                         {"left", run.left},
                         {"seconds", run.seconds},
                         {"worked_seconds", run.worked},
                         {"manager_seconds", run.own_seconds},
                         {"manager_seconds_a_shard", overhead(run)},
                         {"verification_seconds", run.verifying},
                         {"workers_joined", run.engine.joined},
                         {"workers_lost", run.engine.lost},
                         {"resent", run.engine.resent}});
}

}  // namespace dumbbell::campaign
