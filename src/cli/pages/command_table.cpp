#include "cli/pages/command_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/fields.hpp"

namespace dumbbell::cli::pages {
namespace {

void collect(const Place& place, bool with_hidden, std::vector<Place>& all) {
    all.push_back(place);
    for (const Command* below : place.command->commands) {
        if (with_hidden || !below->group.empty()) {
            const bool inherits = below->footer.empty() && place.command != all.front().command;
            collect({below, fmt::format("{} {}", place.name, below->name),
                     inherits ? place.footer : below->footer},
                    with_hidden, all);
        }
    }
}

}  // namespace

std::vector<Place> places(const Command& program, bool with_hidden) {
    std::vector<Place> all;
    const std::string name(program.name);
    collect({&program, name, program.footer}, with_hidden, all);
    return all;
}

bool is_called(const Command& command) { return command.run != nullptr || command.become != nullptr; }

std::string usage(const Place& place) {
    if (!is_called(*place.command)) {
        return place.name + " COMMAND [OPTIONS] ...";
    }
    std::string text = place.name + " [OPTIONS]";
    for (const Option& option : place.command->options) {
        if (option.is_argument()) {
            text += option.is_required ? " " + spelling(option) : fmt::format(" [{}]", spelling(option));
        }
    }
    return text;
}

std::vector<Section> sections(const Place& place) {
    const Command& command = *place.command;
    std::vector<Section> all{{"", usage(place), description(command), place.footer}};
    for (const Topic& topic : command.topics) {
        all.push_back({topic.name, fmt::format("{} --help {}", place.name, topic.name),
                       fmt::format("{}\n\n{}", topic.text, topic.examples)});
    }
    for (Section& section : all) {
        std::ranges::copy_if(command.options, std::back_inserter(section.options),
                             [&](const Option& option) { return option.topic == section.topic; });
    }
    return all;
}

std::string spelling(const Option& option) {
    return fmt::format(
        "{}{}{}{}", fmt::join(option.names(), ", "), option.is_argument() && option.is_repeated ? "..." : "",
        option.is_argument() || option.is_flag() ? "" : " ", option.is_argument() ? "" : option.value);
}

std::string meaning(const Option& option) {
    std::string text(option.text);
    text += option.least < option.most ? fmt::format(" ({} to {})", option.least, option.most) : "";
    text += option.is_required && !option.is_argument() ? "; required" : "";
    text += option.standard.empty() ? "" : fmt::format("; default: {}", option.standard);
    return text;
}

std::vector<Block> blocks(std::string_view text) {
    std::vector<Block> result;
    bool fresh = true;
    for (const std::string_view line : split(text, '\n')) {
        const bool verbatim = line.starts_with("  ");
        if (!line.empty()) {
            if (fresh || result.back().verbatim != verbatim) {
                result.push_back({{}, verbatim});
            }
            result.back().lines.emplace_back(verbatim ? line.substr(2) : line);
        }
        fresh = line.empty();
    }
    return result;
}

std::string description(const Command& command) {
    std::string text;
    for (const std::string_view line : split(command.text, '\n')) {
        const auto words = split(line, ' ');  // of an example: two empty ones, dumbbell, certify
        const bool is_example = words.size() > 3 && words[0].empty() && words[2] == command.name;
        const Command* shown = is_example ? command.below(words[3]) : nullptr;
        if (shown == nullptr || !shown->group.empty()) {
            text += fmt::format("{}{}", text.empty() ? "" : "\n", line);
        }
    }
    return text;
}

std::string brief(const Command& command) {
    return std::string(command.text.substr(0, command.text.find('\n')));
}

}  // namespace dumbbell::cli::pages
