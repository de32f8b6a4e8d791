#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace dumbbell {

/// The text for a message or a file of lines: at most `most` characters, and `?` for all that a terminal
/// might obey.
[[nodiscard]] inline std::string printable(std::string_view text, std::size_t most) {
    std::string result(text.substr(0, most));
    std::replace_if(
        result.begin(), result.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return result;
}

}  // namespace dumbbell
