#pragma once

#include <CLI/App.hpp>

namespace dumbbell {

/// Adds `dumbbell law`: what a verified staircase says as a whole. Its exit code goes to `exit_code`.
void add_law_command(CLI::App& app, int& exit_code);

}  // namespace dumbbell
