#pragma once

#include <CLI/App.hpp>

namespace dumbbell {

/// `dumbbell report`
void add_report_command(CLI::App& app, int& exit_code);

}  // namespace dumbbell
