#pragma once

#include <string>
#include <vector>

#include "cli/options/option.hpp"

namespace dumbbell::cli {

/// The commands that --help of this one shows.
[[nodiscard]] std::vector<std::string> names_of_commands(const Command& command);

/// What may help after a command line that was not understood: the command or option that was meant, if one
/// is spelled nearly so, and whose --help to read. `words`: those after the program's name.
[[nodiscard]] std::string hint(const Command& program, const std::vector<std::string>& words);

}  // namespace dumbbell::cli
