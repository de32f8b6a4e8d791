#include <fmt/core.h>

#include "adiabatic/prove.hpp"
#include "adiabatic/report.hpp"
#include "adiabatic/writer.hpp"
#include "base/deadline.hpp"
#include "cli/commands.hpp"
#include "cli/terminal/common.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "commands/statements.hpp"

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
thm3.3 C holds for any number of bounces.

Examples:
  dumbbell adiabatic --delta 0.01                               Theorem 3.3 with its constant
  dumbbell adiabatic --delta 0:0.01                             for all delta up to 0.01
  dumbbell adiabatic --delta 0.01 --phi-margin 0.2              nearer to the vertical
  dumbbell adiabatic --delta 0.01 --theorem cor3.2 --k 1/4
  dumbbell adiabatic --delta 0.01 --theorem thm3.5 --out scattering.dbc)";

constexpr const char* adiabatic_footer =
    R"(Exit codes: 0 certified; 1 internal error; 2 wrong usage or input; 3 not certified within the budget; 130 or 143
stopped by SIGINT (Ctrl-C) or SIGTERM: nothing is kept.)";

constexpr std::array adiabatic_options =
    joined(statement_options, std::array{budget_option, jobs_option, certificate_option, json_option,
                                         flag("--quiet", "the constants alone, and no progress")});

int run_adiabatic(const Given& given) {
    const adiabatic::Hypotheses wanted = statement_of(given);
    adiabatic::Report report{.theorem = given.text("--theorem"), .accuracy = accuracy_of(given)};
    const Output output(given.text("--out"), {}, given.has("--json") ? "--json" : nullptr);
    const Interrupted interrupted = deadline(budget_of(given));
    {
        constexpr const char* search = "looking for an orbit with a great error";
        Progress progress("boxes", verbosity_of(given), search);
        progress.enter(search, "");
        const Stopwatch watch;
        report.proof = adiabatic::prove({.of = wanted,
                                         .accuracy = report.accuracy,
                                         .jobs = jobs_of(given),
                                         .interrupted = interrupted,
                                         .observer = &progress});
        report.seconds = watch.seconds();
    }
    const bool complete = report.proof.complete();
    if (output.is_wanted() && complete) {
        write(render(report.proof), output, report);
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
