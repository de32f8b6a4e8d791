#include "cli/commands/critical.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <tuple>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/jobs_option.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/out_option.hpp"
#include "cli/terminal/progress.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "number/count_argument.hpp"
#include "number/decimal.hpp"
#include "number/ratio_argument.hpp"
#include "staircase/critical_range.hpp"
#include "staircase/critical_report.hpp"
#include "words/json_number.hpp"

namespace dumbbell {
namespace {

struct Options {
    std::string counts;
    std::optional<std::string> confirm;
    std::optional<std::string> budget;
    std::string out;
    int digits = CriticalRequest{}.digits;
    int jobs = all_cores();
    bool json = false;
    bool quiet = false;
};

constexpr const char* description =
    R"(Compute critical mass ratios, where the greatest number steps from N-1 to N.

Every digit printed is proved. The enclosures rest on theorem 2 of proofs/theorem.md; --confirm checks both sides
without it.

Examples:
  dumbbell critical 4                                    q_c(4) = 4.60333884875170...
  dumbbell critical 4 --digits 100                       more of its digits
  dumbbell critical 3:20                                 the first 18 steps
  dumbbell critical 12 --confirm 1e-9                    cover and witness at q_c(12) (1 -+ 1e-9)
  dumbbell critical 3:902 --digits 50 --out ratios.tsv   a table as a file)";

constexpr const char* footer =
    R"(The fields of --json: docs/reference/json.md.

Exit codes: 0 proved; 1 internal error; 2 wrong usage or input; 3 not finished or not confirmed (within the budget); 130
or 143 stopped by SIGINT (Ctrl-C) or SIGTERM: nothing is kept.)";

/// Without --budget nothing longer is begun.
constexpr std::chrono::duration<double> long_time = std::chrono::hours(1);
/// What takes longer is announced.
constexpr std::chrono::duration<double> some_time = std::chrono::minutes(1);

Rational parse_distance(const std::string& text, long n) {
    const Rational distance = parse_number("--confirm", text);
    // Neighbouring critical ratios are about 2/n apart, relatively.
    const Rational most = std::min(Rational(1, 100), Rational(Integer(1), Integer(n)));
    if (distance <= 0 || distance > most || digits_to_confirm(distance) > most_critical_digits) {
        throw InputError(
            fmt::format("--confirm {} is out of range: a relative distance from 1e-190 to {}, so that no "
                        "other step is near",
                        text, to_decimal(exact(cut_down(most, 2)), 2)));
    }
    return distance;
}

std::string time_text(std::chrono::duration<double> time) {
    const double hours = time / std::chrono::hours(1);
    if (hours < 2) {
        return fmt::format("{:.0f} minutes", std::ceil(60 * hours));
    }
    if (hours < 48) {
        return fmt::format("{:.1f} hours", hours);
    }
    const double years = hours / (24 * 365.25);
    return years < 2 ? fmt::format("{:.0f} days", hours / 24) : fmt::format("{:.3g} years", years);
}

/// Says how long it will take, if long. Throws InputError if it would take very long and no budget is given.
void check_time(const CriticalRequest& request, bool quiet) {
    if (request.budget) {
        return;
    }
    const auto time = estimated_time(request);
    if (time > long_time) {
        throw InputError(
            fmt::format("this would take about {} ({} thread{}): ask for less, or give a --budget, for "
                        "example --budget 2h",
                        time_text(time), request.jobs, request.jobs == 1 ? "" : "s"));
    }
    if (time > some_time && !quiet) {
        remark("this will take about " + time_text(time));
    }
}

std::vector<CriticalRow> enclose(CriticalRequest request, Loudness loudness) {
    const bool one = request.first == request.last;
    Progress progress(one ? "flights" : "critical ratios", loudness, "enclosing");
    if (one) {
        request.advanced = [&](long flights) { progress.advance(static_cast<std::size_t>(flights)); };
    } else {
        request.progress = [&](std::size_t done, std::size_t total, long n) {
            progress.update(done, total, n);
        };
    }
    return critical_ratios(request);
}

CriticalRequest request_of(const Options& options) {
    CriticalRequest request;
    std::tie(request.first, request.last) = parse_counts(options.counts);
    request.digits = options.digits;
    request.jobs = options.jobs;
    if (options.budget) {
        request.budget = parse_duration(*options.budget);
    }
    if (options.confirm) {
        request.confirm = parse_distance(*options.confirm, request.last);
    }
    check_time(request, options.quiet);
    return request;
}

int run(const Options& options) {
    CriticalReport report{.request = request_of(options), .rows = {}, .seconds = 0, .out = {}};
    const Output output(options.out, {}, options.json ? "--json" : nullptr);
    const auto start = std::chrono::steady_clock::now();
    report.rows = enclose(report.request, options.quiet ? Loudness::quiet : Loudness::normal);
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const auto finished = std::count_if(report.rows.begin(), report.rows.end(),
                                        [&](const CriticalRow& row) { return row.finished(report.request); });
    const bool all = finished == std::ssize(report.rows);
    if (!all && stop_signal != 0) {
        complain(fmt::format(
            "{}: nothing is kept{}", stopped_by(),
            finished == 0
                ? ""
                : fmt::format(" of the {} critical ratios that were finished (of {}): with --budget "
                              "TIME what is finished in time is printed",
                              finished, report.rows.size())));
        return exit_stopped;
    }
    if (output.is_wanted()) {
        report.out = output.file();
        output.commit(to_tsv(report));
    }
    fmt::print(output.report(), "{}",
               options.json    ? json_text(to_json(report))
               : options.quiet ? verdict(report)
                               : to_text(report));
    if (!all) {
        complain(fmt::format("not everything was {} (--budget)",
                             options.confirm ? "confirmed: allow more time, or a greater distance"
                                             : "enclosed: allow more time"));
    }
    return all ? exit_done : exit_not_certified;
}

}  // namespace

void add_critical_command(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("critical", description);
    command->footer(footer);
    command->add_option("N", options->counts, "number of collisions from 3 on, or closed range N1:N2")
        ->required();
    command->add_option("--digits", options->digits, "significant digits, all of them proved")
        ->check(CLI::Range(1, most_critical_digits))
        ->capture_default_str();
    command
        ->add_option("--confirm", options->confirm,
                     "prove the maximum at q_c (1 - REL) and q_c (1 + REL) by cover and witness, too")
        ->type_name("REL");
    add_out_option(*command, options->out, {Content::table},
                   "write the table to FILE, tab-separated (FILE.gz: compressed)");
    add_jobs_option(*command, options->jobs);
    command->add_option("--budget", options->budget, "stop after this time: 30s, 10m, 2h")->type_name("TIME");
    command->add_flag("--json", options->json, "one JSON object on stdout");
    command->add_flag("--quiet", options->quiet, "the ratios alone, a line each, and no progress");
    command->callback([options, &exit_code] { exit_code = stoppable([&] { return run(*options); }); });
}

}  // namespace dumbbell
