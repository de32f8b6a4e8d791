#include <fmt/core.h>

#include "base/printable.hpp"
#include "cli/pages/command_table.hpp"
#include "cli/pages/pages.hpp"

namespace dumbbell::cli::pages {
namespace {

/// Text as Markdown prints it unchanged.
std::string markdown(std::string_view text) {
    return respelled(
        text,
        {{'*', "\\*"}, {'_', "\\_"}, {'<', "\\<"}, {'|', "\\|"}, {'[', "\\["}, {'\\', "\\\\"}, {'`', "\\`"}});
}

void add_markdown(std::string& page, std::string_view text) {
    for (const Block& block : blocks(text)) {
        page += "\n";
        for (const std::string& line : block.lines) {
            page += block.verbatim ? "    " + line + "\n" : markdown(line) + "\n";
        }
    }
}

void add_markdown_command(std::string& page, const Place& place) {
    for (const Section& section : sections(place)) {
        page += section.topic.empty() ? fmt::format("\n## {}\n\n    {}\n", place.name, section.heading)
                                      : fmt::format("\n### {}\n", section.heading);
        add_markdown(page, section.text);
        page += section.options.empty() ? "" : "\n| | |\n| --- | --- |\n";
        for (const Option& option : section.options) {
            // In a table a bar must be escaped, even in code.
            page += fmt::format("| `{}` | {} |\n", respelled(spelling(option), {{'|', "\\|"}}),
                                markdown(meaning(option)));
        }
        add_markdown(page, section.footer);
    }
}

}  // namespace

std::string reference(const Command& program) {
    const auto all = places(program);
    std::string page =
        "# Commands, options, exit codes\n\n"
        "Made from the table that parses the command line, by `dumbbell generate reference`; a test "
        "compares.\n"
        "Every command has a `--help`, too.\n\n";
    for (const Place& place : all) {
        page += fmt::format("- [{}](#{})\n", place.name, respelled(place.name, {{' ', "-"}}));
    }
    for (const Place& place : all) {
        add_markdown_command(page, place);
    }
    return page;
}

}  // namespace dumbbell::cli::pages
