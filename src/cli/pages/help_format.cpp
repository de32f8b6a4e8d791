#include "cli/pages/help_format.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

#include "cli/pages/command_table.hpp"

namespace dumbbell::pages {
namespace {

constexpr std::size_t indent = 30, columns = 120;

}  // namespace

HelpFormat::HelpFormat() {
    label("Positionals", "Arguments");
    label("SUBCOMMAND", "COMMAND");
}

std::string HelpFormat::make_option(const CLI::Option* option, bool /*is_argument*/) const {
    const OptionEntry entry = option_entry(*option);
    std::string text = "  " + spelling(entry);
    std::size_t used = text.size();
    const auto new_line = [&] {
        text += '\n' + std::string(indent, ' ');
        used = indent;
    };
    if (used + 2 > indent) {
        new_line();
    } else {
        text.resize(indent, ' ');
        used = indent;
    }
    std::istringstream words(meaning(entry));
    for (std::string word; words >> word;) {
        if (used > indent && used + 1 + word.size() > columns) {
            new_line();
        }
        text += (used > indent ? " " : "") + word;
        used += (used > indent ? 1 : 0) + word.size();
    }
    return text + '\n';
}

}  // namespace dumbbell::pages
