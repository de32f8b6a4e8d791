#include "collisions/sections/tangents.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "collisions/chart.hpp"
#include "collisions/names.hpp"

/// Every rigid body, by Theorem B (body.md): the two tangents of the bridge, over a tree of their places e.
namespace dumbbell::collisions {
namespace {

/// L82, of the places [e0, e1]: f(e1) and b(e0), or at the corner J, and there the even value of Theorem B.
template <class I>
std::optional<Leaf> judge_tangent(const Box& box, const Count& most, const Interrupted& interrupted) {
    const auto& [position, slope, ratio] = box.sides;
    const I begin = position.lo.template enclosure<I>();
    if (certainly_less(half_pi<I>(), begin)) {
        return Leaf{Reason::outside};
    }
    const long upper = as_long(most), half = (upper - 1) / 2;
    const Rational rho = box.rho, q = ratio.hi;
    const Tangents<I> of(rho, q, interrupted);
    const long up = of.upward(position.hi.template enclosure<I>(), half), room = half - up;
    if (up > half) {
        return std::nullopt;
    }
    const bool at_corner = approximate(position.lo) == 0;
    long down = of.into_valley(begin, room);
    if (down > room && (!at_corner || may_have_in_corner(2 * room + 3, rho, q))) {
        return std::nullopt;
    }
    down = std::min(down, room);
    const bool may_be_even = at_corner && upper % 2 == 1 && of.even(down, room) > half - down - 1 &&
                             may_have_in_corner(2 * down + 2, rho, q);
    return may_be_even ? std::nullopt : std::optional(Leaf{Reason::count, up, down});
}

template <class I>
constexpr BoundSearch<I> body_bounds{body_maximum<I>, nullptr, nullptr, body_witness<I>};

/// L72.
std::optional<Cover> symmetric_cover(const Range& range, const Count& upper, const System& system) {
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

constexpr std::array tangent_charts{Chart::tangent};
constexpr std::array plain_body_charts{Chart::plain_contact, Chart::plain_departure};

}  // namespace

const ChartRow tangent_chart{.name = "tangent",
                             .position = "e",
                             .slope = {},
                             .greatest_position = 2,
                             .greatest_slope = 1,
                             .splits_position_only = true,
                             .judges = {judge_tangent<Interval>, judge_tangent<BigInterval>}};

constexpr SectionRow body_row{.scene = "body",
                              .section = "tangents",
                              .lemmas = "body",
                              .section_in_file = "tangents",
                              .hits = "motion of the body in a plane, without a corner, hits the floor",
                              .hits_it = "motion hits it",
                              .growth = "1.570796326794896619231321691640",
                              .most_digits = 12,  // there are no macro steps in the valley
                              .max_nodes = 2'000,
                              .charts = tangent_charts,
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
    row.by_lemma = symmetric_cover;
    return row;
}();

const SectionRow symmetric_row = [] {
    SectionRow row = body_row;
    row.exact_step = 3;
    row.step = symmetric_step;
    return row;
}();

}  // namespace dumbbell::collisions
