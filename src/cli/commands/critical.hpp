#pragma once

#include <CLI/App.hpp>

namespace dumbbell {

/// Adds `dumbbell critical`: certified enclosures of the critical mass ratios.
void add_critical_command(CLI::App& app, int& exit_code);

}  // namespace dumbbell
