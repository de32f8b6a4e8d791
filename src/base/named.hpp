#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

/// The names of an enumeration: a table has a `Named` for each value.
namespace dumbbell {

template <class Value>
struct Named {
    Value value;
    std::string_view name;
};

/// Precondition: the value is in the table.
template <class Value, std::size_t n>
[[nodiscard]] constexpr std::string_view name_in(const std::array<Named<Value>, n>& table, Value value) {
    return std::ranges::find(table, value, &Named<Value>::value)->name;
}

/// Nothing for an unknown name.
template <class Value, std::size_t n>
[[nodiscard]] constexpr std::optional<Value> value_named(const std::array<Named<Value>, n>& table,
                                                         std::string_view name) {
    const auto* const found = std::ranges::find(table, name, &Named<Value>::name);
    return found == table.end() ? std::nullopt : std::optional(found->value);
}

}  // namespace dumbbell
