#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

/// Enumerations as words: a table has a `Word` for each value.
namespace dumbbell {

template <class Value>
struct Word {
    Value value;
    std::string_view word;
};

/// Precondition: the value is in the table.
template <class Value, std::size_t n>
[[nodiscard]] constexpr std::string_view word_for(const std::array<Word<Value>, n>& table, Value value) {
    return std::ranges::find(table, value, &Word<Value>::value)->word;
}

/// Nothing for an unknown word.
template <class Value, std::size_t n>
[[nodiscard]] constexpr std::optional<Value> meaning_of(const std::array<Word<Value>, n>& table,
                                                        std::string_view word) {
    const auto* const found = std::ranges::find(table, word, &Word<Value>::word);
    return found == table.end() ? std::nullopt : std::optional(found->value);
}

}  // namespace dumbbell
