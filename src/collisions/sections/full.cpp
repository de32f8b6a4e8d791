#include "collisions/chart.hpp"
#include "flight/bridge_once.hpp"
#include "flight/departure.hpp"
#include "flight/plain.hpp"

namespace dumbbell::collisions {
namespace {

/// A box in enclosures.
template <class I>
struct FullBounds {
    I position_lo, position_hi, eta_lo, eta_hi;
    flight::RatioRange<I> range;
    flight::Body<I> body;
};

/// The bodies of a box; massless dumbbells if it has no rho, or is of one body with Q rho = 1 (L75).
template <class I>
flight::Body<I> body_of(const Box& box) {
    const Side& q = box[Axis::ratio];
    const Rational rho = box.rho, lo = q.lo, hi = q.hi;
    const I r = hull(q.hi.template inverse<I>(), q.lo.template inverse<I>());
    const bool is_massless = rho == 0 || (rho * lo == 1 && rho * hi == 1);
    return is_massless ? flight::Body<I>::massless(r)
                       : flight::Body<I>::with_mass(box.rho.template enclosure<I>(), r);
}

template <class I>
FullBounds<I> full_bounds(const Box& box) {
    const auto& [position, eta, q] = box.sides;
    return {position.lo.template enclosure<I>(),
            position.hi.template enclosure<I>(),
            eta.lo.template enclosure<I>(),
            eta.hi.template enclosure<I>(),
            {q.hi.template inverse<I>(), q.lo.template inverse<I>()},
            body_of<I>(box)};
}

std::optional<Leaf> counted_forward(long later, long upper) {
    return later <= upper - 1 ? std::optional(Leaf{Reason::count, later, 0}) : std::nullopt;
}

/// Beyond the left corner, or every slope rho (cos t + eta) >= 1.
template <class I>
bool beyond_contacts(const FullBounds<I>& b) {
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
std::optional<Leaf> judge_contact(const FullBounds<I>& b, long upper, const Interrupted& interrupted) {
    if (beyond_contacts(b)) {
        return Leaf{Reason::outside};
    }
    const auto lowest = lowest_over(from_bridge(b.position_hi, b.eta_lo), b.range);
    return counted_forward(as_long(count_at_most(lowest, upper - 1, interrupted)), upper);
}

template <class I>
std::optional<Leaf> judge_plain_contact(const FullBounds<I>& b, long upper, const Interrupted& interrupted) {
    if (beyond_contacts(b)) {
        return Leaf{Reason::outside};
    }
    const I& rho = b.body.rho;
    const flight::ScaledRay<I> rays =
        from_bridge(hull(b.position_lo, b.position_hi), hull(b.eta_lo, b.eta_hi));
    const flight::PlainRay<I> scaled{rho * rays.c, flight::detail::in_play(rho * rays.lambda)};
    return counted_forward(plain_count(scaled, b.body, upper - 1, interrupted), upper);
}

template <class I>
std::optional<Leaf> judge_again(const FullBounds<I>& b, long /*upper*/, const Interrupted& /*interrupted*/) {
    if (beyond_contacts(b)) {
        return Leaf{Reason::outside};
    }
    return certainly_once(b.position_hi, hull(b.eta_lo, b.eta_hi), b.range)
               ? std::optional(Leaf{Reason::once})
               : std::nullopt;
}

/// Beyond the peak, or every slope eta - cos e >= 1 (it grows with both).
template <class I>
bool beyond_departures(const FullBounds<I>& b) {
    return certainly_less(half_pi<I>(), b.position_lo) ||
           certainly_at_most(I(1), departure(flight::position(b.position_lo), b.eta_lo).kappa);
}

template <class I>
std::optional<Leaf> judge_departure(const FullBounds<I>& b, long upper, const Interrupted& interrupted) {
    if (beyond_departures(b)) {
        return Leaf{Reason::outside};
    }
    const auto low = lowest(departure(flight::position(b.position_lo), b.eta_lo));
    const auto high = highest(departure(flight::position(b.position_hi), b.eta_hi));
    return counted_forward(later_collisions_at_most(low, high, b.range, upper - 1, interrupted), upper);
}

template <class I>
std::optional<Leaf> judge_plain_departure(const FullBounds<I>& b, long upper,
                                          const Interrupted& interrupted) {
    if (beyond_departures(b)) {
        return Leaf{Reason::outside};
    }
    const auto all =
        departure(flight::position(hull(b.position_lo, b.position_hi)), hull(b.eta_lo, b.eta_hi));
    const flight::PlainDeparture<I> from{all.x, all.sin_x, flight::detail::in_play(all.kappa)};
    return counted_forward(plain_later_collisions(from, b.body, upper - 1, interrupted), upper);
}

template <class I, auto check>
std::optional<Leaf> judge_full(const Box& box, const Count& upper, const Interrupted& interrupted) {
    return check(full_bounds<I>(box), as_long(upper), interrupted);
}

/// `check` as a generic lambda.
template <auto check>
constexpr Judges judges{judge_full<Interval, check>, judge_full<BigInterval, check>};

/// Contacts with the bridge, at 0 <= t <= pi.
constexpr ChartRow contacts(std::string_view name, bool needs_both_ratios, const Judges& judges) {
    return {.name = name,
            .position = "t",
            .slope = "eta",
            .greatest_position = 4,
            .slope_beyond = 1,
            .counts_both_ways = false,
            .needs_both_ratios = needs_both_ratios,
            .judges = judges};
}

/// Departures from a light wall.
constexpr ChartRow departures(const Judges& judges) {
    return {.name = "departure",
            .position = "e",
            .slope = "eta",
            .greatest_position = 2,
            .greatest_slope = 2,
            .counts_both_ways = false,
            .needs_both_ratios = true,
            .judges = judges};
}

}  // namespace

const ChartRow contact_chart =
    contacts("contact", false, judges<[](const auto&... given) { return judge_contact(given...); }>);
const ChartRow plain_contact_chart =
    contacts("contact", true, judges<[](const auto&... given) { return judge_plain_contact(given...); }>);
const ChartRow again_chart =
    contacts("again", true, judges<[](const auto&... given) { return judge_again(given...); }>);
const ChartRow departure_chart =
    departures(judges<[](const auto&... given) { return judge_departure(given...); }>);
const ChartRow plain_departure_chart =
    departures(judges<[](const auto&... given) { return judge_plain_departure(given...); }>);

}  // namespace dumbbell::collisions
