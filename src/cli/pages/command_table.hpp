#pragma once

#include <string>
#include <vector>

#include "cli/options/option.hpp"

/// What help, man page and reference say of a command and of an option, in the same words.
namespace dumbbell::cli::pages {

/// A command where it stands in the table.
struct Place {
    const Command* command;
    std::string name;  ///< dumbbell plot staircase
    std::string_view footer;
};

/// The program and all that is below it, each command before its own; those that are hidden only if wanted.
[[nodiscard]] std::vector<Place> places(const Command& program, bool with_hidden = false);

/// What is said under one heading: of a command, but for its topics; then of each topic.
struct Section {
    std::string_view topic;  ///< empty: none
    std::string heading;     ///< how the command is called, or how its help about the topic
    std::string text;
    std::string_view footer{};
    std::vector<Option> options{};
};
[[nodiscard]] std::vector<Section> sections(const Place& place);

/// Whether it does something itself, and not only by the commands below it.
[[nodiscard]] bool is_called(const Command& command);

/// How it is called: the name, [OPTIONS] and the arguments, or COMMAND; in brackets what may be left out.
[[nodiscard]] std::string usage(const Place& place);

/// The option as it is typed: `--out FILE`.
[[nodiscard]] std::string spelling(const Option& option);

/// What it means, with what it needs to be known: its range, required, the value without it.
[[nodiscard]] std::string meaning(const Option& option);

/// A part of a description: lines that are one paragraph, or lines that stand as they are.
struct Block {
    std::vector<std::string> lines;
    bool verbatim = false;
};
[[nodiscard]] std::vector<Block> blocks(std::string_view text);

/// Without examples of commands that this build does not have.
[[nodiscard]] std::string description(const Command& command);

/// The first line.
[[nodiscard]] std::string brief(const Command& command);

}  // namespace dumbbell::cli::pages
