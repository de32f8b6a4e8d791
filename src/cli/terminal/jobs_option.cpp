#include "cli/terminal/jobs_option.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

namespace dumbbell {

int all_cores() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

void add_jobs_option(CLI::App& command, int& jobs, const char* text) {
    command.add_option("--jobs", jobs, text)->check(CLI::Range(1, 1024))->default_str("all cores");
}

}  // namespace dumbbell
