#include "cli/options/parse.hpp"

#include <CLI/CLI.hpp>

#include "base/error.hpp"
#include "cli/options/usage_error.hpp"
#include "cli/pages/pages.hpp"

namespace dumbbell::cli {
namespace {

/// CLI11 takes a word [A,B] of an argument that is repeated for two words, A and B, and a number like -.5 for
/// options; behind a mark it does not.
constexpr char mark = '\x01';

bool needs_mark(std::string_view word) {
    return word.starts_with('[') || word.starts_with(mark) || word.starts_with("-.") ||
           word.starts_with("-inf") || word.starts_with("-nan");
}

/// The last one first, as CLI11 wants them.
std::vector<std::string> marked(const std::vector<std::string>& words) {
    std::vector<std::string> result(words.rbegin(), words.rend());
    for (std::string& word : result) {
        if (needs_mark(word)) {
            word.insert(0, 1, mark);
        }
    }
    return result;
}

std::vector<std::string> unmarked(std::vector<std::string> words) {
    for (std::string& word : words) {
        word.erase(0, word.starts_with(mark) ? 1 : 0);
    }
    return words;
}

/// CLI11 takes --json=false, too.
bool is_on(const CLI::Option& flag) {
    bool on = false;
    return flag.count() > 0 && CLI::detail::lexical_cast(flag.results().back(), on) && on;
}

std::string fault_of_flag(const std::string& value) {
    bool on = false;
    return CLI::detail::lexical_cast(value, on) ? "" : "it takes no value";
}

void add_options(CLI::App& app, const Command& command) {
    for (const Option& option : command.options) {
        const std::string name(option.name);
        if (option.is_flag()) {
            app.add_flag(name)->check(fault_of_flag);
            continue;
        }
        CLI::Option* added = app.add_option(name)->required(option.is_required);
        added->check(
            [&option](const std::string& value) { return fault_of(option, unmarked({value}).front()); });
        if (option.is_repeated) {
            added->expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args();
        }
    }
}

void add_commands(CLI::App& app, const Command& command) {
    app.require_subcommand(0, 1);
    for (const Command* below : command.commands) {
        CLI::App& added = *app.add_subcommand(std::string(below->name));
        if (below->become == nullptr) {
            add_options(added, *below);
        }
        add_commands(added, *below);
    }
}

/// What was understood so far.
void collect(const CLI::App& app, const Command& command, CommandLine& line) {
    line.command = &command;
    for (const CLI::App* called : app.get_subcommands()) {
        const Command& below = *command.below(called->get_name());
        for (std::size_t i = 0; below.become == nullptr && i < below.options.size(); ++i) {
            const Option& option = below.options[i];
            const CLI::Option& parsed = *called->get_option(std::string(option.name));
            line.given.add(
                option, option.is_flag() && !is_on(parsed) ? CLI::results_t{} : unmarked(parsed.results()));
        }
        collect(*called, below, line);
    }
}

std::string wrong(const CLI::ParseError& error, const CLI::App& app, const CommandLine& line,
                  const std::vector<std::string>& words) {
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
        return unexpected(unmarked(app.remaining(true)));
    }
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
        return mismatch(line.given, words.back());
    }
    return error.what();
}

}  // namespace

CommandLine parse(const Command& program, const std::string& version, const std::vector<std::string>& words) {
    CLI::App app("", std::string(program.name));
    app.set_help_flag(std::string(help_option.name));
    app.set_version_flag(std::string(version_option.name), version);
    add_commands(app, program);
    CommandLine line;
    std::string fault;
    try {
        app.parse(marked(words));
        collect(app, program, line);
        fault = contradiction(line.given);
    } catch (const CLI::CallForVersion&) {
        line.answer = version + "\n";
    } catch (const CLI::CallForHelp&) {
        collect(app, program, line);
        fault = wrong_command(program, words, true);
        const std::string& last = words.back();  // the command that was asked about, or a topic of it
        const bool is_topic = !last.starts_with('-') && last != line.command->name;
        line.answer = pages::help(program, *line.command, is_topic ? last : "");
    } catch (const CLI::ParseError& error) {
        collect(app, program, line);
        fault = wrong(error, app, line, words);
    }
    if (line.answer.empty() && line.command->run == nullptr) {
        fault = wrong_command(program, words, false);
    }
    if (!fault.empty()) {
        throw InputError(fault + "; " + hint(program, words));
    }
    return line;
}

}  // namespace dumbbell::cli
