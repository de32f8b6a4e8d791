#pragma once

#include <CLI/App.hpp>

namespace dumbbell {

/// The standard number of threads: the cores of this machine.
[[nodiscard]] int all_cores();

/// Adds --jobs to a command; `jobs`, which is all_cores() unless told otherwise, outlives it.
void add_jobs_option(CLI::App& command, int& jobs,
                     const char* text = "threads; the result does not depend on it");

}  // namespace dumbbell
