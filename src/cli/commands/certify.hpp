#pragma once

#include <CLI/App.hpp>

namespace dumbbell {

/// Adds `dumbbell certify` to the program; its exit code is stored in `exit_code` when it is run.
void add_certify_command(CLI::App& app, int& exit_code);

}  // namespace dumbbell
