#include "cli/pages/reference.hpp"

#include <fmt/format.h>

#include <iterator>

namespace dumbbell::pages {
namespace {

/// Text as Markdown prints it unchanged.
std::string plain(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '*' || c == '_' || c == '<' || c == '|' || c == '[' || c == '\\' || c == '`') {
            result += '\\';
        }
        result += c;
    }
    return result;
}

/// In a table a bar must be escaped, even in code.
std::string code_in_table(const std::string& text) {
    std::string result = "`";
    for (const char c : text) {
        result += c == '|' ? "\\|" : std::string(1, c);
    }
    return result + "`";
}

std::string anchor(std::string name) {
    for (char& c : name) {
        c = c == ' ' ? '-' : c;
    }
    return name;
}

void add_text(std::string& page, const std::string& description) {
    for (const Block& block : blocks(description)) {
        page += "\n";
        for (const std::string& line : block.lines) {
            page += block.verbatim ? "    " + line + "\n" : plain(line) + "\n";
        }
    }
}

void add_command(std::string& page, const CommandEntry& command) {
    fmt::format_to(std::back_inserter(page), "\n## {}\n\n    {}\n", command.name, usage(command));
    add_text(page, command.description);
    if (!command.options.empty()) {
        page += "\n| | |\n| --- | --- |\n";
        for (const OptionEntry& option : command.options) {
            fmt::format_to(std::back_inserter(page), "| {} | {} |\n", code_in_table(spelling(option)),
                           plain(meaning(option)));
        }
    }
    add_text(page, command.footer);
}

}  // namespace

std::string reference(const CommandEntry& program) {
    std::string page =
        "# Commands, options, exit codes\n\n"
        "Made from the table that parses the command line, by `dumbbell generate reference`; a test "
        "compares.\n"
        "Every command has a `--help`, too.\n\n";
    for (const CommandEntry* command : with_all_below(program)) {
        fmt::format_to(std::back_inserter(page), "- [{}](#{})\n", command->name, anchor(command->name));
    }
    for (const CommandEntry* command : with_all_below(program)) {
        add_command(page, *command);
    }
    return page;
}

}  // namespace dumbbell::pages
