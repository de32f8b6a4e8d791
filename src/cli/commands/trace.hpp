#pragma once

#include <CLI/App.hpp>

namespace dumbbell {

/// Adds `dumbbell trace`: the rigorous orbit of one initial condition or of a box of them.
void add_trace_command(CLI::App& app, int& exit_code);

}  // namespace dumbbell
