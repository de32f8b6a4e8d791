#pragma once

#include <CLI/App.hpp>

namespace dumbbell {

/// Adds `dumbbell audit`: proves with exact arithmetic that the leaves of certificates tile the section.
void add_audit_command(CLI::App& app, int& exit_code);

}  // namespace dumbbell
