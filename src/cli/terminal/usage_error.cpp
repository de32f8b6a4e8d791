#include "cli/terminal/usage_error.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <regex>

#include "cli/terminal/hint.hpp"

namespace dumbbell {
namespace {

std::string in_quotes(const std::vector<std::string>& words) {
    return fmt::format("'{}'", fmt::join(words, "', '"));
}

/// The command of this name, a hidden one too, or null.
const CLI::App* command_below(const CLI::App& app, const std::string& name) {
    const auto found = app.get_subcommands([&](const CLI::App* c) { return c->get_name() == name; });
    return found.empty() ? nullptr : found.front();
}

/// Where a command should stand: what stands there instead, or which there are.
std::string missing_command(const CLI::App& app, const std::vector<std::string>& words) {
    const CLI::App* command = &app;
    std::string called;  // empty: the program itself
    for (const std::string& word : words) {
        if (const CLI::App* below = command_below(*command, word)) {
            command = below;
            called += (called.empty() ? "" : " ") + word;
        } else if (!word.starts_with('-')) {
            return called.empty() ? fmt::format("there is no command '{}'", word)
                                  : fmt::format("{} has no command '{}'", called, word);
        } else if (command->get_option_no_throw(word) == nullptr) {
            return called.empty() ? fmt::format("there is no option '{}'", word)
                                  : fmt::format("{} has no option '{}'", called, word);
        }
    }
    return fmt::format("{} needs a command: {}", called.empty() ? app.get_name() : called,
                       fmt::join(names_of_commands(*command), ", "));
}

std::string unexpected(const CLI::App& app) {
    const auto rest = app.remaining(true);
    return rest.size() == 1 && rest[0].size() > 1 && rest[0][0] == '-'
               ? fmt::format("there is no option '{}' here", rest[0])
               : fmt::format("not expected here: {}", in_quotes(rest));
}

/// CLI11's sentences that name its own notions.
std::string reworded(const std::string& text) {
    static const std::array<std::pair<std::regex, const char*>, 5> plain{
        {{std::regex(R"((--\S+|\S+): At Most 1 required but received (\d+))"),
          "$1 is given $2 times: give it once"},
         {std::regex(R"((--\S+): 1 required ([\s\S]*) missing)"), "$1 needs a value"},
         {std::regex(R"(Could not convert: (\S+) = ([\s\S]*))"), "$1: '$2' is not a whole number"},
         {std::regex(R"((--\S+) excludes (--\S+))"), "$1 and $2 exclude each other"},
         {std::regex(R"((\S+): Value ([\s\S]*) not in range (\S+) to (\S+))"),
          "$1: $2 is not from $3 to $4"}}};
    for (const auto& [pattern, words] : plain) {
        if (std::regex_match(text, pattern)) {
            return std::regex_replace(text, pattern, words);
        }
    }
    return text;
}

}  // namespace

std::string usage_error(const CLI::App& app, const CLI::ParseError& error,
                        const std::vector<std::string>& words) {
    const std::string text = error.what();
    const bool is_unknown =
        !words.empty() && !words[0].starts_with('-') && command_below(app, words[0]) == nullptr;
    const bool lacks_command = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError) &&
                               text.find("subcommand") != std::string::npos;
    const bool has_extras = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
    return fmt::format("{}; {}",
                       is_unknown || lacks_command ? missing_command(app, words)
                       : has_extras                ? unexpected(app)
                                                   : reworded(text),
                       hint(app, words));
}

}  // namespace dumbbell
