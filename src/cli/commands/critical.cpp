#include <fmt/core.h>

#include <tuple>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/terminal/common.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "critical/range.hpp"
#include "critical/report.hpp"
#include "number/count_argument.hpp"
#include "number/ratio_argument.hpp"
#include "words/printed.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* critical_description =
    R"(Compute critical mass ratios, where the greatest number steps from N-1 to N.

Every digit printed is proved. The enclosures rest on theorem 2 of proofs/theorem.md, those of bodies on Theorem B of
proofs/body.md. dumbbell certify does not use theorem 2: run it at a ratio on either side to compare.

Examples:
  dumbbell critical 4                                    q_c(4) = 4.60333884875170...
  dumbbell critical 4 --digits 100                       more of its digits
  dumbbell critical 3:20                                 the first 18 steps
  dumbbell critical 10^12 --digits 50                    a very long orbit, by macro steps
  dumbbell critical 3:902 --digits 50 --out ratios.tsv   a table as a file
  dumbbell critical 4:9 --rho 1/2                        of bodies with this rho: N or more collisions iff Q > Q_c(N)
  dumbbell critical --ratio 10 --rod-mass                masses of the dumbbell's rod at which N falls

Beyond N = 10^17: dumbbell law --count 1e50 encloses one critical ratio by the law for every mass ratio.)";

constexpr const char* critical_footer =
    R"(Exit codes: 0 proved; 1 internal error; 2 wrong usage or input; 3 not finished within the budget; 130 or 143 stopped by
SIGINT (Ctrl-C) or SIGTERM: nothing is kept.)";

constexpr std::array critical_options{
    argument("N", "number of collisions from 3 to 10^17, or closed range N1:N2"),
    Option{"--rho", "RHO", "of rigid bodies with this d2/d1: the Q = (d1/k)^2 at which N steps"}.excludes(
        "--ratio"),
    Option{"--ratio", "RATIO", "of the dumbbell of this mass ratio"}.needs("--rod-mass").excludes("N"),
    flag("--rod-mass", "the masses of its uniform rod, in units of that of both ends, at which N falls")
        .needs("--ratio"),
    Option{"--digits", "N", "significant digits, all of them proved", "15"}.from(1, critical::most_digits),
    Option{"--out", "FILE",
           "write the table to FILE, tab-separated (FILE.gz: compressed); -: the standard output"}
        .checked(fault_of_name<Content::table>),
    jobs_option,
    budget_option,
    json_option,
    flag("--quiet", "the ratios alone, a line each, and no progress")};

std::vector<critical::Row> enclose(critical::Request request, Verbosity verbosity) {
    const bool one = request.first == request.last;
    Progress progress(one ? "flights" : "critical ratios", verbosity, "enclosing");
    request.observer = &progress;
    return enclose_ratios(request);
}

std::optional<critical::Bodies> bodies_of(const Given& given) {
    if (given.has("--ratio")) {
        const RatioArgument ratio = parse_ratio_argument(given.text("--ratio"));
        if (ratio.lo != ratio.hi) {
            throw InputError("--ratio is a single mass ratio, not a range");
        }
        return critical::Bodies{ratio.lo, true};
    }
    if (!given.has("--rho")) {
        return std::nullopt;
    }
    return critical::Bodies{*collisions::claim_of_body(given.text("--rho"), "1").system.rho};
}

/// Of bodies.
void check_counts(const critical::Request& request) {
    constexpr long most = 1'000'000;
    const long least = request.bodies->least();
    if (request.first <= least) {
        throw InputError(fmt::format("at this rho every Q > 0 has {} collisions: the steps begin with N = {}",
                                     least, least + 1));
    }
    if (request.last > most) {
        throw InputError("of bodies N is at most 10^6: their orbits are followed collision by collision");
    }
}

critical::Request critical_request(const Given& given) {
    critical::Request request;
    const auto bodies = bodies_of(given);
    if (given.has("N") == (bodies && bodies->have_rods)) {
        throw InputError("critical needs N or N1:N2, or --ratio RATIO --rod-mass");
    }
    if (given.has("N")) {
        std::tie(request.first, request.last) = parse_counts(given.text("N"));
    }
    request.digits = static_cast<int>(given.number("--digits"));
    request.jobs = jobs_of(given);
    request.budget = budget_of(given);
    request.bodies = bodies;
    if (bodies && !bodies->have_rods) {
        check_counts(request);
    }
    return request;
}

int run_critical(const Given& given) {
    critical::Report report{.request = critical_request(given), .rows = {}, .seconds = 0, .out = {}};
    const Output output(given.text("--out"), {}, given.has("--json") ? "--json" : nullptr);
    const Stopwatch watch;
    report.rows = enclose(report.request, verbosity_of(given));
    report.seconds = watch.seconds();
    const long open = open_in(report);
    if (open > 0 && stop_signal != 0) {
        const auto wanted = static_cast<long>(report.rows.size());
        return stopped(
            open == wanted
                ? "nothing is kept"
                : fmt::format("nothing is kept of the {} critical ratios that were finished (of {}): "
                              "with --budget TIME what is finished in time is printed",
                              wanted - open, wanted));
    }
    if (output.is_wanted()) {
        report.out = output.file();
        output.commit(to_tsv(report));
    }
    leave_out_unreached(report);
    fmt::print(output.report(), "{}", shown(report, given));
    if (open > 0) {
        complain("not everything was enclosed: allow more time (--budget)");
    }
    return open > 0 ? exit_not_certified : exit_done;
}

}  // namespace

constinit const Command critical_command{"critical",      first_group,      critical_description,
                                         critical_footer, critical_options, stoppable<run_critical>};

}  // namespace dumbbell::cli
