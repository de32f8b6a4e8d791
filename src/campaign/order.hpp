#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "file/sealed_lines.hpp"

namespace dumbbell::campaign {

/// What is to be proved in one go, in words: complete, so that the result depends on nothing else, and with a
/// checksum, so that half of it is recognized. `head` says what all of a campaign has in common, line by
/// line (the first is `prove KIND`); a unit, one line, is the least that can be proved by itself.
struct Order {
    std::string head;
    std::vector<std::string> units;

    /// Canonical: equal orders have the same text.
    [[nodiscard]] std::string text() const;
    /// 32 hexadecimal digits of the text's SHA-256.
    [[nodiscard]] std::string id() const;
    /// KIND of the head's first line.
    [[nodiscard]] std::string kind() const;

    friend bool operator==(const Order&, const Order&) = default;
};

/// The values of the head's lines: what follows these words, which the lines begin with, in this order.
/// Throws InputError if the lines are others.
[[nodiscard]] std::vector<std::string> head_values(const Order& order,
                                                   std::initializer_list<std::string_view> words);

/// Head and units as lines, which a plan has, too.
void write_order(SealedLines& out, const Order& order);
[[nodiscard]] Order read_order(SealedReader& in);

/// Throws InputError if this is no whole order, or one of another version of the program.
[[nodiscard]] Order parse_order(const std::string& text);

}  // namespace dumbbell::campaign
