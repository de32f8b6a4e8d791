#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace dumbbell {

using TableLine = std::vector<std::string>;

/// A line per line, the columns as wide as they must be and two blanks apart; flush right, but for the column
/// `left`. Precondition: all lines have as many columns.
[[nodiscard]] std::string aligned(const std::vector<TableLine>& lines, std::size_t left);

}  // namespace dumbbell
