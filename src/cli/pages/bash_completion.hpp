#pragma once

#include <string>

#include "cli/options/option.hpp"

namespace dumbbell::cli::pages {

/// A script for bash that completes commands, options, their words and file names, of dumbbell and of
/// dumbbell-verify, whose options are those of `dumbbell verify`.
[[nodiscard]] std::string bash_completion(const Command& program);

}  // namespace dumbbell::cli::pages
