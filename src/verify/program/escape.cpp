#include "verify/program/escape.hpp"

#include <cstdio>

namespace dumbbell_verify {
namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd";  // U+FFFD

/// How many bytes the first character has; 0 if it is not well-formed UTF-8, or U+FFFE or U+FFFF.
std::size_t length(std::string_view text) {
    const auto byte = [&](std::size_t i) -> unsigned {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
    };
    const unsigned a = byte(0), b = byte(1);
    const std::size_t n = a < 0x80 ? 1 : a < 0xc2 ? 0 : a < 0xe0 ? 2 : a < 0xf0 ? 3 : a < 0xf5 ? 4 : 0;
    for (std::size_t i = 1; i < n; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    const bool overlong = (a == 0xe0 && b < 0xa0) || (a == 0xf0 && b < 0x90);
    const bool surrogate = a == 0xed && b >= 0xa0, beyond = a == 0xf4 && b >= 0x90;
    const bool no_character = a == 0xef && b == 0xbf && byte(2) >= 0xbe;
    return overlong || surrogate || beyond || no_character ? 0 : n;
}

/// C0, DEL, or C1, which terminals obey too.
bool is_control(std::string_view character) {
    const auto last = static_cast<unsigned char>(character.back());
    return character.size() == 1 ? last < 0x20 || last == 0x7f : character[0] == '\xc2' && last < 0xa0;
}

/// All characters, each as `write` writes it.
template <class Write>
std::string transcribed(std::string_view text, const Write& write) {
    std::string result;
    while (!text.empty()) {
        const std::size_t n = length(text);
        result += n == 0 ? replacement : write(text.substr(0, n));
        text.remove_prefix(n == 0 ? 1 : n);
    }
    return result;
}

}  // namespace

std::string one_line(std::string_view text) {
    return transcribed(text, [](std::string_view character) {
        return is_control(character) ? std::string_view("?") : character;
    });
}

std::string leading_name(std::string_view name) {
    return (name.starts_with("s ") || name.starts_with("c ") ? "./" : "") + one_line(name);
}

std::string json_string(std::string_view text) {
    const auto write = [](std::string_view character) -> std::string {
        const char c = character[0];
        if (!is_control(character) && c != '"' && c != '\\') return std::string(character);
        char code[8];
        std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned char>(character.back()));
        return code;
    };
    return '"' + transcribed(text, write) + '"';
}

}  // namespace dumbbell_verify
