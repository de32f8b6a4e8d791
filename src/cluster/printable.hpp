#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace dumbbell {

/// A text from elsewhere as one line for people: what is no printable ASCII is `?`, and of a text that is
/// longer than `most` characters the first ones, then `...`.
[[nodiscard]] std::string printable(std::string_view text, std::size_t most);

/// The last line of a text that is not blank, without the spaces around it; empty if there is none.
[[nodiscard]] std::string_view last_line(std::string_view text);

}  // namespace dumbbell
