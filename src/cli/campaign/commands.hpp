#pragma once

namespace CLI {
class App;
}

/// The commands below `campaign`, each in a file of its own.
namespace dumbbell {

void add_campaign_plan(CLI::App& campaign, int& exit_code);
void add_campaign_run(CLI::App& campaign, int& exit_code);
void add_campaign_status(CLI::App& campaign, int& exit_code);
void add_campaign_merge(CLI::App& campaign, int& exit_code);
/// What a worker runs; not shown in the help.
void add_campaign_work(CLI::App& campaign, int& exit_code);

}  // namespace dumbbell
