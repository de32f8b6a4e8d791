#pragma once

#include <optional>
#include <string_view>

/// Enumerations with names: their values are 0, 1, ..., and `name` of what follows the last is empty. As a
/// switch without default it makes the compiler ask for the name of a new value.
namespace dumbbell {

/// Nothing for an unknown name.
template <class Value>
[[nodiscard]] constexpr std::optional<Value> value_named(std::string_view text) {
    for (int i = 0; !name(static_cast<Value>(i)).empty(); ++i) {
        if (name(static_cast<Value>(i)) == text) {
            return static_cast<Value>(i);
        }
    }
    return std::nullopt;
}

/// Whether `words` is all names: `a|b|c`.
template <class Value>
[[nodiscard]] constexpr bool are_names_of(std::string_view words) {
    for (int i = 0;; ++i) {
        const std::size_t end = words.find('|');
        if (words.substr(0, end) != name(static_cast<Value>(i))) {
            return false;
        }
        if (end == std::string_view::npos) {
            return name(static_cast<Value>(i + 1)).empty();
        }
        words.remove_prefix(end + 1);
    }
}

}  // namespace dumbbell
