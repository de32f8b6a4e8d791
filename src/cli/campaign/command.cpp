#include <array>

#include "cli/commands.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* campaign_description =
    R"(Prove what is too big for one run: in shards, on this machine or many.

A campaign is a folder of plain files. It can be stopped, killed and started again at any time: what is finished is
kept, and the result does not depend on where, how often or in which order the shards were processed.

Examples:
  dumbbell campaign plan stairs.campaign 1:1e6 --gap 1e-9    cut the claim into shards
  dumbbell campaign run stairs.campaign                      process them, on all cores
  dumbbell campaign status stairs.campaign                   how far it has got
  dumbbell campaign merge stairs.campaign --out stairs.dbc   verify the shards, join them)";

constexpr const char* campaign_footer =
    R"(Workers on other machines, and what to consider first: docs/8-campaigns.md.
The fields of --json: docs/reference/json.md.

Exit codes: 0 done as asked; 1 internal error, or two results of one shard differ; 2 wrong usage or input; 3 not
finished or not certified; 130 or 143 stopped by SIGINT (Ctrl-C) or SIGTERM: what is finished is kept.)";

constexpr std::array campaign_commands{&campaign_plan_command, &campaign_run_command,
                                       &campaign_status_command, &campaign_merge_command,
                                       &campaign_work_command};

}  // namespace

constinit const Command campaign_command{"campaign", "Prove", campaign_description, campaign_footer,
                                         {},         nullptr, campaign_commands};

}  // namespace dumbbell::cli
