#include "cli/options/option.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace dumbbell::cli {

std::vector<std::string_view> Option::choices() const {
    const std::string_view word = value.substr(0, value.find(' '));
    const bool is_name = std::ranges::any_of(word, [](char c) { return 'A' <= c && c <= 'Z'; });
    return is_name || word.find('|') == std::string_view::npos ? std::vector<std::string_view>{}
                                                               : split(word, '|');
}

const Command* Command::below(std::string_view wanted) const {
    const auto found = std::ranges::find(commands, wanted, &Command::name);
    return found == commands.end() ? nullptr : *found;
}

std::vector<std::string_view> Command::command_names() const {
    std::vector<std::string_view> all;
    for (const Command* below : commands) {
        if (!below->group.empty()) {
            all.emplace_back(below->name);
        }
    }
    return all;
}

std::vector<std::string_view> Command::option_names() const {
    std::vector<std::string_view> all{"--help"};
    for (const Option& option : options) {
        if (!option.is_argument()) {
            std::ranges::copy(option.names(), std::back_inserter(all));
        }
    }
    return all;
}

std::string Command::topic_names(const char* between) const {
    std::vector<std::string_view> names;
    std::ranges::transform(topics, std::back_inserter(names), &Topic::name);
    return fmt::format("{}", fmt::join(names, between));
}

}  // namespace dumbbell::cli
