#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <utility>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/commands/join_faults.hpp"
#include "cli/terminal/common.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "file/verifier_program.hpp"
#include "number/decimal.hpp"
#include "number/parallel.hpp"
#include "number/ratio_argument.hpp"
#include "words/printed.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* join_description =
    R"(Verify the parts of a range, and join them into one file.

The parts are certificates of dumbbell certify, in any order. Nothing is believed: dumbbell-verify verifies each. The
parts must make the whole --range, with no hole and no overlap. Pieces that the parts cut in two stay two. What is
wrong, missing or open is named, with the command that makes it again.

Examples:
  for k in 1 2 3 4; do dumbbell certify 1:1e4 --part $k/4 --out part-$k.dbc; done
  dumbbell join part-*.dbc --range 1:1e4 --out stairs.dbc)";

constexpr const char* join_footer =
    R"(Exit codes: 0 joined; 1 internal error; 2 wrong usage or input, or a part that is wrong or missing; 3 a part has
something open; 130 or 143 stopped by SIGINT (Ctrl-C) or SIGTERM. FILE is written with 0, and, with --open, with 3.)";

constexpr std::array join_options{
    argument("FILE", "the parts").required().repeated(),
    Option{"--out", "FILE", "write the whole to FILE (FILE.gz: compressed); -: the standard output"}
        .checked(fault_of_name<Content::certificate>)
        .required(),
    Option{"--range", "LO:HI", "what the parts must make together: mass ratios, or Q of bodies"}.required(),
    Option{"--gap", "REL",
           "the --gap of the parts, for the commands that make them again; default: their widest"},
    flag("--open", "write FILE even if something in it is open"),
    jobs_option.saying("threads that verify"),
    json_option,
    flag("--quiet", "no progress")};

Parts parts_of(const Given& given) {
    const std::vector<std::string>& names = given.words("FILE");
    if (std::ranges::find(names, "-") != names.end()) {
        throw InputError(
            "join reads its parts again and again, so none can be -, the standard input; a file of "
            "that name is ./-");
    }
    return {names.size(), given.has("--gap") ? std::optional(parse_gap(given.text("--gap"))) : std::nullopt};
}

/// All files, or, if the program is asked to stop, some.
std::vector<PartFile> taken(Parts& parts, const std::vector<std::string>& names, int jobs,
                            Verbosity verbosity) try {
    Progress progress("parts", verbosity, "verifying");
    std::vector<PartFile> files(names.size());
    std::atomic<std::size_t> done = 0;
    const auto threads_each = std::max<std::size_t>(1, static_cast<std::size_t>(jobs) / names.size());
    run_with_threads(jobs, [&] {
        in_parallel(names.size(), [&](std::size_t i) {
            if (stop_signal == 0) {
                files[i] = parts.take(i, names[i], static_cast<int>(threads_each));
                progress.update(++done, names.size(), std::nullopt);
            }
        });
    });
    return files;
} catch (const NoVerdict&) {
    if (stop_signal == 0) {
        throw;
    }
    return {};
}

/// By their ranges; those without one first.
void sort(std::vector<PartFile>& files) {
    std::ranges::stable_sort(files, {}, [](const PartFile& file) {
        return file.range ? std::pair(file.range->lo, file.range->hi) : std::pair<Rational, Rational>();
    });
}

Json to_json(const std::vector<PartFile>& files) {
    Json json = Json::array();
    for (const PartFile& file : files) {
        json.add(Json::object({{"file", file.name},
                               {"first", exact_text(file.range->lo)},
                               {"last", exact_text(file.range->hi)},
                               {"pieces", file.pieces},
                               {"open", file.open}}));
    }
    return json;
}

int run_join(const Given& given) {
    const std::vector<std::string>& names = given.words("FILE");
    Parts parts = parts_of(given);
    const collisions::Range whole = parse_range(given.text("--range"), names.front());
    const Output output(given.text("--out"), names, given.has("--json") ? "--json" : nullptr);
    auto files = taken(parts, names, jobs_of(given), verbosity_of(given));
    if (stop_signal != 0) {
        return stopped("nothing is joined");
    }
    sort(files);
    const auto faults = faults_of(parts, files, whole);
    std::ranges::for_each(faults, complain);
    if (!faults.empty()) {
        return exit_bad_input;
    }
    std::size_t open = 0;
    for (const PartFile& file : files) {
        open += file.open;
        if (file.open > 0) {
            complain(with_command(
                parts, file, fmt::format("'{}' leaves {} of {} open", file.name, file.open, file.pieces)));
        }
    }
    if (open > 0 && !given.has("--open")) {
        complain("nothing is written: to join what is open, too, add --open");
        return exit_not_certified;
    }
    const SealedText text = parts.join(files);
    output.commit(text.text);
    fmt::print(output.report(), "{}",
               given.has("--json")
                   ? json_text(Json::object({{"schema", "dumbbell-join-1"},
                                             {"first", exact_text(whole.lo)},
                                             {"last", exact_text(whole.hi)},
                                             {"parts", to_json(files)},
                                             {"open", open},
                                             {"out", output.file()},
                                             {"sha256", text.sha256}}))
                   : fmt::format("{} verified, together {}: sha256 {}\n", plural(files.size(), "part"),
                                 parts.words(whole), text.sha256));
    return open > 0 ? exit_not_certified : exit_done;
}

}  // namespace

constinit const Command join_command{"join",      more_group,   join_description,
                                     join_footer, join_options, stoppable<run_join>};

}  // namespace dumbbell::cli
