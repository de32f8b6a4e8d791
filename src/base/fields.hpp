#pragma once

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

/// Lines taken apart.
namespace dumbbell {

/// What stands between the separators, empty or not: one part more than there are separators.
[[nodiscard]] inline std::vector<std::string_view> split(std::string_view line, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(separator, begin), line.size());
        parts.push_back(line.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

/// The number that the whole text spells, as std::from_chars reads it.
template <class Number>
[[nodiscard]] std::optional<Number> number_of(std::string_view text) {
    Number number{};
    const char* begin = text.data();
    const char* end = begin + text.size();
    const auto [rest, fault] = std::from_chars(begin, end, number);
    return fault == std::errc{} && rest == end ? std::optional(number) : std::nullopt;
}

}  // namespace dumbbell
