#include <fmt/core.h>

#include <algorithm>

#include "adiabatic/prove.hpp"
#include "adiabatic/report.hpp"
#include "adiabatic/writer.hpp"
#include "base/deadline.hpp"
#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/terminal/common.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "commands/statements.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* adiabatic_description =
    R"(Prove the constants of the adiabatic invariant of a light mass that spins fast.

The invariant is I = |phidot| (pi - arccos y), the light mass beta1 = epsilon = delta^2, and |phidot| = 1 and
-delta <= ydot <= 0 before the first collision that counts.

  lemma3.1  one bounce and the next, at distance m delta^k from the vertical, k = 1/2: the errors of |phidot_+| and y_+
  cor3.2    the same with other exponents: --k
  thm3.3    |I_n - I_0| <= C delta while only the light mass bounces, at distance u_* from the vertical or more
  thm3.5    |I_N - I_0| <= C sqrt(delta) for a whole scattering whose first and last collision are at distance
            c sqrt(delta) or more

C is proved for all initial conditions, by a cover, and compared with what one enclosed orbit attains. For
thm3.3 C holds for any number of bounces; --bounces limits the attained orbit only.

Examples:
  dumbbell adiabatic --delta 0.01                               Theorem 3.3 with its constant
  dumbbell adiabatic --delta 0:0.01                             for all delta up to 0.01
  dumbbell adiabatic --delta 0.01 --phi-margin 0.2,0.3,0.5      a table over the distance from the vertical
  dumbbell adiabatic --delta 0.01 --theorem cor3.2 --k 1/4
  dumbbell adiabatic --delta 0.01 --theorem thm3.5 --out scattering.dbc)";

constexpr const char* adiabatic_footer =
    R"(Exit codes: 0 certified; 1 internal error; 2 wrong usage or input; 3 not certified within the budget; 130 or 143
stopped by SIGINT (Ctrl-C) or SIGTERM: nothing is kept.)";

constexpr std::array adiabatic_options =
    joined(statement_options,
           std::array{Option{"--bounces", "K",
                             "thm3.3: look for the attained orbit with at most K/delta bounces (the bound "
                             "holds for any number)"},
                      budget_option, jobs_option, certificate_option, json_option,
                      flag("--quiet", "the constants alone, a line each, and no progress")});

/// K/delta, of the attained orbit of a run.
long most_collisions(const Given& given, const adiabatic::Hypotheses& of) {
    constexpr long most = 1'000'000;
    if (given.has("--bounces") && of.claim != adiabatic::Claim::run) {
        throw InputError("--bounces is for --theorem thm3.3 only");
    }
    const Rational factor =
        given.has("--bounces") ? parse_number("--bounces", given.text("--bounces")) : Rational(1);
    if (factor <= 0) {
        throw InputError("--bounces must be greater than 0: orbits of n <= K/delta bounces are looked at");
    }
    if (!given.has("--bounces") || of.delta.first == 0) {
        return most;
    }
    const Rational number = factor / of.delta.first;
    return number >= most ? most : static_cast<long>(number.convert_to<double>());
}

void prove_statements(const std::vector<adiabatic::Hypotheses>& wanted, const Given& given,
                      const Interrupted& interrupted, adiabatic::Report& report) {
    constexpr const char* search = "looking for an orbit with a great error";
    Progress progress("boxes", verbosity_of(given), search);
    for (const adiabatic::Hypotheses& of : wanted) {
        adiabatic::Request request;
        request.of = of;
        request.accuracy = report.accuracy;
        request.most_collisions = most_collisions(given, of);
        request.jobs = jobs_of(given);
        request.interrupted = interrupted;
        request.observer = &progress;
        progress.enter(search, "");
        const Stopwatch watch;
        adiabatic::Result& result = report.results.emplace_back();
        result.proof = adiabatic::prove(request);
        result.seconds = watch.seconds();
    }
}

int run_adiabatic(const Given& given) {
    const auto wanted = statements_of(given);
    adiabatic::Report report{given.text("--theorem"), accuracy_of(given), {}, {}, {}};
    if (given.has("--out") && wanted.size() > 1) {
        throw InputError(
            "--out takes one statement: give one distance (--phi-margin) and one exponent (--k)");
    }
    const Output output(given.text("--out"), {}, given.has("--json") ? "--json" : nullptr);
    const Interrupted interrupted = deadline(budget_of(given));
    prove_statements(wanted, given, interrupted, report);
    const bool complete = std::ranges::all_of(
        report.results, [](const adiabatic::Result& result) { return result.proof.complete(); });
    if (output.is_wanted() && complete) {
        write(render(report.results.front().proof), output, report);
    }
    fmt::print(output.report(), "{}", shown(report, given));
    if (complete) {
        return exit_done;
    }
    const char* nothing = output.is_wanted() ? "; no certificate is written" : "";
    if (stop_signal != 0) {
        return stopped(std::string("not certified") + nothing);
    }
    complain(fmt::format("not certified: {}{}",
                         interrupted()
                             ? "the budget is used up"
                             : "take a smaller delta (or range of them), a greater --phi-margin or a "
                               "higher --y",
                         nothing));
    return exit_not_certified;
}

}  // namespace

constinit const Command adiabatic_command{"adiabatic",      more_group,        adiabatic_description,
                                          adiabatic_footer, adiabatic_options, stoppable<run_adiabatic>};

}  // namespace dumbbell::cli
