#include "model/bridge_clearance.hpp"
#include "model/chart.hpp"
#include "model/count.hpp"
#include "prove/leaf_judges.hpp"

namespace dumbbell {
namespace {

/// A box in enclosures. Positions are clipped to the section, e <= pi/2.
template <class I>
struct Bounds {
    I e_lo, slope_lo, slope_hi;
    Position<I> low, high;
    RatioRange<I> range;
};

template <class I>
Bounds<I> bounds_of(const Box& box) {
    const I e_lo = enclose<I>(box.e_lo);
    return {e_lo,
            enclose<I>(box.slope_lo),
            enclose<I>(box.slope_hi),
            position(e_lo),
            position(enclose<I>(box.e_hi)),
            {enclose<I>(Rational(1) / box.q_hi), enclose<I>(Rational(1) / box.q_lo)}};
}

/// Beyond the peak, or X not in play (L3) on the whole box. X has slope >= r_lo * slope_lo in both charts.
template <class I>
bool beyond_section(const Bounds<I>& b) {
    return certainly_less(half_pi<I>(), b.e_lo) || certainly_at_most(I(1), b.range.r_lo * b.slope_lo);
}

/// Counts of both rays with 1 + forward + backward <= upper, if certain.
template <class I>
std::optional<Leaf> counted(const Ray<I>& out, const std::optional<Ray<I>>& reversed, long upper,
                            const Interrupted& interrupted) {
    const long forward = count_at_most(out, upper - 1, interrupted);
    if (forward > upper - 1) {
        return std::nullopt;
    }
    const long room = upper - 1 - forward;
    const long backward = reversed ? count_at_most(*reversed, room, interrupted) : 0;
    if (backward > room) {
        return std::nullopt;
    }
    return Leaf{Reason::count, forward, backward};
}

/// L8: X is lowest at the far end of the position, sigma X at the near end, both at the least steepness.
template <class I>
std::optional<Leaf> judge_bridge(const Bounds<I>& b, long upper, const Interrupted& interrupted) {
    if (beyond_section(b)) {
        return Leaf{Reason::outside};
    }
    const auto out = bridge_outgoing(b.high, b.slope_lo);
    const auto reversed = bridge_reversed(b.low, b.slope_lo, b.range.r_hi);
    return counted<I>(lowest_over(out, b.range), lowest_over(reversed, b.range), upper, interrupted);
}

/// L9: sigma X descends on the whole box, so the collision is not turning there.
template <class I>
bool certainly_not_turning(const Bounds<I>& b) {
    const I& w = b.high.cos_e;
    return certainly_less(I(2) * w, b.slope_lo * (sqr(w) - b.range.r_hi));
}

/// L9: sigma X certainly flies left and crosses the bridge on the whole box.
template <class I>
bool reversed_meets_bridge(const Bounds<I>& b) {
    const I& w = b.high.cos_e;
    const I least_denominator = sqr(w) + I(2) * b.range.r_lo * b.slope_lo * w - b.range.r_hi;
    if (!certainly_positive(least_denominator)) {
        return false;
    }
    const auto steepest = reversed_at_light_wall(b.slope_lo, w, b.range.r_hi);
    const I mu = max(I(0), steepest.numerator / steepest.denominator);
    return certainly_meets_bridge(b.high, mu, b.range);
}

template <class I>
std::optional<Leaf> judge_light(const Bounds<I>& b, long upper, const Interrupted& interrupted) {
    if (beyond_section(b) || certainly_not_turning(b)) {
        return Leaf{Reason::outside};
    }
    if (certainly_meets_bridge(b.high, b.slope_hi, b.range)) {
        return Leaf{Reason::meets};
    }
    if (reversed_meets_bridge(b)) {
        return Leaf{Reason::meets_reversed};
    }
    const I& w = b.low.cos_e;
    const I& r = b.range.r_lo;
    const Ray<I> out = light_outgoing(b.low, r * b.slope_lo, r);
    const I greatest_denominator = sqr(w) + I(2) * b.range.r_hi * b.slope_hi * w - r;
    if (certainly_at_most(greatest_denominator, I(0))) {
        return counted<I>(out, std::nullopt, upper, interrupted);  // sigma X leaves the cell (L1)
    }
    const auto lowest = reversed_at_light_wall(b.slope_hi, w, r);
    if (!certainly_positive(lowest.denominator)) {
        return std::nullopt;
    }
    const I mu = max(I(0), lowest.numerator / lowest.denominator);
    return counted<I>(out, light_outgoing(b.low, r * mu, r), upper, interrupted);
}

}  // namespace

template <class I>
std::optional<Leaf> judge_turning(Chart chart, const Box& box, long upper, const Interrupted& interrupted) {
    const Bounds<I> bounds = bounds_of<I>(box);
    return chart == Chart::bridge ? judge_bridge(bounds, upper, interrupted)
                                  : judge_light(bounds, upper, interrupted);
}

template std::optional<Leaf> judge_turning<Interval>(Chart, const Box&, long, const Interrupted&);
template std::optional<Leaf> judge_turning<BigInterval>(Chart, const Box&, long, const Interrupted&);

}  // namespace dumbbell
