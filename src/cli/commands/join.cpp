#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <utility>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "cli/commands.hpp"
#include "cli/commands/join_parts.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/frame.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "file/verifier_program.hpp"
#include "number/parallel.hpp"
#include "number/ratio_argument.hpp"
#include "staircase/critical_table.hpp"
#include "words/printed.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* join_description =
    R"(Verify the parts of a range, and join them to one file.

The parts are certificates of dumbbell certify, in any order, or tables of dumbbell critical. Nothing is believed:
each certificate is verified by dumbbell-verify, each enclosure of a table by the signs at its two ends. They must be the
whole range, with no hole and nothing twice; pieces that the parts cut in two stay two. What is wrong, missing or open is
named, with the command that makes it again.

Examples:
  for k in 1 2 3 4; do dumbbell certify 1:1e4 --part $k/4 --out part-$k.dbc; done
  dumbbell join part-*.dbc --out stairs.dbc
  dumbbell join part-*.dbc --range 1:1e4 --gap 1e-6 --out stairs.dbc    also if the first or the last is missing
  dumbbell join part-*.tsv --out ratios.tsv                             tables of critical ratios)";

constexpr const char* join_footer =
    R"(The fields of --json: docs/reference/json.md.

Exit codes: 0 joined; 1 internal error; 2 wrong usage or input, or a part that is wrong or missing; 3 a part has
something open; 130 or 143 stopped by SIGINT (Ctrl-C) or SIGTERM. FILE is written with 0, and, with --open, with 3.)";

constexpr std::array join_options{
    argument("FILE", "the parts").required().repeated(),
    Option{"--out", "FILE", "write the whole to FILE (FILE.gz: compressed); -: the standard output"}
        .checked([](const std::string& name) { return fault_of_name(name, std::nullopt); })
        .required(),
    Option{"--range", "LO:HI",
           "what the parts must be together: mass ratios, or N1:N2 of tables; without it what they reach"},
    Option{"--gap", "REL", "the --gap of the parts, for the commands that make certificates again"},
    flag("--open", "write FILE though something in it is open"),
    jobs_option.saying("threads that verify"),
    json_option,
    flag("--quiet", "what is joined, in a sentence, and no progress")};

struct JoinReport {
    const Parts& parts;
    Range range;
    std::vector<PartFile> files;  ///< in the order of the range
    std::size_t pieces = 0, open = 0;
    std::string sentence;
    int jobs = 1;
    double seconds = 0;
    std::optional<std::string> out;
    std::optional<std::string> sha256;
};

std::string verdict(const JoinReport& report) {
    return fmt::format("{} verified, together {}.\n", plural(report.files.size(), "part"),
                       report.parts.words(report.range));
}

std::string to_text(const JoinReport& report) {
    return fmt::format(
        "{}{}{}", verdict(report), report.sentence,
        report.out ? fmt::format("Written: {} (sha256 {})\n", one_line(*report.out), *report.sha256) : "");
}

Json to_json(const JoinReport& report) {
    Json files = Json::array();
    for (const PartFile& file : report.files) {
        files.add(Json::object({{"file", file.name},
                                {"range", report.parts.range_json(*file.range)},
                                {"pieces", file.pieces},
                                {"open", file.open}}));
    }
    return Json::object({{"schema", "dumbbell-join-1"},
                         {"range", report.parts.range_json(report.range)},
                         {"parts", files},
                         {"pieces", report.pieces},
                         {"open", report.open},
                         {"jobs", report.jobs},
                         {"seconds", report.seconds},
                         {"out", report.out},
                         {"sha256", report.sha256}});
}

std::unique_ptr<Parts> parts_of(const Given& given) {
    const std::vector<std::string>& names = given.words("FILE");
    const auto table = std::ranges::find_if(names, staircase::is_critical_table);
    const auto other = std::ranges::find_if_not(names, staircase::is_critical_table);
    if (table != names.end() && other != names.end()) {
        throw InputError(fmt::format(
            "'{}' is a table of critical ratios, and '{}' is none: join one kind at a time", *table, *other));
    }
    if (given.has("--gap")) {
        (void)parse_gap(given.text("--gap"));
    }
    return table != names.end()
               ? table_parts(names.size())
               : certificate_parts(names.size(), given.has("--gap") ? given.text("--gap") : "REL");
}

