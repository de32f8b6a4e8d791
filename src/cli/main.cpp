#include <fcntl.h>
#include <fmt/core.h>
#include <gmp.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/options/parse.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/messages.hpp"
#include "number/flint.hpp"
#include "number/sound_arithmetic.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* program_description =
    R"(dumbbell proves how often a bouncing dumbbell can hit the floor.

Examples:
  dumbbell certify 10                        at most 4 collisions, and 4 occur
  dumbbell certify 1:100 --out stairs.dbc    every mass ratio from 1 to 100
  dumbbell verify stairs.dbc                 the independent verifier checks it again
  dumbbell report stairs.dbc --out report.html    a page to look at and play with
  dumbbell critical 3:20                     the mass ratios at which the maximum steps up
  dumbbell law                               what is proved of every mass ratio
  dumbbell trace 10 --phi 1/3 --phidot 1 --y 3 --ydot -1/2    the orbit of one initial condition
  dumbbell adiabatic --delta 0.01            the adiabatic invariant with its proved constant
  dumbbell plot staircase stairs.dbc --out stairs.svg)";

constexpr const char* program_footer =
    "The fields of --json: docs/reference/json.md.\n\n"
    "Exit codes: 0 done; 1 internal error; 2 wrong usage or input; 3 not certified within the budget; 130 "
    "or\n"
    "143 stopped by SIGINT (Ctrl-C) or SIGTERM.";

constexpr std::array program_options{version_option};

constexpr std::array program_commands{
    &certify_command, &verify_command, &critical_command, &report_command,    &trace_command,   &law_command,
    &join_command,    &audit_command,  &plot_command,     &adiabatic_command, &generate_command};

std::string version_text() {
    return fmt::format("dumbbell {} ({}, {}, licence: {}, flags: {})", DUMBBELL_VERSION, DUMBBELL_COMPILER,
                       DUMBBELL_BUILD_TYPE, DUMBBELL_LICENCE, DUMBBELL_FLAGS);
}

/// GMP (and MPFR by it) and FLINT (and Arb by it) would abort the program, and an exception must not pass
/// through their C functions.
void* usable(void* block) {
    if (block == nullptr) {
        std::fputs("dumbbell: out of memory\n", stderr);
        std::_Exit(exit_internal);
    }
    return block;
}

void* allocate(std::size_t size) { return usable(std::malloc(size)); }

void* allocate_zeros(std::size_t number, std::size_t size) { return usable(std::calloc(number, size)); }

void* reallocate(void* old, std::size_t /*old_size*/, std::size_t size) {
    return usable(std::realloc(old, size));
}

void* reallocate_block(void* old, std::size_t size) { return reallocate(old, 0, size); }

void release(void* block, std::size_t /*size*/) { std::free(block); }

/// The next file that is opened gets the number of a standard stream that is closed, and what is said there
/// would be written into it. Nothing can be read from, or written to, what stands there instead.
void occupy_closed_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) < 0) {
            (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
}

/// With the words that other programs understand: `help COMMAND... TOPIC`, `version`.
std::vector<std::string> usual_words(std::vector<std::string> words) {
    if (!words.empty() && words[0] == "help") {
        words[0] = "--help";
        std::swap(words.front(), words[std::min<std::size_t>(1, words.size() - 1)]);
    } else if (!words.empty() && words[0] == "version") {
        words[0] = "--version";
    }
    return words;
}

int run_program(const std::vector<std::string>& words) {
    mp_set_memory_functions(allocate, reallocate, release);
    __flint_set_memory_functions(allocate, allocate_zeros, reallocate_block, std::free);
    const SoundArithmetic sound;
    const Command* first = words.empty() ? nullptr : dumbbell_command.below(words[0]);
    if (first != nullptr && first->become != nullptr) {
        first->become({words.begin() + 1, words.end()});
    }
    const CommandLine line = parse(dumbbell_command, version_text(), words);
    if (!line.answer.empty()) {
        fmt::print("{}", line.answer);
        return exit_done;
    }
    return line.command->run(line.given);
}

}  // namespace

constinit const Command dumbbell_command{"dumbbell",      "",      program_description, program_footer,
                                         program_options, nullptr, program_commands};

}  // namespace dumbbell::cli

int main(int argc, char** argv) {
    dumbbell::cli::occupy_closed_streams();
    std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow any more is like a full disk
    // Where the program that started this one ignores it, there would be no exit code of a verifier.
    std::signal(SIGCHLD, SIG_DFL);
    int exit_code = dumbbell::cli::exit_internal;
    try {
        exit_code =
            dumbbell::cli::run_program(dumbbell::cli::usual_words({argv + std::min(argc, 1), argv + argc}));
    } catch (const dumbbell::InputError& error) {
        dumbbell::cli::complain(error.what());
        return dumbbell::cli::exit_bad_input;
    } catch (const std::filesystem::filesystem_error& error) {
        dumbbell::cli::complain(
            fmt::format("cannot use '{}': {}", error.path1().string(), error.code().message()));
        return dumbbell::cli::exit_bad_input;
    } catch (const std::bad_alloc&) {
        std::fputs("dumbbell: out of memory\n", stderr);
    } catch (const std::exception& error) {
        if (dumbbell::cli::is_printed()) {  // else that is why: fmt::print throws
            dumbbell::cli::complain(fmt::format("internal error: {}", error.what()));
        }
    }
    if (!dumbbell::cli::is_printed()) {
        dumbbell::cli::complain(dumbbell::cli::not_printed);
        return dumbbell::cli::exit_bad_input;
    }
    return exit_code;
}
