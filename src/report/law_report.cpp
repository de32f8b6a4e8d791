#include "report/law_report.hpp"

#include <fmt/format.h>

#include "arith/decimal.hpp"
#include "arith/error.hpp"
#include "report/json_number.hpp"

namespace dumbbell {
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

std::string extremum_text(const char* name, const Extremum& x, int sign) {
    const Interval b = bounds(x, sign);
    return fmt::format("{} of N*(q) - C sqrt q: in [{:.17g}, {:.17g}]; the {} bound is its value at q = {}\n",
                       name, b.lo(), b.hi(), sign > 0 ? "lower" : "upper", exact_text(x.at));
}

nlohmann::ordered_json extremum_json(const std::optional<Extremum>& x, int sign) {
    if (!x) {
        return nullptr;
    }
    const Interval b = bounds(*x, sign);
    return {{"lo", unsigned_zero(b.lo())}, {"hi", unsigned_zero(b.hi())}, {"at", to_fraction(x->at)}};
}

const char* said(bool proved) { return proved ? "Proved:    " : "NOT proved:"; }

}  // namespace

bool all_proved(const Law& law) { return law.complete && law.never_decreases && law.below_paper; }

std::string verdict(const LawReport& report) {
    const Law& law = report.law;
    if (!law.complete) {
        return "NOT proved: pieces of this staircase are open.\n";
    }
    const std::string lo = exact_text(law.q_lo), hi = exact_text(law.q_hi);
    return fmt::format(
        "{} N*(q) <= N*(q') for any two mass ratios q < q' from {} to {} that do not lie in the same gap.\n"
        "            N* goes from {} to {} in {} pieces with one value; in each of the {} gaps it is one of "
        "two neighbouring values.\n"
        "{} N*(q) <= ceil(pi/gamma) for every mass ratio from {} to {}: the paper's bound, one more, is "
        "never "
        "attained.\n",
        said(law.never_decreases), lo, hi, law.least, law.greatest, law.values, law.gaps,
        said(law.below_paper), lo, hi);
}

std::string to_text(const LawReport& report) {
    const Law& law = report.law;
    std::string text = fmt::format("{}\n  {}\n\n{}", report.file, report.verdict, verdict(report));
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
        text += extremum_text("Supremum", *law.sup, 1) + extremum_text("Infimum ", *law.inf, -1);
    }
    return text +
           "The supremum is the limit from above at a step, and not attained: N*(q_c(N)) = N - 1 (theorem "
           "2).\n";
}

nlohmann::ordered_json to_json(const LawReport& report) {
    const Law& law = report.law;
    const auto if_complete = [&](auto value) {
        return law.complete ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
    };
    return {{"schema", "dumbbell-law-1"},
            {"file", report.file},
            {"verdict", report.verdict},
            {"ratio", {{"lo", to_fraction(law.q_lo)}, {"hi", to_fraction(law.q_hi)}}},
            {"complete", law.complete},
            {"values", if_complete(law.values)},
            {"gaps", if_complete(law.gaps)},
            {"never_decreases", if_complete(law.never_decreases)},
            {"below_paper_bound", if_complete(law.below_paper)},
            {"C", constant_text(report)},
            {"sup", extremum_json(law.sup, 1)},
            {"inf", extremum_json(law.inf, -1)}};
}

}  // namespace dumbbell
