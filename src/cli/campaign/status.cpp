#include "campaign/status.hpp"

#include <fmt/core.h>

#include "campaign/status_report.hpp"
#include "cli/commands.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/frame.hpp"

namespace dumbbell::cli {
namespace {

constexpr std::array status_options{argument("FOLDER", "the campaign's folder").required(),
                                    json_option.excludes("--quiet"),
                                    flag("--quiet", "one sentence").excludes("--json")};

int run_status(const Given& given) {
    fmt::print("{}", shown(campaign_status(campaign::CampaignFolder(given.text("FOLDER"))), given));
    return exit_done;
}

}  // namespace

constinit const Command campaign_status_command{
    "status",
    one_group,
    "How far a campaign has got, while it runs or later: shards, rate, time left, workers.",
    inherited,
    status_options,
    run_status};

}  // namespace dumbbell::cli
