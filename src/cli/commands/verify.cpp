#include "cli/commands/verify.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <utility>
#include <vector>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "file/shipped.hpp"
#include "file/verifier_program.hpp"
#include "law/certificate.hpp"

namespace dumbbell::cli {

namespace {

constexpr const char* verify_description =
    R"(Check certificates again with the independent verifier (dumbbell verify --help).

Checks certificates (docs/reference/format.md) independently of the program that wrote them.

  dumbbell-verify --ratio 10 --exactly 4 ten.dbc       is N*(10) = 4 proved?
  dumbbell-verify --ratio 2:5/2 --max 3 stairs.dbc     at most 3 collisions on a part of the file's range?
  dumbbell-verify --explain 1:bridge ten.dbc           one leaf, in numbers
  dumbbell-verify --claim initial-conditions --min 1 falling.dbc    at least one collision from every start?
  dumbbell-verify --law certificates/law.dbc.gz --ratio 1e6 --exactly 887 million.dbc    one mass ratio by the law
  dumbbell-verify --junit proofs.xml --claims certificates/claims.tsv   in CI: every certificate, its own claim
  dumbbell-verify --ratio 3 --max 3 *.dbc | tail -n 1               how many files prove this?
  dumbbell-verify --json --lemma 4.1 hybrid.dbc wedge.dbc           a comparison, for a script
  dumbbell-verify --scene wedge --ratio 1:100 --max 16 wedge.dbc    the paper's model wedge
  dumbbell-verify --budget 10m huge.dbc                a staircase up to 10^8
  dumbbell-verify --jobs 1 --precision 200 --max-bits 4096 ten.dbc  slowly, in multiple precision, on one thread
  dumbbell-verify --quiet --shards 1-90 stairs.dbc >> parts.txt     one part of a large certificate
  dumbbell-verify --combine parts.txt --ratio 3:9 --max 4 stairs.dbc    all of its parts, put together)";

constexpr const char* verify_footer =
    R"(FILE `-` is the standard input. Of one file the last line is its verdict: s VERIFIED, s REJECTED, s UNSUPPORTED,
s UNREADABLE or s LIMIT; instead of s VERIFIED with --shards s PART, with --combine s COMBINED. Of several, each has one
such line with its name, in the given order, and a line with the numbers ends them:
c files=3 verified=2 rejected=1 ...
Exit code: 0 verified and proved (with --shards: the part; with --combine: if its lines are true), 1 rejected, 2 usage
or unreadable, 3 unsupported, 4 resource limit; of several codes the first of 1, 4, 3, 2, 0.)";

