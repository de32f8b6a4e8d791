#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "base/error.hpp"
#include "cli/pages/command_table.hpp"
#include "cli/pages/pages.hpp"

namespace dumbbell::cli::pages {
namespace {

constexpr std::size_t indent = 30, columns = 120;
constexpr std::size_t most_examples = 4, screen_columns = 98;

/// The words, each line with `first` in front, later ones with as many blanks.
std::string filled(const std::string& text, const std::string& first, std::size_t width) {
    std::string result = first;
    const std::string blanks(first.size(), ' ');
    std::size_t used = first.size();
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const bool begins = used == blanks.size();
        if (!begins && used + 1 + word.size() > width) {
            result += '\n' + blanks;
            used = blanks.size();
        } else if (!begins) {
            result += ' ';
            ++used;
        }
        result += word;
        used += word.size();
    }
    return result + '\n';
}

/// A name and what it means, which begins in its own line if the name is long.
std::string row(const std::string& name, const std::string& text) {
    const std::string first = "  " + name;
    const bool fits = first.size() + 2 <= indent;
    return (fits ? "" : first + '\n') +
           filled(text, fits ? fmt::format("{:<{}}", first, indent) : std::string(indent, ' '), columns);
}

std::string rows(const char* heading, const std::vector<Option>& options) {
    std::string text = options.empty() ? "" : fmt::format("\n{}:\n", heading);
    for (const Option& option : options) {
        text += row(spelling(option), meaning(option));
    }
    return text;
}

std::string whole(const Place& place, std::string_view topic) {
    const auto all = sections(place);
    const auto section = std::ranges::find(all, topic, &Section::topic);
    if (section == all.end()) {
        throw InputError(fmt::format("there is no help about '{}'; see {} --help", topic, place.name));
    }
    std::vector<Option> arguments, options{help_option};
    for (const Option& option : section->options) {
        (option.is_argument() ? arguments : options).push_back(option);
    }
    const std::string topics = place.command->topic_names(" | ");
    return fmt::format("{}\n\nUsage: {}\n{}{}{}\n{}\n", section->text, usage(place),
                       rows("Arguments", arguments), rows("Options", options),
                       topics.empty() ? "" : fmt::format("\nMore: {} --help {}\n", place.name, topics),
                       place.footer);
}

std::string commands_text(const Command& command) {
    std::string text;
    std::string_view group;
    for (const Command* below : command.commands) {
        if (below->group.empty()) {
            continue;
        }
        if (below->group != group) {
            group = below->group;
            text += fmt::format("{}:\n", group);
        }
        text += fmt::format("  {:<10} {}\n", below->name, brief(*below));
    }
    return text;
}

/// The first lines of the description that stand as they are.
std::string examples_text(std::string_view description) {
    std::string text = "Examples:\n";
    for (const Block& block : blocks(description)) {
        for (std::size_t i = 0; block.verbatim && i < std::min(block.lines.size(), most_examples); ++i) {
            text += "  " + block.lines[i] + '\n';
        }
    }
    return text;
}

std::string one_screen(const Place& place) {
    std::string options = fmt::format("Options:\n  {}", help_option.name), footer;
    for (const Option& option : place.command->options) {
        options += fmt::format(", {}", option.name);
    }
    for (const Block& block : blocks(place.footer)) {
        footer += '\n' + filled(fmt::format("{}", fmt::join(block.lines, " ")), "", screen_columns);
    }
    return fmt::format("{}\n\nUsage: {}\nHelp:  {} COMMAND --help, and: man dumbbell\n\n{}{}\n{}{}",
                       brief(*place.command), usage(place), place.name, commands_text(*place.command),
                       options, examples_text(description(*place.command)), footer);
}

}  // namespace

std::string help(const Command& program, const Command& command, std::string_view topic) {
    const auto all = places(program, true);
    const Place& place = *std::ranges::find(all, &command, &Place::command);
    return is_called(command) ? whole(place, topic) : one_screen(place);
}

}  // namespace dumbbell::cli::pages
