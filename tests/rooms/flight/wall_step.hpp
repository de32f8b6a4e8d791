#pragma once

#include <optional>

#include "flight/bridge_contact.hpp"
#include "flight/reflection.hpp"
#include "starts/air/flight.hpp"

/// From light wall to light wall by the steps of src/model, in one pair of coordinates.
namespace dumbbell_test {

/// Departures from a light wall: corner distance x and slope kappa, mirrored so that the flight goes left.
template <class S>
struct WallState {
    S x;
    S kappa;
};

/// Why there is no next departure: it is not certain whether all states collide; all do, but whether they
/// turn back is not certain; none collides; all collide and leave over the peak.
enum class End { open, struck, passed, left };

/// One flight and reflection by the chart-free steps: the next state if all states collide with the light
/// wall ahead and turn back.
template <class S, class R>
std::optional<WallState<S>> step(const WallState<S>& from, const R& r, End& end) {
    using namespace dumbbell;
    using namespace dumbbell::flight;
    using namespace dumbbell::starts;
    using I = Enclosure<S>;
    const State<S> start{S(pi<I>()) + from.x, sin_cos(from.x).sin,     S(-1),
                         from.kappa,          Body<S>::massless(S(r)), S(0)};
    const dumbbell::starts::Event<S> event = event_after_contact(start, dumbbell::flight::End::light);
    end = event.next == Next::none ? End::passed : End::open;
    if (event.next != Next::contact || event.end != dumbbell::flight::End::light) {
        return std::nullopt;
    }
    const State<S> after = bounce(start, event.end, *event.time).after;
    end = certainly_at_most(range(after.phidot), I(0)) ? End::left : End::struck;  // L1
    return certainly_positive(range(after.phidot))
               ? std::optional(WallState<S>{-after.phi, after.yhatdot / after.phidot})
               : std::nullopt;
}

/// The same for the lowest and the highest ray alone.
template <class I>
std::optional<WallState<I>> monotone_step(const WallState<I>& from, const I& r, End& end) {
    using namespace dumbbell;
    using namespace dumbbell::flight;
    using namespace dumbbell::starts;
    const auto ray = [](const I& x, const I& kappa) {
        return std::pair(sin_cos(x).sin + kappa * (x + pi<I>()), kappa);
    };
    const I x_low = low_end(from.x);
    const I low_kappa = low_end(from.kappa);
    const I high_kappa = high_end(from.kappa);
    const I c_low = low_end(ray(x_low, low_kappa).first);
    const I c_high = high_end(ray(high_end(from.x), high_kappa).first);
    end = certainly_at_most(I(1), low_kappa) ? End::passed : End::open;
    if (end == End::passed ||
        !certainly_clears_bridge(low_end(sin_cos(x_low).sin + low_kappa * x_low), low_kappa, r)) {
        return std::nullopt;
    }
    const auto lowest = lowest_contact(c_low, low_kappa);
    end = lowest ? End::open : End::passed;
    const auto highest = highest_contact(c_high, high_kappa);
    if (!lowest || !highest) {
        return std::nullopt;
    }
    const auto low = reflect_at_light_wall(low_kappa, lowest->cos_x, r);
    const auto high = reflect_at_light_wall(high_kappa, highest->cos_x, r);
    end = certainly_at_most(low.denominator, I(0)) ? End::left : End::struck;
    if (!certainly_positive(low.denominator) || !certainly_positive(high.denominator)) {
        return std::nullopt;
    }
    return WallState<I>{hull(lowest->x, highest->x), hull(low_end(low.numerator / low.denominator),
                                                          high_end(high.numerator / high.denominator))};
}

}  // namespace dumbbell_test