constexpr std::array verify_options{
    Option{"--ratio", "RATIO|LO:HI", "the mass ratios (heavy/light) in question; else those of the file"},
    Option{"--max", "N", "demand the proof that no trajectory has more than N collisions"},
    Option{"--min", "N", "demand the proof that some trajectory has at least N collisions"},
    Option{"--exactly", "N", "both"},
    Option{"--scene", "dumbbell|hybrid|wedge", "demand this scene (dumbbell)"},
    Option{
        "--claim", "KIND",
        "demand this kind of claim: collisions, or collisions-by-law (one mass ratio, with --law), or "
        "initial-conditions (a file of `dumbbell trace "
        "--subdivide`: then --ratio, --max, --min, --exactly are about the starts in its box), or "
        "incoming (the same of all trajectories that come in, --incoming), or "
        "adiabatic-bounce, -run, -scattering, -printed (the adiabatic invariant), or law (all mass ratios): "
        "these without --ratio, --max, --min, --exactly, which they do not answer"},
    Option{
        "--claims", "LIST",
        "the certificates and claims of a list like certificates/claims.tsv, one each line: a file "
        "(its name is relative to the working folder), a tab, the six options above that state its "
        "claim, with --ratio and a bound, or --claim law alone; what stands after another tab is a remark"},
    Option{"--lemma", "4.1|4.2 A B",
           "compare two files: at most as many collisions in A (scene hybrid) as in B (wedge), or at most "
           "one more in A (dumbbell) than in B (hybrid)"},
    Option{
        "--law", "FILE",
        "the certificate of the law, on which files of the kind collisions-by-law rest by its SHA-256: it is "
        "verified first, once for all of them; `dumbbell verify` takes the shipped one by itself"},
    Option{"--shards", "I-J",
           "check only the pieces I to J (or I alone) of one file, counted from 1; the file is read as a "
           "whole. The last line is `s PART ...`, which is not a verdict of the file"},
    Option{"--combine", "PARTS",
           "check no piece, but take the lines `s PART` in the file PARTS, in any order: `s COMBINED` states "
           "the whole file, if they are about it and have every piece. That dumbbell-verify printed them is "
           "trusted, as it is of a log: run any part again that you doubt"},
    Option{"--jobs", "N", "threads (all cores)"},
    Option{"--budget", "TIME",
           "give up on a file that costs more work than a core does in this time, in about 30s, 10m or 2h "
           "(30s). Counted in steps, not by a clock: the same on every machine"},
    Option{"--max-bits", "B", "give up on pieces that need a higher precision (2048)"},
    Option{"--precision", "BITS", "check with at least this many bits instead of in double"},
    Option{"--explain", "PIECE:PATH",
           "show one leaf with its inequalities: 3:bridge is the root, 3:light.01 the upper half of its "
           "lower half, 3:witness the witness of the third piece; box.01 a leaf of a file about initial "
           "conditions or the adiabatic invariant, in which class0.01 is a leaf of the first class and "
           "attained1 the first attained state; layer.01, bulk1.17 and end.17 boxes of a file about the "
           "law; upper and lower the bounds of one by the law"},
    flag("--shares",
         "of one file about initial conditions: how likely each number of collisions is, bounds of its share "
         "of the box, from the leaves that were checked"),
    flag("--json",
         "print JSON and nothing else: an array of one object for each file; with --lemma one object"),
    Option{"--junit", "FILE.xml", "write a JUnit report, too: one test case for each file"},
    flag("--quiet", "print the last line only, and show no progress"),
    flag("-h,--help,-V,--version", "print that and nothing else"),
    argument("FILE", "certificates").repeated()};

/// With the shipped certificate of the law, unless one is named, or none is there.
std::vector<std::string> with_law(std::vector<std::string> words) try {
    const auto names_law = [](const std::string& word) {
        return word == "--law" || word.starts_with("--law=");
    };
    if (std::ranges::none_of(words, names_law)) {
        words.insert(words.begin(), "--law=" + shipped_certificate(law::certificate_name));
    }
    return words;
} catch (const InputError&) {
    return words;
}

/// Its exit code is the verifier's. Returns only if it cannot be started: throws InputError.
[[noreturn]] void become_verifier(const std::vector<std::string>& words) {
    std::string program = verifier_path();
    std::vector<std::string> copies = with_law(words);
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
            verdict = ask_verifier({"--quiet", "--budget=99999h", "--max-bits=4096", demand, "--", file});
        } catch (const NoVerdict&) {
            if (stop_signal == 0) {
                throw;
            }
        }
        return stop_signal == 0 ? int{exit_done} : stopped("nothing is made of what was not verified");
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

constinit const Command verify_command{"verify", "Check", verify_description, verify_footer, verify_options,
                                       nullptr,  {},      become_verifier};

std::string verified(const std::string& file, const std::string& sha256, std::string_view scene,
                     Observer& observer) {
    std::string verdict = accepted(file, "--scene=" + std::string(scene), observer);
    if (digest_in(verdict) != sha256) {
        throw InputError(fmt::format("'{}' was changed while it was read and verified: try again", file));
    }
    return verdict;
}

std::string verified_law(const std::string& file, Observer& observer) {
    return accepted(file, "--claim=law", observer);
}

}  // namespace dumbbell::cli
