#pragma once

#include <string>

#include "cli/pages/command_table.hpp"

namespace dumbbell::pages {

/// A script for bash that completes commands, options, their words and file names, of dumbbell and of
/// dumbbell-verify, whose options are those of `dumbbell verify`.
[[nodiscard]] std::string bash_completion(const CommandEntry& program);

}  // namespace dumbbell::pages
