#include "campaign/status.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "campaign/status_report.hpp"
#include "cli/campaign/commands.hpp"
#include "cli/terminal/exit_code.hpp"
#include "words/json_number.hpp"

namespace dumbbell {
namespace {

struct Options {
    std::string folder;
    bool json = false;
    bool quiet = false;
};

}  // namespace

void add_campaign_status(CLI::App& campaign, int& exit_code) {
    auto options = std::make_shared<Options>();
    CLI::App* command = campaign.add_subcommand(
        "status", "How far a campaign is, while it runs or later: shards, rate, time left, each worker.");
    command->add_option("FOLDER", options->folder, "the campaign's folder")->required();
    CLI::Option* json = command->add_flag("--json", options->json, "one JSON object on stdout");
    command->add_flag("--quiet", options->quiet, "one sentence")->excludes(json);
    command->callback([options, &exit_code] {
        const CampaignStatus status = campaign_status(CampaignFolder(options->folder));
        fmt::print("{}", options->json    ? json_text(to_json(status))
                         : options->quiet ? verdict(status)
                                          : to_text(status));
        exit_code = exit_done;
    });
}

}  // namespace dumbbell
