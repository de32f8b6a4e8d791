#include "staircase/law_report.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "number/decimal.hpp"
#include "words/printed.hpp"

namespace dumbbell::staircase {
namespace {

/// The digits of C that are certain, as many as asked for.
std::string constant_text(const LawReport& report) {
    const BigInterval& c = report.law.constant;
    const auto digits = shared_digits(exact_lo(c), exact_hi(c), report.digits);
    require(digits.has_value(), "the quadrature did not reach the digits asked for");
    return to_text(*digits);
}

/// The bounds of a supremum (sign = 1) or an infimum (-1), rounded outward.
Interval bounds(const Extremum& x, int sign) {
    return sign > 0 ? Interval(x.inner.lo(), x.outer.hi()) : Interval(x.outer.lo(), x.inner.hi());
}

constexpr int shown_digits = 17;

/// The greatest decimal that is at most x (sign = -1), or the least that is at least x (1).
std::string outward(const Rational& x, int sign) {
    if (x == 0) {
        return "0";
    }
    const Rational size = abs(x);
    const bool away = (x > 0) == (sign > 0);
    return (x < 0 ? "-" : "") + to_text(away ? cut_up(size, shown_digits) : cut_down(size, shown_digits));
}

std::string extremum_text(const Extremum& x, int sign) {
    return fmt::format(
        "{} of N(q) - C sqrt q: in [{}, {}]; the {} bound is its value at q = {}\n",
        sign > 0 ? "Supremum" : "Infimum ", outward(exact_lo(sign > 0 ? x.inner : x.outer), -1),
        outward(exact_hi(sign > 0 ? x.outer : x.inner), 1), sign > 0 ? "lower" : "upper", exact_text(x.at));
}

std::string attained_sentence(const Law& law) {
    if (!law.sup->attained) {
        return "Whether the supremum is attained is not decided by these pieces.\n";
    }
    return *law.sup->attained ? fmt::format("The supremum is attained, at q = {}.\n", exact_text(law.q_lo))
                              : "The supremum is not attained: it is the limit from above at a step, where N "
                                "has the lower of its "
                                "two\nvalues (N(q_c(N)) = N - 1, theorem 2 of proofs/theorem.md).\n";
}

Json extremum_json(const Extremum& x, int sign) {
    const Interval b = bounds(x, sign);
    return Json::object(
        {{"lo", unsigned_zero(b.lo())}, {"hi", unsigned_zero(b.hi())}, {"at", to_fraction(x.at)}});
}

Json supremum_json(const Extremum& x) {
    Json json = extremum_json(x, 1);
    json.add("attained", x.attained);
    return json;
}

std::string bounds_text(const Bounds& n) {
    return n.lower == n.upper ? fmt::format("{}", n.lower) : fmt::format("{} or {}", n.lower, n.upper);
}

/// `9 pieces with one value, and 8 gaps in each of which it is one of two neighbouring values`.
std::string pieces_text(const Law& law) {
    std::string values =
        law.values == 0 ? ""
                        : fmt::format("{} piece{} with one value", law.values, law.values == 1 ? "" : "s");
    if (law.gaps == 0) {
        return values;
    }
    return fmt::format("{}{} in {} it is one of two neighbouring values",
                       values.empty() ? "" : values + ", and ",
                       law.gaps == 1 ? "1 gap" : fmt::format("{} gaps", law.gaps),
                       law.gaps == 1 ? "which" : "each of which");
}

const char* said(bool proved) { return proved ? "Proved:    " : "NOT proved:"; }

}  // namespace

bool all_proved(const Law& law) { return law.complete && law.never_decreases && law.below_paper; }

std::string verdict(const LawReport& report) {
    const Law& law = report.law;
    if (!law.complete) {
        return "NOT proved: at least one piece of this staircase is open.\n";
    }
    const std::string lo = exact_text(law.q_lo), hi = exact_text(law.q_hi);
    return fmt::format(
        "{} N(q) <= N(q') for any two mass ratios q < q' from {} to {} that do not lie in the same gap.\n"
        "            N is {} at q = {} and {} at q = {}: {}.\n"
        "{} N(q) <= ceil(pi/gamma) for every mass ratio from {} to {}: the paper's bound, one more, is never "
        "attained.\n",
        said(law.never_decreases), lo, hi, bounds_text(law.first), lo, bounds_text(law.last), hi,
        pieces_text(law), said(law.below_paper), lo, hi);
}

std::string to_text(const LawReport& report) {
    const Law& law = report.law;
    std::string text =
        fmt::format("{}\n  {}\n\n{}", one_line(report.file), one_line(report.verdict), verdict(report));
    if (!law.complete) {
        return text;
    }
    text += fmt::format(
        "\nC = integral of sin((pi/2) / cos theta), theta from 0 to pi/3\n  = {}...  ({} digits, verified "
        "quadrature)\nC sqrt q is what the adiabatic invariant predicts: with I = |phidot| f conserved from "
        "f = pi/2 to f = pi, "
        "the\nslope's angle theta has f cos theta = pi/2, and turns by 2/(w sqrt q), w = sin f, at each "
        "bounce "
        "(proofs/adiabatic.md).\n",
        constant_text(report), report.digits);
    if (law.sup && law.inf) {
        text += extremum_text(*law.sup, 1) + extremum_text(*law.inf, -1) + attained_sentence(law);
    }
    return text;
}

Json to_json(const LawReport& report) {
    const Law& law = report.law;
    const auto if_complete = [&](const Json& value) { return law.complete ? value : Json(); };
    return Json::object(
        {{"schema", "dumbbell-law-1"},
         {"file", report.file},
         {"verdict", report.verdict},
         {"ratio", Json::object({{"lo", to_fraction(law.q_lo)}, {"hi", to_fraction(law.q_hi)}})},
         {"complete", law.complete},
         {"values", if_complete(law.values)},
         {"gaps", if_complete(law.gaps)},
         {"never_decreases", if_complete(law.never_decreases)},
         {"below_paper_bound", if_complete(law.below_paper)},
         {"C", constant_text(report)},
         {"sup", law.sup ? supremum_json(*law.sup) : Json()},
         {"inf", law.inf ? extremum_json(*law.inf, -1) : Json()}});
}

}  // namespace dumbbell::staircase
