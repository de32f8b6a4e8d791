#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace dumbbell {

/// A text from elsewhere as one line for people: what is no printable ASCII is `?`, and of a text that is
/// longer than `most` characters the first ones, then `...`.
[[nodiscard]] inline std::string printable(std::string_view text, std::size_t most) {
    std::string line(text.substr(0, most));
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return line + (text.size() > most ? "..." : "");
}

}  // namespace dumbbell
