#include <algorithm>
#include <array>
#include <cmath>

#include "collisions/names.hpp"
#include "collisions/perpendicular.hpp"
#include "collisions/section.hpp"
#include "collisions/witness.hpp"
#include "file/limits.hpp"
#include "flight/corner.hpp"

/// Every rigid body, by perpendicular orbits (Theorem B of body.md, L87).
namespace dumbbell::collisions {
namespace {

/// What seems to be N of a body; nothing if interrupted.
template <class I>
std::optional<Count> body_maximum(const Rational& q, const System& system, const Interrupted& interrupted) {
    const LowerBound found = least_collisions<I>({{*system.rho, *system.rho}, {q, q}}, interrupted);
    return interrupted() ? std::nullopt : std::optional(Count(found.bound));
}

/// A witness in the corner (L73), or at the bridge.
template <class I>
std::optional<Witness> body_witness(const Range& range, const Count& wanted, const System& system,
                                    const Interrupted& interrupted) {
    const long target = as_long(wanted);
    if (target <= most_in_corner && flight::corner_count(*system.rho, range.lo, target) >= target) {
        return Witness{0, 0, target - 1, 0, Place::corner};
    }
    return contact_of_body<I>(range, target, system, interrupted);
}

/// L87 (a).
template <class I>
std::optional<Cover> orbits_cover(const Range& range, const Count& upper, const System& system,
                                  const Interrupted& interrupted) {
    auto orbits = at_most<I>(as_long(upper), {{*system.rho, *system.rho}, range}, interrupted);
    return orbits ? std::optional(Cover{.orbits = std::move(orbits), .charts = {}}) : std::nullopt;
}

/// L72.
std::optional<Cover> symmetric_cover(const Range& range, const Count& upper, const System& system,
                                     const Interrupted& /*interrupted*/) {
    const bool holds = *system.rho == 1 && flight::corner_count(1, range.hi, most_in_corner) <=
                                               std::min(upper, Count(most_in_corner));
    return holds ? std::optional(Cover{.symmetric = true, .charts = {}}) : std::nullopt;
}

/// At cot^2(pi / (2 (n - 1))) (L72).
Step symmetric_step(long n, double gap, const Interrupted& /*interrupted*/) {
    if (n == 4) {
        return {n, 3, 0, true};
    }
    const PrecisionScope scope(64 + static_cast<int>(-3.33 * std::log10(gap)));
    const auto at = sin_cos(half_pi<BigInterval>() / BigInterval(static_cast<double>(n - 1)));
    const BigInterval q = sqr(at.cos / at.sin);
    return {n, exact_lo(q), (exact_hi(q) - exact_lo(q)) / exact_lo(q), false};
}

template <class I>
constexpr BoundSearch<I> body_bounds{body_maximum<I>, nullptr, nullptr, body_witness<I>, orbits_cover<I>};
template <class I>
constexpr BoundSearch<I> plain_bounds{body_maximum<I>, nullptr, nullptr, body_witness<I>, symmetric_cover};

constexpr std::array plain_body_charts{Chart::plain_contact, Chart::plain_departure};

}  // namespace

constexpr SectionRow body_row{.scene = "body",
                              .section = "perpendicular",
                              .lemmas = "body",
                              .section_in_file = "perpendicular",
                              .kind_in_totals = orbits_word,
                              .hits = "motion of the body in a plane, without a corner, hits the floor",
                              .hits_it = "motion hits it",
                              .growth = "1.570796326794896619231321691640",
                              .most_digits = 12,  // there are no macro steps in the valley
                              .charts = {},
                              .step = nullptr,
                              .is_monotone = true,  // L83
                              .bounds = {body_bounds<Interval>, body_bounds<BigInterval>}};

/// The same of bodies with mass between their contacts, for who doubts the theorem.
const SectionRow plain_body_row = [] {
    SectionRow row = body_row;
    row.section = "plain";
    row.section_in_file = "full";
    row.kind_in_totals = symmetric_word;
    row.bits_to_verify = 0;
    row.max_bits = double_bits;  // what it leaves open is next to a tie
    row.max_nodes = 20'000'000;
    row.charts = plain_body_charts;
    row.is_monotone = false;
    row.bounds = {plain_bounds<Interval>, plain_bounds<BigInterval>};
    return row;
}();

const SectionRow symmetric_row = [] {
    SectionRow row = body_row;
    row.exact_step = 3;
    row.step = symmetric_step;
    return row;
}();

}  // namespace dumbbell::collisions
