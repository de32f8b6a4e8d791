#include "collisions/leaf_judges.hpp"
#include "flight/bridge_once.hpp"
#include "flight/departure.hpp"
#include "flight/plain.hpp"

namespace dumbbell::collisions {
namespace {

/// A box in enclosures.
template <class I>
struct Bounds {
    I position_lo, position_hi, eta_lo, eta_hi;
    flight::RatioRange<I> range;
    flight::Body<I> body;
};

/// Dumbbells, or one body with Q rho = 1 (L75).
bool is_massless(const Box& box) {
    return approximate(box.rho_hi) == 0 ||
           (Rational(box.rho_lo) * Rational(box.q_lo) == 1 && Rational(box.rho_hi) * Rational(box.q_hi) == 1);
}

template <class I>
flight::Body<I> body_of(const Box& box) {
    const I r = hull(box.q_hi.inverse<I>(), box.q_lo.inverse<I>());
    return is_massless(box)
               ? flight::Body<I>::massless(r)
               : flight::Body<I>::with_mass(hull(box.rho_lo.enclosure<I>(), box.rho_hi.enclosure<I>()), r);
}

template <class I>
Bounds<I> bounds_of(const Box& box) {
    return {box.e_lo.enclosure<I>(),
            box.e_hi.enclosure<I>(),
            box.slope_lo.enclosure<I>(),
            box.slope_hi.enclosure<I>(),
            {box.q_hi.inverse<I>(), box.q_lo.inverse<I>()},
            body_of<I>(box)};
}

std::optional<Leaf> counted(long later, long upper) {
    return later <= upper - 1 ? std::optional(Leaf{Reason::count, later, 0}) : std::nullopt;
}

/// Beyond the left corner, or every slope rho (cos t + eta) >= 1.
template <class I>
bool beyond_contacts(const Bounds<I>& b) {
    return certainly_less(pi<I>(), b.position_lo) ||
           certainly_at_most(I(1), low_end(b.body.rho) * (b.eta_lo - I(1)));
}

/// The ray from the bridge at min(t, pi) with steepness eta, in units of the bridge's height.
template <class I>
flight::ScaledRay<I> from_bridge(const I& position, const I& eta) {
    const I t = min(position, pi<I>());
    const SinCos<I> at = sin_cos(t);
    const I lambda = max(I(-1), at.cos) + eta;
    return {max(I(0), max(I(0), at.sin) + lambda * (pi<I>() - t)), lambda};
}

/// L15: the lowest, flattest ray leaves at the greatest t with the least eta.
template <class I>
std::optional<Leaf> judge_contact(const Bounds<I>& b, long upper, const Interrupted& interrupted) {
    if (beyond_contacts(b)) {
        return Leaf{Reason::outside};
    }
    const auto lowest = lowest_over(from_bridge(b.position_hi, b.eta_lo), b.range);
    return counted(as_long(count_at_most(lowest, upper - 1, interrupted)), upper);
}

template <class I>
std::optional<Leaf> judge_plain_contact(const Bounds<I>& b, long upper, const Interrupted& interrupted) {
    if (beyond_contacts(b)) {
        return Leaf{Reason::outside};
    }
    const I& rho = b.body.rho;
    const flight::ScaledRay<I> rays =
        from_bridge(hull(b.position_lo, b.position_hi), hull(b.eta_lo, b.eta_hi));
    const flight::PlainRay<I> scaled{rho * rays.c, flight::detail::in_play(rho * rays.lambda)};
    return counted(plain_count(scaled, b.body, upper - 1, interrupted), upper);
}

template <class I>
std::optional<Leaf> judge_again(const Bounds<I>& b) {
    if (beyond_contacts(b)) {
        return Leaf{Reason::outside};
    }
    return certainly_once(b.position_hi, hull(b.eta_lo, b.eta_hi), b.range)
               ? std::optional(Leaf{Reason::once})
               : std::nullopt;
}

/// Beyond the peak, or every slope eta - cos e >= 1 (it grows with both).
template <class I>
bool beyond_departures(const Bounds<I>& b) {
    return certainly_less(half_pi<I>(), b.position_lo) ||
           certainly_at_most(I(1), departure(flight::position(b.position_lo), b.eta_lo).kappa);
}

template <class I>
std::optional<Leaf> judge_departure(const Bounds<I>& b, long upper, const Interrupted& interrupted) {
    if (beyond_departures(b)) {
        return Leaf{Reason::outside};
    }
    const auto low = lowest(departure(flight::position(b.position_lo), b.eta_lo));
    const auto high = highest(departure(flight::position(b.position_hi), b.eta_hi));
    return counted(later_collisions_at_most(low, high, b.range, upper - 1, interrupted), upper);
}

template <class I>
std::optional<Leaf> judge_plain_departure(const Bounds<I>& b, long upper, const Interrupted& interrupted) {
    if (beyond_departures(b)) {
        return Leaf{Reason::outside};
    }
    const auto all =
        departure(flight::position(hull(b.position_lo, b.position_hi)), hull(b.eta_lo, b.eta_hi));
    const flight::PlainDeparture<I> from{all.x, all.sin_x, flight::detail::in_play(all.kappa)};
    return counted(plain_later_collisions(from, b.body, upper - 1, interrupted), upper);
}

}  // namespace

template <class I>
std::optional<Leaf> judge_full(Chart chart, const Box& box, long upper, const Interrupted& interrupted) {
    const Bounds<I> bounds = bounds_of<I>(box);
    switch (chart) {
        case Chart::contact:
            return judge_contact(bounds, upper, interrupted);
        case Chart::departure:
            return judge_departure(bounds, upper, interrupted);
        case Chart::plain_contact:
            return judge_plain_contact(bounds, upper, interrupted);
        case Chart::again:
            return judge_again(bounds);
        default:
            return judge_plain_departure(bounds, upper, interrupted);
    }
}

template std::optional<Leaf> judge_full<Interval>(Chart, const Box&, long, const Interrupted&);
template std::optional<Leaf> judge_full<BigInterval>(Chart, const Box&, long, const Interrupted&);

}  // namespace dumbbell::collisions
