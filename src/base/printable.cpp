#include "base/printable.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace dumbbell {
namespace {

bool is_tail(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// How many bytes the first character has, if it is UTF-8 of two bytes or more and no control character;
/// else 0. Overlong forms and surrogates, which only terminals of another encoding would show, pass.
std::size_t wide(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    const std::size_t n = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
    if (n == 0 || text.size() < n || !std::all_of(text.begin() + 1, text.begin() + n, is_tail)) {
        return 0;
    }
    const bool is_c1 = first == 0xc2 && static_cast<unsigned char>(text[1]) < 0xa0;
    return is_c1 ? 0 : n;
}

/// All characters as they are, but for each byte that must not reach a terminal what `replace` makes of it.
template <class Replace>
std::string cleaned(std::string_view text, const Replace& replace) {
    std::string result;
    while (!text.empty()) {
        const bool plain = text[0] >= ' ' && text[0] <= '~';
        const std::size_t n = plain ? 1 : wide(text);
        result += n == 0 ? replace(text[0]) : std::string(text.substr(0, n));
        text.remove_prefix(std::max<std::size_t>(n, 1));
    }
    return result;
}

std::string shell_quoted(std::string_view word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:=@%+,-";
    if (!word.empty() && word.find_first_not_of(plain) == std::string_view::npos) {
        return std::string(word);
    }
    const bool shows = one_line(word) == word;
    const std::string escaped =
        shows ? respelled(word, {{'\'', "'\\''"}}) : respelled(word, {{'\'', "\\'"}, {'\\', "\\\\"}});
    if (shows) {
        return "'" + escaped + "'";
    }
    const auto octal = [](char c) { return fmt::format("\\{:03o}", static_cast<unsigned char>(c)); };
    return "$'" + cleaned(escaped, octal) + "'";
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
    std::string line(text.substr(0, most));
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return line + (text.size() > most ? "..." : "");
}

std::string one_line(std::string_view name) {
    return cleaned(name, [](char /*hidden*/) { return std::string("?"); });
}

std::string shell_file(const std::string& name) {
    return shell_quoted(name.size() > 1 && name[0] == '-' ? "./" + name : name);
}

std::string respelled(std::string_view text,
                      std::initializer_list<std::pair<char, std::string_view>> spellings) {
    std::string result;
    for (const char& c : text) {
        const auto* const found = std::ranges::find(spellings, c, &std::pair<char, std::string_view>::first);
        result += found == spellings.end() ? std::string_view(&c, 1) : found->second;
    }
    return result;
}

}  // namespace dumbbell
