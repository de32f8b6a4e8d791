#include "cli/commands/adiabatic.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

#include "adiabatic/branch.hpp"
#include "adiabatic/prove.hpp"
#include "adiabatic/report.hpp"
#include "adiabatic/writer.hpp"
#include "base/deadline.hpp"
#include "base/error.hpp"
#include "cli/claims/adiabatic.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/jobs_option.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/out_option.hpp"
#include "cli/terminal/progress.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "number/ratio_argument.hpp"
#include "words/json_number.hpp"

namespace dumbbell {
namespace {

constexpr const char* description =
    R"(Prove the constants of the adiabatic invariant of a light mass that spins fast.

The invariant is I = |phidot| (pi - arccos y), the light mass beta1 = epsilon = delta^2, and |phidot| = 1 and -delta <= ydot <= 0 before the first collision that counts.

  lemma3.1  one bounce and the next, at distance m delta^k from the vertical, k = 1/2: the errors of |phidot_+| and y_+
  cor3.2    the same with other exponents: --k
  thm3.3    |I_n - I_0| <= C delta while only the light mass bounces, at distance u_* from the vertical or more
  thm3.5    |I_N - I_0| <= C sqrt(delta) for a whole scattering whose first and last collision are at distance
            c sqrt(delta) or more; and an orbit that shows why the last one must be restricted too
  printed   that orbit alone: |I_N - I_0| is not small, under the hypotheses as they are printed

C is proved for all initial conditions, by a cover of theirs; it is compared with what one enclosed orbit attains. For
thm3.3 C holds for any number of bounces; --bounces limits the attained orbit only.

Examples:
  dumbbell adiabatic --delta 0.01                               Theorem 3.3 with its constant
  dumbbell adiabatic --delta 0:0.01                             for all delta up to 0.01
  dumbbell adiabatic --delta 0.01 --phi-margin 0.2,0.3,0.5      a table over the distance from the vertical
  dumbbell adiabatic --delta 0.01 --theorem cor3.2 --k 1/4
  dumbbell adiabatic --delta 0.01 --theorem thm3.5 --out scattering.dbc)";

constexpr const char* footer =
    R"(The fields of --json: docs/reference/json.md.

Exit codes: 0 certified; 1 internal error; 2 wrong usage or input; 3 not certified within the budget; 130 or 143
stopped by SIGINT (Ctrl-C) or SIGTERM: nothing is kept.)";

struct Options {
    AdiabaticWords claim;
    std::optional<std::string> bounces, budget;
    std::string out;
    int jobs = all_cores();
    bool json = false;
    bool quiet = false;
};

/// K/delta, of the attained orbit of a run.
long most_collisions(const Options& options, const AdiabaticHypotheses& of) {
    constexpr long most = 1'000'000;
    if (options.bounces && of.claim != AdiabaticClaim::run) {
        throw InputError("--bounces is for --theorem thm3.3 only");
    }
    const Rational factor = parse_number("--bounces", options.bounces.value_or("1"));
    if (factor <= 0) {
        throw InputError("--bounces must be greater than 0: orbits of n <= K/delta bounces are looked at");
    }
    if (!options.bounces || of.delta.first == 0) {
        return most;
    }
    const Rational number = factor / of.delta.first;
    return number >= most ? most : static_cast<long>(number.convert_to<double>());
}

void write_certificate(AdiabaticReport& report, const Output& output) {
    SealedText text = render(certificate_of(report.results.front().proof));
    output.commit(text.text);
    report.out = output.file();
    report.sha256 = std::move(text.sha256);
}

AdiabaticResult proved(const AdiabaticRequest& request) {
    const auto start = std::chrono::steady_clock::now();
    AdiabaticResult result;
    result.proof = prove_adiabatic(request);
    if (request.of.claim == AdiabaticClaim::scattering) {
        AdiabaticRequest printed = request;
        printed.of.claim = AdiabaticClaim::printed;
        result.as_printed = prove_adiabatic(printed);
    }
    if (request.of.claim == AdiabaticClaim::bounce) {
        for (const AdiabaticState& state : result.proof.attained) {
            result.wrong_branch = std::max(result.wrong_branch.value_or(0), printed_branch_error(state));
        }
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

int run(const Options& options) {
    const auto wanted = statements_of(options.claim, Deltas::one);
    AdiabaticReport report{options.claim.theorem, accuracy_of(options.claim), {}, {}, {}};
    if (!options.out.empty() && wanted.size() > 1) {
        throw InputError(
            "--out takes one statement: give one distance (--phi-margin) and one exponent (--k)");
    }
    const Output output(options.out, {}, options.json ? "--json" : nullptr);
    const Interrupted interrupted =
        deadline(options.budget ? std::optional(parse_duration(*options.budget)) : std::nullopt);
    bool complete = true;
    {
        constexpr const char* search = "looking for an orbit with a great error";
        Progress progress("boxes", options.quiet ? Loudness::quiet : Loudness::normal, search);
        for (const AdiabaticHypotheses& of : wanted) {
            AdiabaticRequest request;
            request.of = of;
            request.accuracy = report.accuracy;
            request.most_collisions = most_collisions(options, of);
            request.jobs = options.jobs;
            request.interrupted = interrupted;
            request.judged = [&](std::size_t more) {
                progress.enter("covering all of them", "boxes");
                progress.advance(more);
            };
            progress.enter(search);
            report.results.push_back(proved(request));
            complete = complete && report.results.back().proof.complete();
        }
    }
    if (output.is_wanted() && complete) {
        write_certificate(report, output);
    }
    fmt::print(output.report(), "{}",
               options.json    ? json_text(to_json(report))
               : options.quiet ? verdict(report)
                               : to_text(report));
    if (complete) {
        return exit_done;
    }
    const bool stopped = stop_signal != 0;
    complain(fmt::format("{}{}",
                         stopped ? stopped_by() + ": not certified"
                         : interrupted()
                             ? "not certified: the budget is used up"
                             : "not certified: take a smaller delta (or range of them), a greater "
                               "--phi-margin or a higher --y",
                         options.out.empty() ? "" : "; no certificate is written"));
    return stopped ? exit_stopped : exit_not_certified;
}

}  // namespace

void add_adiabatic_command(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("adiabatic", description);
    command->footer(footer);
    add_adiabatic_options(*command, options->claim, Deltas::one);
    command
        ->add_option("--bounces", options->bounces,
                     "thm3.3: look for the attained orbit with at most K/delta bounces (the bound holds for "
                     "any number)")
        ->type_name("K");
    command->add_option("--budget", options->budget, "stop after this time: 30s, 10m, 2h")->type_name("TIME");
    add_jobs_option(*command, options->jobs);
    add_out_option(*command, options->out, {Content::certificate});
    command->add_flag("--json", options->json, "one JSON object on stdout");
    command->add_flag("--quiet", options->quiet, "the constants alone, a line each, and no progress");
    command->callback([options, &exit_code] { exit_code = stoppable([&] { return run(*options); }); });
}

}  // namespace dumbbell
