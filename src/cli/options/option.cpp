#include "cli/options/option.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/fields.hpp"

namespace dumbbell::cli {

std::vector<std::string> Option::names() const {
    const auto parts = split(name, ',');
    return {parts.begin(), parts.end()};
}

std::vector<std::string> Option::choices() const {
    const std::string_view word = value.substr(0, value.find(' '));
    const bool is_name = std::ranges::any_of(word, [](char c) { return 'A' <= c && c <= 'Z'; });
    const auto parts = split(word, '|');
    return is_name || parts.size() == 1 ? std::vector<std::string>{}
                                        : std::vector<std::string>(parts.begin(), parts.end());
}

const Command* Command::below(std::string_view wanted) const {
    const auto found = std::ranges::find(commands, wanted, &Command::name);
    return found == commands.end() ? nullptr : *found;
}

std::vector<std::string> Command::command_names() const {
    std::vector<std::string> all;
    for (const Command* below : commands) {
        if (!below->group.empty()) {
            all.emplace_back(below->name);
        }
    }
    return all;
}

std::vector<std::string> Command::option_names() const {
    std::vector<std::string> all{"--help"};
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
