#include "collisions/chart.hpp"
#include "flight/bridge_clearance.hpp"
#include "flight/chart.hpp"
#include "flight/count.hpp"

namespace dumbbell::collisions {

using flight::Ray;

namespace {

/// A box in enclosures. Positions are clipped to the section, e <= pi/2.
template <class I>
struct TurningBounds {
    I e_lo, slope_lo, slope_hi;
    flight::Position<I> low, high;
    flight::RatioRange<I> range;
};

template <class I>
TurningBounds<I> turning_bounds(const Box& box) {
    const auto& [e, slope, q] = box.sides;
    const I e_lo = e.lo.template enclosure<I>();
    return {e_lo,
            slope.lo.template enclosure<I>(),
            slope.hi.template enclosure<I>(),
            flight::position(e_lo),
            flight::position(e.hi.template enclosure<I>()),
            {q.hi.template inverse<I>(), q.lo.template inverse<I>()}};
}

/// Beyond the peak, or X not in play (L3) on the whole box. X has slope >= r_lo * slope_lo in both charts.
template <class I>
bool beyond_section(const TurningBounds<I>& b) {
    return certainly_less(half_pi<I>(), b.e_lo) || certainly_at_most(I(1), b.range.r_lo * b.slope_lo);
}

/// What a box comes down to: the reason that closes it without a count, or the rays whose counts may close it
/// (without `reversed` if sigma X has no collision); neither: nothing is certain.
template <class I>
struct Case {
    std::optional<Leaf> leaf;
    std::optional<Ray<I>> out;
    std::optional<Ray<I>> reversed;
};

/// L8: X is lowest at the far end of the position, sigma X at the near end, both at the least steepness.
template <class I>
Case<I> bridge_case(const TurningBounds<I>& b) {
    if (beyond_section(b)) {
        return {Leaf{Reason::outside}, std::nullopt, std::nullopt};
    }
    const auto out = bridge_outgoing(b.high, b.slope_lo);
    const auto reversed = bridge_reversed(b.low, b.slope_lo, b.range.r_hi);
    return {std::nullopt, lowest_over(out, b.range), lowest_over(reversed, b.range)};
}

/// L9: sigma X descends on the whole box, so the collision is not turning there.
template <class I>
bool certainly_not_turning(const TurningBounds<I>& b) {
    const I& w = b.high.cos_e;
    return certainly_less(I(2) * w, b.slope_lo * (sqr(w) - b.range.r_hi));
}

/// L9: sigma X certainly flies left and crosses the bridge on the whole box.
template <class I>
bool reversed_meets_bridge(const TurningBounds<I>& b) {
    const I& w = b.high.cos_e;
    const I least_denominator = sqr(w) + I(2) * b.range.r_lo * b.slope_lo * w - b.range.r_hi;
    if (!certainly_positive(least_denominator)) {
        return false;
    }
    const auto steepest = flight::reversed_at_light_wall(b.slope_lo, w, b.range.r_hi);
    const I mu = max(I(0), steepest.numerator / steepest.denominator);
    return certainly_meets_bridge(b.high, mu, b.range);
}

template <class I>
Case<I> light_case(const TurningBounds<I>& b) {
    if (beyond_section(b) || certainly_not_turning(b)) {
        return {Leaf{Reason::outside}, std::nullopt, std::nullopt};
    }
    if (certainly_meets_bridge(b.high, b.slope_hi, b.range)) {
        return {Leaf{Reason::meets}, std::nullopt, std::nullopt};
    }
    if (reversed_meets_bridge(b)) {
        return {Leaf{Reason::meets_reversed}, std::nullopt, std::nullopt};
    }
    const I& w = b.low.cos_e;
    const I& r = b.range.r_lo;
    const Ray<I> out = light_outgoing(b.low, r * b.slope_lo, r);
    const I greatest_denominator = sqr(w) + I(2) * b.range.r_hi * b.slope_hi * w - r;
    if (certainly_at_most(greatest_denominator, I(0))) {
        return {std::nullopt, out, std::nullopt};  // sigma X leaves the cell (L1)
    }
    const auto lowest = flight::reversed_at_light_wall(b.slope_hi, w, r);
    if (!certainly_positive(lowest.denominator)) {
        return {};
    }
    const I mu = max(I(0), lowest.numerator / lowest.denominator);
    return {std::nullopt, out, light_outgoing(b.low, r * mu, r)};
}

template <class I, auto case_of>
std::optional<Leaf> judge_turning(const Box& box, const Count& upper, const Interrupted& interrupted) {
    const Case<I> found = case_of(turning_bounds<I>(box));
    if (found.leaf || !found.out) {
        return found.leaf;
    }
    using N = flight::CountOf<I>;
    const N most = flight::count_in<I>(upper - 1);
    const N forward = count_at_most(*found.out, most, interrupted);
    if (forward > most) {
        return std::nullopt;
    }
    const N room = most - forward;
    const N backward = found.reversed ? count_at_most(*found.reversed, room, interrupted) : N(0);
    return backward > room ? std::nullopt : std::optional(Leaf{Reason::count, forward, backward});
}

template <auto case_of>
bool is_open_turning(const Box& box, long upper, const Interrupted& interrupted) {
    const Case<Interval> found = case_of(turning_bounds<Interval>(box));
    if (found.leaf || !found.out) {
        return false;
    }
    const long forward = count_at_least(*found.out, upper, interrupted);
    return forward == upper || (found.reversed && count_at_least(*found.reversed, upper - forward,
                                                                 interrupted) == upper - forward);
}

constexpr auto on_bridge = [](const auto& b) { return bridge_case(b); };
constexpr auto on_light_wall = [](const auto& b) { return light_case(b); };

}  // namespace

const ChartRow bridge_chart{
    .name = "bridge",
    .position = "e",
    .slope = "eta",
    .greatest_position = 2,
    .splits_position_only = true,  // both counts are at the least slope (L8)
    .judges = {judge_turning<Interval, on_bridge>, judge_turning<BigInterval, on_bridge>},
    .is_open = is_open_turning<on_bridge>};

const ChartRow light_chart{
    .name = "light",
    .position = "e",
    .slope = "lambda",
    .greatest_position = 2,
    .counts_at_least_position = true,  // L9
    .judges = {judge_turning<Interval, on_light_wall>, judge_turning<BigInterval, on_light_wall>},
    .is_open = is_open_turning<on_light_wall>};

}  // namespace dumbbell::collisions
