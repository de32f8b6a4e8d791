#pragma once

#include <string_view>

namespace dumbbell {

/// The last line of a text that is not blank, without the spaces around it; empty if there is none.
[[nodiscard]] std::string_view last_line(std::string_view text);

}  // namespace dumbbell
