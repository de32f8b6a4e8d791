#pragma once

#include <CLI/App.hpp>

namespace dumbbell {

/// Adds `dumbbell adiabatic`: the paper's section 3 with proved constants.
void add_adiabatic_command(CLI::App& app, int& exit_code);

}  // namespace dumbbell
