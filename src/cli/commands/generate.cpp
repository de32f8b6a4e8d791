#include "cli/commands/generate.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>

#include "cli/pages/bash_completion.hpp"
#include "cli/pages/command_table.hpp"
#include "cli/pages/man_page.hpp"
#include "cli/pages/reference.hpp"
#include "file/verifier_program.hpp"

namespace dumbbell {
namespace {

constexpr const char* description =
    R"(Print what is made from the table of commands and options: man page, bash completion, or docs/reference/commands.md.

Example: source <(dumbbell generate completion))";

/// The commands as they are, with the verifier's options, which the program does not know.
pages::CommandEntry whole_table(const CLI::App& app) {
    pages::CommandEntry program = pages::command_table(app);
    const auto verify = std::find_if(program.commands.begin(), program.commands.end(),
                                     [](const auto& c) { return pages::last_word(c.name) == "verify"; });
    *verify = pages::verifier_table(verify->name, verifier_help());
    return program;
}

}  // namespace

void add_generate_command(CLI::App& app) {
    auto what = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("generate", description);
    command->group("");  // for whoever makes a package: --help does not show it
    command->footer("Exit codes: 0 done; 1 internal error; 2 wrong usage.");
    command->add_option("WHAT", *what, "man, completion or reference")
        ->required()
        ->check(CLI::IsMember({"man", "completion", "reference"}));
    command->callback([what, &app] {
        const pages::CommandEntry program = whole_table(app);
        fmt::print("{}", *what == "man"          ? pages::man_page(program)
                         : *what == "completion" ? pages::bash_completion(program)
                                                 : pages::reference(program));
    });
}

}  // namespace dumbbell
