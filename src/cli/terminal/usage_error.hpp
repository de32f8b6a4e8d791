#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace dumbbell {

/// What is wrong with a command line that CLI11 refused, in the words of whoever typed it, and where to read
/// on (`hint`): commands are commands, and what was not expected is named in the order given.
[[nodiscard]] std::string usage_error(const CLI::App& app, const CLI::ParseError& error,
                                      const std::vector<std::string>& words);

}  // namespace dumbbell
