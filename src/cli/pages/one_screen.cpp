#include "cli/pages/one_screen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "cli/pages/command_table.hpp"

namespace dumbbell::pages {
namespace {

constexpr std::size_t most_examples = 4, columns = 98;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::vector<const CLI::App*> commands_in(const CLI::App& app, const std::string& group) {
    return app.get_subcommands([&](const CLI::App* c) { return c->get_group() == group; });
}

/// The groups that are shown, in the order of their first commands.
std::vector<std::string> groups_of(const CLI::App& app) {
    std::vector<std::string> groups;
    for (const CLI::App* command :
         app.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); })) {
        if (std::ranges::find(groups, command->get_group()) == groups.end()) {
            groups.push_back(command->get_group());
        }
    }
    return groups;
}

std::string commands_text(const CLI::App& app) {
    const auto groups = groups_of(app);
    std::string text;
    for (const std::string& group : groups) {
        text += (groups.size() > 1 ? group : "Commands") + ":\n";
        for (const CLI::App* command : commands_in(app, group)) {
            text += fmt::format("  {:<10} {}\n", command->get_name(), first_line(command->get_description()));
        }
    }
    return text;
}

std::string options_text(const CLI::App& app) {
    std::string text;
    for (const CLI::Option* option : app.get_options()) {
        text += (text.empty() ? "Options:\n  " : ", ") + option->get_name(false, true);
    }
    return text + '\n';
}

/// The first lines of the description that stand as they are.
std::string examples_text(const std::string& description) {
    std::string text = "Examples:\n";
    for (const Block& block : blocks(description)) {
        for (std::size_t i = 0; block.verbatim && i < std::min(block.lines.size(), most_examples); ++i) {
            text += "  " + block.lines[i] + '\n';
        }
    }
    return text;
}

/// Paragraphs in lines that are no wider than the screen.
std::string filled(const std::string& text) {
    std::string result;
    for (const Block& block : blocks(text)) {
        std::size_t used = 0;
        std::istringstream words(fmt::format("{}", fmt::join(block.lines, " ")));
        result += result.empty() ? "" : "\n";
        for (std::string word; words >> word; used += word.size() + 1) {
            if (used + word.size() > columns) {
                result.back() = '\n';
                used = 0;
            }
            result += word + ' ';
        }
        result.back() = '\n';
    }
    return result;
}

}  // namespace

std::string OneScreen::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
    if (mode != CLI::AppFormatMode::Normal || app->get_require_subcommand_min() == 0) {
        return HelpFormat::make_help(app, std::move(name), mode);
    }
    return fmt::format(
        "{}\n\nUsage: {} COMMAND [OPTIONS] ...\nMore:  {} COMMAND --help, and: man dumbbell\n\n{}{}{}\n{}",
        first_line(app->get_description()), name, name, commands_text(*app), options_text(*app),
        examples_text(app->get_description()), filled(app->get_footer()));
}

}  // namespace dumbbell::pages
