#pragma once

namespace CLI {
class App;
}

namespace dumbbell {

/// `campaign plan|run|status|merge`: one claim proved in shards.
void add_campaign_command(CLI::App& app, int& exit_code);

}  // namespace dumbbell
