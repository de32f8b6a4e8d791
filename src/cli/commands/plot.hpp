#pragma once

#include <CLI/App.hpp>

namespace dumbbell {

/// Adds `dumbbell plot`: pictures from certificates.
void add_plot_command(CLI::App& app, int& exit_code);

}  // namespace dumbbell
