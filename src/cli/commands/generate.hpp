#pragma once

#include <CLI/App.hpp>

namespace dumbbell {

/// Adds `dumbbell generate`, which --help does not show: the man page, the completion and the reference, made
/// from the commands that `app` has when it is run.
void add_generate_command(CLI::App& app);

}  // namespace dumbbell
