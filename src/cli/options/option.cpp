#include "cli/options/option.hpp"

#include <algorithm>
#include <sstream>

namespace dumbbell::cli {

std::vector<std::string> Option::names() const { return split(name, ','); }

std::vector<std::string> Option::choices() const {
    const std::string_view word = value.substr(0, value.find(' '));
    const bool is_name = std::ranges::any_of(word, [](char c) { return 'A' <= c && c <= 'Z'; });
    return is_name || word.find('|') == word.npos ? std::vector<std::string>{} : split(word, '|');
}

const Command* Command::below(std::string_view wanted) const {
    const auto found = std::ranges::find(commands, wanted, &Command::name);
    return found == commands.end() ? nullptr : *found;
}

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    std::istringstream in{std::string(text)};
    for (std::string part; std::getline(in, part, separator);) {
        parts.push_back(part);
    }
    return parts;
}

}  // namespace dumbbell::cli
