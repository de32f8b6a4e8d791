#pragma once

#include <string>

#include "cli/options/option.hpp"

namespace dumbbell::cli::pages {

/// The --help of a command: its options in the words of the man page, in lines of at most 120 columns. Of one
/// that is nothing but its commands: each of these in a line, on one screen; the whole of its description
/// stands in the manual.
[[nodiscard]] std::string help(const Command& program, const Command& command);

/// The help of a command and of all that are below it.
[[nodiscard]] std::string help_all(const Command& program, const Command& command);

}  // namespace dumbbell::cli::pages
