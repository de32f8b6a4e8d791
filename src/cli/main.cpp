#include <fmt/format.h>
#include <gmp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "cli/campaign/command.hpp"
#include "cli/commands/adiabatic.hpp"
#include "cli/commands/audit.hpp"
#include "cli/commands/certify.hpp"
#include "cli/commands/critical.hpp"
#include "cli/commands/generate.hpp"
#include "cli/commands/law.hpp"
#include "cli/commands/plot.hpp"
#include "cli/commands/report.hpp"
#include "cli/commands/trace.hpp"
#include "cli/commands/verify.hpp"
#include "cli/pages/one_screen.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/usage_error.hpp"
#include "number/self_test.hpp"

namespace dumbbell {
namespace {

constexpr const char* description =
    R"(dumbbell proves how often a bouncing dumbbell can hit the floor.

Examples:
  dumbbell certify 10                        at most 4 collisions, and 4 occur
  dumbbell certify 1:100 --out stairs.dbc    every mass ratio from 1 to 100
  dumbbell verify stairs.dbc                 the independent verifier checks it again
  dumbbell report stairs.dbc --out report.html    a page to look at and play with
  dumbbell critical 3:20                     the mass ratios at which the maximum steps up
  dumbbell law stairs.dbc                    what the staircase says as a whole
  dumbbell trace 10 --phi 1/3 --phidot 1 --y 3 --ydot -1/2    the orbit of one initial condition
  dumbbell adiabatic --delta 0.01            the adiabatic invariant with its proved constant
  dumbbell plot staircase stairs.dbc --out stairs.svg
  dumbbell campaign --help                   what is too big for one run, on one machine or many)";

/// What the commands are for; --help lists them so.
constexpr const char* to_prove = "Prove";
constexpr const char* to_check = "Check";
constexpr const char* to_show = "Show";

std::string version_text() {
    return fmt::format("dumbbell {} ({}, {}, flags: {})", DUMBBELL_VERSION, DUMBBELL_COMPILER,
                       DUMBBELL_BUILD_TYPE, DUMBBELL_FLAGS);
}

/// Puts the commands that are in no group yet into this one.
void add_as(const char* group, CLI::App& app) {
    const std::string none = CLI::App().get_group();
    for (CLI::App* command : app.get_subcommands([&](const CLI::App* c) { return c->get_group() == none; })) {
        command->group(group);
    }
}

int parse_and_run(int argc, char** argv) {
    CLI::App app{description, "dumbbell"};
    app.formatter(std::make_shared<pages::OneScreen>());  // of its commands, too
    app.set_version_flag("-V,--version", version_text());
    app.set_help_all_flag("--help-all", "Help of all commands");
    app.require_subcommand(1);
    int exit_code = exit_done;
    add_certify_command(app, exit_code);
    add_critical_command(app, exit_code);
    add_trace_command(app, exit_code);
    add_adiabatic_command(app, exit_code);
    add_campaign_command(app, exit_code);
    add_as(to_prove, app);
    app.add_subcommand("verify",
                       "Check certificates again with the independent verifier (dumbbell verify --help).");
    add_audit_command(app, exit_code);
    add_law_command(app, exit_code);
    add_as(to_check, app);
    add_plot_command(app, exit_code);
    add_report_command(app, exit_code);
    add_as(to_show, app);
    add_generate_command(app);
    // Commands inherit the footer that is there when they are added, and have exit codes of their own.
    app.footer(
        "The fields of --json: docs/reference/json.md.\n\n"
        "Exit codes: 0 done; 1 internal error; 2 wrong usage or input; 3 not certified within the budget; "
        "130 or\n"
        "143 stopped by SIGINT (Ctrl-C) or SIGTERM.");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            return app.exit(error);  // --help, --version
        }
        throw InputError(usage_error(app, error, {argv + std::min(argc, 1), argv + argc}));
    }
    return exit_code;
}

/// GMP (and MPFR by it) would abort the program, and an exception must not pass through its C functions.
[[noreturn]] void out_of_memory() {
    std::fputs("dumbbell: out of memory\n", stderr);
    std::_Exit(exit_internal);
}

void* allocate(std::size_t size) {
    void* block = std::malloc(size);
    if (block == nullptr) {
        out_of_memory();
    }
    return block;
}

void* reallocate(void* old, std::size_t /*old_size*/, std::size_t size) {
    void* block = std::realloc(old, size);
    if (block == nullptr) {
        out_of_memory();
    }
    return block;
}

void release(void* block, std::size_t /*size*/) { std::free(block); }

/// As other programs understand them: `help COMMAND...`, `version`.
std::vector<char*> usual_words(int argc, char** argv) {
    static std::string help = "--help", version = "--version";
    std::vector<char*> words(argv, argv + argc);
    const std::string first = argc >= 2 ? argv[1] : "";
    if (first == "help") {
        words.erase(words.begin() + 1);
        words.push_back(help.data());
    } else if (first == "version") {
        words[1] = version.data();
    }
    words.push_back(nullptr);
    return words;
}

int run(int argc, char** argv) {
    mp_set_memory_functions(allocate, reallocate, release);
    require_sound_arithmetic();
    std::vector<char*> words = usual_words(argc, argv);
    if (argc >= 2 && std::string(words[1]) == "verify") {
        become_verifier(argc, words.data());
    }
    return parse_and_run(argc, words.data());
}

}  // namespace
}  // namespace dumbbell

int main(int argc, char** argv) {
    std::signal(SIGCHLD,
                SIG_DFL);  // ignored by whoever started this, there would be no exit code of a verifier
    int exit_code = dumbbell::exit_internal;
    try {
        exit_code = dumbbell::run(argc, argv);
    } catch (const dumbbell::InputError& error) {
        dumbbell::complain(error.what());
        return dumbbell::exit_bad_input;
    } catch (const std::bad_alloc&) {
        std::fputs("dumbbell: out of memory\n", stderr);
    } catch (const std::exception& error) {
        if (dumbbell::is_printed()) {  // else that is why: fmt::print throws
            dumbbell::complain(fmt::format("internal error: {}", error.what()));
        }
    }
    if (!dumbbell::is_printed()) {
        dumbbell::complain(dumbbell::not_printed);
        return dumbbell::exit_bad_input;
    }
    return exit_code;
}
