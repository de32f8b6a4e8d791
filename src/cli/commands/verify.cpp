#include "cli/commands/verify.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <utility>
#include <vector>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "collisions/section.hpp"
#include "file/limits.hpp"
#include "file/verifier_program.hpp"

namespace dumbbell::cli {

namespace {

constexpr const char* verify_description =
    R"(Check certificates again with the independent verifier.

It is a program of its own, dumbbell-verify, and gets all words of the command line. Its help has the options:
dumbbell verify --help, or man dumbbell-verify.

  dumbbell verify --ratio 10 --exactly 4 ten.dbc       is N*(10) = 4 proved?
  dumbbell verify --ratio 2:5/2 --max 3 stairs.dbc     at most 3 collisions on a part of the file's range?)";

constexpr const char* verify_footer =
    "Exit codes: 0 verified and proved; 1 rejected; 2 wrong usage or unreadable; 3 unsupported, or nothing "
    "is proved and no claim was stated; 4 resource limit.";

constexpr std::array verify_options{argument("FILE", "certificates").repeated()};

/// Its exit code is the verifier's. Returns only if it cannot be started: throws InputError.
[[noreturn]] void become_verifier(const std::vector<std::string>& words) {
    std::string program = verifier_path();
    std::vector<std::string> copies = words;
    std::vector<char*> arguments{program.data()};
    for (std::string& word : copies) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    ::execv(program.c_str(), arguments.data());
    verifier_not_started(program, errno);
}

/// The verdict on a file of which this is demanded.
std::string accepted(const std::string& file, const std::string& demand, Observer& observer) {
    observer.enter("verifying", "");
    std::optional<Verdict> verdict;
    (void)stoppable([&] {
        try {
            // A user who waits for it can stop it; a budget would only be in the way.
            verdict = ask_verifier({"--quiet", "--budget=99999h",
                                    fmt::format("--max-bits={}", most_file_bits), demand, "--", file});
        } catch (const NoVerdict&) {
            if (stop_signal == 0) {
                throw;
            }
        }
        return stop_signal == 0 ? int{exit_done}
                                : stopped("the file was not verified, so nothing is made of it");
    });
    if (stop_signal != 0) {  // the first process of a container, which does not end by a signal
        throw InputError(fmt::format("'{}' was not verified to the end", file));
    }
    if (!verdict->accepts) {
        throw InputError(fmt::format("'{}' is not verified: {}", file, verdict->line));
    }
    return std::move(verdict->line);
}

}  // namespace

constinit const Command verify_command{
    "verify", first_group, verify_description, verify_footer, verify_options, nullptr, {}, become_verifier};

std::string verified(const std::string& file, const std::string& sha256, const collisions::System& system,
                     Observer& observer) {
    std::string verdict = accepted(file, fmt::format("--scene={}", row_of(system.section).scene), observer);
    if (digest_in(verdict) != sha256) {
        throw InputError(fmt::format("'{}' was changed while it was read and verified: try again", file));
    }
    return verdict;
}

std::string verified_law(const std::string& file, Observer& observer) {
    return accepted(file, "--claim=law", observer);
}

}  // namespace dumbbell::cli
