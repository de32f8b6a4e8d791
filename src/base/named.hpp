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

}  // namespace dumbbell