/// All files, or, if the program is asked to stop, some.
std::vector<PartFile> taken(Parts& parts, const std::vector<std::string>& names, int jobs,
                            Verbosity verbosity) try {
    Progress progress("parts", verbosity, "verifying");
    std::vector<PartFile> files(names.size());
    std::atomic<std::size_t> done = 0;
    const auto threads_each = std::max<std::size_t>(1, static_cast<std::size_t>(jobs) / names.size());
    run_with_threads(jobs, Threads::all, [&] {
        in_parallel(names.size(), [&](std::size_t i) {
            if (stop_signal == 0) {
                files[i] = parts.take(i, names[i], static_cast<int>(threads_each), deadline(std::nullopt));
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

/// The options that all parts that are believed were made with. Throws InputError if they differ.
std::string common_options(const Parts& parts, const std::vector<PartFile>& files) {
    const PartFile* first = nullptr;
    for (const PartFile& file : files) {
        if (!file.fault.empty() || !file.options) {
            continue;
        }
        first = first == nullptr ? &file : first;
        if (file.options != first->options) {
            throw InputError(fmt::format("'{}' and '{}' are of different claims: {}, and {}", first->name,
                                         file.name, parts.command(*first->range, *first->options),
                                         parts.command(*file.range, *file.options)));
        }
    }
    return first == nullptr ? "" : *first->options;
}

/// By their ranges; without those whose range is not known.
std::vector<std::size_t> in_order(const std::vector<PartFile>& files) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (files[i].range) {
            order.push_back(i);
        }
    }
    std::ranges::stable_sort(
        order, {}, [&](std::size_t i) { return std::pair(files[i].range->begin, files[i].range->end); });
    return order;
}

/// Why the parts are not the whole, a line each.
std::vector<std::string> tiling_faults(const Parts& parts, const std::vector<PartFile>& files,
                                       const std::vector<std::size_t>& order, const Range& whole,
                                       const std::string& options) {
    std::vector<std::string> faults;
    const auto require_none = [&](const Rational& from, const Rational& to) {
        if (from < to) {
            faults.push_back(fmt::format("missing: {}; to make them: {} --out FILE", parts.words({from, to}),
                                         parts.command({from, to}, options)));
        }
    };
    Rational reached = whole.begin;
    const PartFile* last = nullptr;  // that reaches so far
    for (const std::size_t i : order) {
        const auto& [begin, end] = *files[i].range;
        require_none(reached, begin);
        if (begin < reached && last != nullptr) {
            faults.push_back(
                fmt::format("'{}' and '{}' overlap: leave one of them out", last->name, files[i].name));
        }
        if (begin < whole.begin || end > whole.end) {
            faults.push_back(
                fmt::format("'{}' ({}) reaches beyond --range", files[i].name, parts.words(*files[i].range)));
        }
        if (end >= reached) {
            reached = end;
            last = &files[i];
        }
    }
    require_none(reached, whole.end);
    return faults;
}

/// The line about a part, and how it is made again.
std::string with_command(const Parts& parts, const PartFile& file, const std::string& line) {
    return !file.range
               ? line
               : fmt::format("{}; to make it again: {} --out {}", line,
                             parts.command(*file.range, file.options.value_or("")), shell_file(file.name));
}

int run_join(const Given& given) {
    const std::vector<std::string>& names = given.words("FILE");
    const auto parts = parts_of(given);
    require_name_of(given.text("--out"), parts->content());
    std::optional<Range> whole;
    if (given.has("--range")) {
        whole = parts->parse_range(given.text("--range"));
    }
    const Output output(given.text("--out"), names, given.has("--json") ? "--json" : nullptr);
    const Stopwatch watch;
    const auto files = taken(*parts, names, jobs_of(given), verbosity_of(given));
    if (stop_signal != 0) {
        return stopped("nothing is joined");
    }
    std::vector<std::string> faults;
    for (const PartFile& file : files) {
        if (!file.fault.empty()) {
            faults.push_back(with_command(*parts, file, file.fault));
        }
    }
    const std::string options = common_options(*parts, files);
    const auto order = in_order(files);
    if (!order.empty()) {
        const auto end_of = [&](std::size_t i) { return files[i].range->end; };
        whole = whole.value_or(
            Range{files[order.front()].range->begin, end_of(std::ranges::max(order, {}, end_of))});
        std::ranges::move(tiling_faults(*parts, files, order, *whole, options), std::back_inserter(faults));
    }
    std::ranges::for_each(faults, complain);
    if (!faults.empty()) {
        return exit_bad_input;
    }

    JoinReport report{.parts = *parts,
                      .range = *whole,
                      .files = {},
                      .sentence = {},
                      .jobs = jobs_of(given),
                      .out = {},
                      .sha256 = {}};
    for (const std::size_t i : order) {
        const PartFile& file = report.files.emplace_back(files[i]);
        report.pieces += file.pieces;
        report.open += file.open;
        if (file.open > 0) {
            complain(with_command(
                *parts, file, fmt::format("'{}' leaves {} of {} open", file.name, file.open, file.pieces)));
        }
    }
    if (report.open > 0 && !given.has("--open")) {
        complain("nothing is written: to join what is open, too, add --open");
        return exit_not_certified;
    }
    const Joined joined = parts->join(order);
    report.sentence = joined.sentence;
    write(joined.text, output, report);
    report.seconds = watch.seconds();
    fmt::print(output.report(), "{}", shown(report, given));
    return report.open > 0 ? exit_not_certified : exit_done;
}

}  // namespace

constinit const Command join_command{"join",      "Prove",      join_description,
                                     join_footer, join_options, stoppable<run_join>};

}  // namespace dumbbell::cli
