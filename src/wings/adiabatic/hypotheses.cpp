#include <fmt/core.h>

#include "adiabatic/box.hpp"
#include "adiabatic/prove.hpp"
#include "base/error.hpp"
#include "number/decimal.hpp"

namespace dumbbell::adiabatic {
namespace {

const char* margin_option = "--phi-margin";
const Rational least_of_a_bounce(1, 1'000'000'000'000);  ///< the slack of the boxes is 2^-40
const Rational least_of_an_orbit(1, 1'000'000);  ///< about 1/delta collisions, and a verifier may refuse more

void require_delta(const Hypotheses& of) {
    const auto& [lo, hi] = of.delta;
    if (hi <= 0 || hi >= Rational(1, 2) || lo < 0) {
        throw InputError(
            "--delta must lie between 0 and 1/2: the light mass is delta^2 of the whole, for example 0.01");
    }
    const bool bounce = of.claim == Claim::bounce;
    const Rational& least = bounce ? least_of_a_bounce : least_of_an_orbit;
    const bool too_small = hi < least || (lo > 0 && lo < least);
    if (too_small && bounce) {
        throw InputError("--delta must be at least 1e-12: in doubles smaller ones are hardly told from 0");
    }
    if (too_small) {
        throw InputError(fmt::format(
            "--delta must be at least 1e-6: orbits of smaller ones have more than 10^6 collisions{}",
            of.claim == Claim::run ? "; a range 0:D holds for all of them" : ""));
    }
    if (lo == 0 && of.claim != Claim::run) {
        throw InputError("--delta: a range may begin at 0 for thm3.3 only; begin it above 0");
    }
}

void require_margin(const Hypotheses& of) {
    if (of.margin <= 0) {
        throw InputError(fmt::format(
            "{} 0: the box reaches the vertical, where the statement does not hold; keep a distance above 0",
            margin_option));
    }
    if (of.margin > 1) {
        throw InputError(fmt::format("{} {}: at most 1", margin_option, exact_text(of.margin)));
    }
}

/// Some delta, some angle, of the box.
void require_some(const Hypotheses& of) {
    const auto& [lowest, highest] = of.heights;
    if (of.claim == Claim::scattering) {
        return;
    }
    if (lowest < 0 || highest > 1 || lowest >= highest) {
        throw InputError("--y must be a range LO:HI of heights within 0:1, LO < HI");
    }
    const Sides sides(of);
    const Masses<Interval> masses(
        hull(enclose<Interval>(of.delta.first), enclose<Interval>(of.delta.second)));
    const Interval nearest = hull(low_end(sides.margin(masses)), Interval(2));
    if (certainly_less(half_pi<Interval>(), low_end(nearest)) ||
        sides.certainly_elsewhere(hull(low_end(nearest), high_end(half_pi<Interval>())), masses)) {
        throw InputError(fmt::format(
            "no state has these heights (--y) at this distance from the vertical ({})", margin_option));
    }
}

}  // namespace

void require_sensible(const Hypotheses& of) {
    require_delta(of);
    require_margin(of);
    require_some(of);
}

}  // namespace dumbbell::adiabatic
