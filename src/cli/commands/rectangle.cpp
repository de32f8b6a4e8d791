#include "cli/commands/rectangle.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "cli/terminal/common.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/messages.hpp"
#include "cli/terminal/stop_signals.hpp"
#include "collisions/cells.hpp"
#include "collisions/claim.hpp"
#include "collisions/section.hpp"
#include "number/decimal.hpp"
#include "number/parallel.hpp"
#include "number/ratio_argument.hpp"
#include "words/printed.hpp"

namespace dumbbell::cli {
namespace {

using collisions::Range;
using collisions::Rectangle;

struct RectangleReport {
    Rectangle bodies;
    std::optional<double> wanted;  ///< the share of it whose numbers are wanted; else one number for all
    collisions::Cells cells;
    double seconds = 0;
    std::optional<std::string> out{}, sha256{};

    [[nodiscard]] bool is_done() const { return wanted ? cells.share >= *wanted : cells.is_decided(); }
    [[nodiscard]] std::string share() const {
        return fmt::format("{:.4f}", std::floor(std::max(0.0, cells.share) * 1e4) / 1e4);
    }
};

Rectangle rectangle_of(const Given& given) {
    for (const char* option : {"RATIO", "--section", "--gap", "--part", "--witness"}) {
        if (given.has(option)) {
            throw InputError(fmt::format("{} is not for a rectangle of bodies: leave it out", option));
        }
    }
    if (!given.has("--inertia")) {
        throw InputError("--rho needs --inertia");
    }
    Rectangle bodies{collisions::parse_range("--rho", given.text("--rho")),
                     collisions::parse_range("--inertia", given.text("--inertia"))};
    collisions::require_rho(bodies.rho.hi);
    const auto reason =
        collisions::out_of_reach({.range = bodies.q, .system = {collisions::Section::body, bodies.rho.hi}});
    if (reason || !collisions::fits_a_line(bodies.rho)) {
        throw InputError(
            reason.value_or("--rho is too long for a line of a certificate: write fewer digits"));
    }
    if (!collisions::is_within_reach(bodies)) {
        throw InputError(
            "rectangles are proved where the corner has at most 10,000 collisions: lower --inertia");
    }
    return bodies;
}

std::string verdict(const RectangleReport& report) {
    const collisions::SectionRow& words = row_of(collisions::Section::body);
    const auto& [rho, q] = report.bodies;
    const auto times = [](long n) { return plural(n, "time"); };
    const std::string where =
        fmt::format("at every Q from {} to {} and every rho from {} to {}", exact_text(q.lo),
                    exact_text(q.hi), exact_text(rho.lo), exact_text(rho.hi));
    if (report.wanted) {
        return fmt::format(
            "{}: of at least {} of the bodies with Q rho > 1,\n{}, by area in (log rho, log Q),\n"
            "the greatest number of times that a {}.\n",
            report.is_done() ? "Proved" : "Not decided as far as was asked. Proved is this", report.share(),
            where, words.hits);
    }
    if (!report.cells.upper) {
        return fmt::format("Not decided: nothing is proved {}.\n", where);
    }
    return fmt::format("{}: {}\nno {} more than {}, and some {} {}{}.\n",
                       report.cells.is_decided() ? "Proved" : "Not decided. Proved is this", where,
                       words.hits, times(*report.cells.upper), words.hits_it,
                       report.cells.is_decided() ? "" : "at least ", times(report.cells.lower));
}

std::string to_text(const RectangleReport& report) {
    const auto& [rho, q] = report.bodies;
    const auto& [upper, lower, cells, share, certificate] = report.cells;
    std::string text =
        fmt::format("{} in {:.3f} s\n{}", plural(cells, "cell"), report.seconds, verdict(report));
    if (report.out) {
        text += fmt::format("Certificate: {} (sha256 {})\n", one_line(*report.out), *report.sha256);
    }
    if (report.out && (upper || report.wanted)) {
        text += fmt::format("Check it:    dumbbell verify --rho {} --inertia {} {} {}\n",
                            spelled(rho.lo, rho.hi), spelled(q.lo, q.hi),
                            report.wanted    ? fmt::format("--decided {}", report.share())
                            : upper == lower ? fmt::format("--exactly {}", lower)
                                             : fmt::format("--max {} --min {}", *upper, lower),
                            shell_file(*report.out));
    }
    return text;
}

Json to_json(const RectangleReport& report) {
    const auto range = [](const Range& of) {
        return Json::object({{"lo", to_fraction(of.lo)}, {"hi", to_fraction(of.hi)}});
    };
    return Json::object({{"schema", "dumbbell-rectangle-1"},
                         {"scene", "body"},
                         {"rho", range(report.bodies.rho)},
                         {"inertia", range(report.bodies.q)},
                         {"upper", report.cells.upper},
                         {"lower", report.cells.lower},
                         {"cells", report.cells.cells},
                         {"decided", report.wanted ? std::optional(report.share()) : std::nullopt},
                         {"seconds", report.seconds},
                         {"out", report.out},
                         {"sha256", report.sha256}});
}

}  // namespace

bool is_rectangle(const Given& given) {
    return given.text("--rho").find(':') != std::string::npos || given.has("--decided");
}

int certify_rectangle(const Given& given) {
    const Rectangle bodies = rectangle_of(given);
    const Output output(given.text("--out"), {}, given.has("--json") ? "--json" : nullptr);
    const Stopwatch watch;
    RectangleReport report{.bodies = bodies, .wanted = {}, .cells = {}};
    if (given.has("--decided")) {
        report.wanted = parse_number("--decided", given.text("--decided")).convert_to<double>();
        if (*report.wanted >= 1) {
            throw InputError("--decided is a share below 1, such as 0.99");
        }
    }
    report.cells = with_threads(jobs_of(given), [&] {
        Progress progress("cells", verbosity_of(given), "proving");
        return prove_cells(bodies, report.wanted, deadline(budget_of(given)), progress);
    });
    report.seconds = watch.seconds();
    if (output.is_wanted()) {
        write(report.cells.certificate, output, report);
    }
    fmt::print(output.report(), "{}", shown(report, given));
    if (report.is_done()) {
        return exit_done;
    }
    if (stop_signal != 0) {
        return stopped("what is said, and written, is what was proved until then");
    }
    complain(report.wanted ? "less is decided than was asked for: give it more time, or ask for less"
                           : "one number is not proved of the whole rectangle: it may step there, so try a "
                             "smaller one, or --decided SHARE");
    return exit_not_certified;
}

}  // namespace dumbbell::cli
