#include "flight/orbit.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "flight/contact.hpp"

namespace dumbbell::flight {
namespace {

/// A velocity (phidot, d yhat/dt) with phidot^2 + q yhat'^2 = 1.
template <class I>
struct Velocity {
    I angular;
    I vertical;
};

template <class I>
Velocity<I> reversed(const Velocity<I>& v) {
    return {-v.angular, -v.vertical};
}

/// |phidot| on a flight of slope kappa.
template <class I>
I angular_speed(const I& kappa, const I& r) {
    return I(1) / sqrt(I(1) + sqr(kappa) / r);
}

/// A collision as the ray meets it: in the time direction of the ray, `elapsed` after its start.
template <class I>
struct Bounce {
    I elapsed;
    I psi;
    I height;
    Velocity<I> in, out;
    I grazing_sine;
};

/// Follows all rays between `low` and `high` through `count` collisions with the light walls. `kappa`
/// encloses the slopes of their first flight, `run` is the angle from the start to the corner ahead,
/// `direction` +1 if the first flight goes right. The range of each contact is attained at the two rays (L5,
/// L10). False if a collision cannot be enclosed.
template <class I, class See>
bool follow(Ray<I> low, Ray<I> high, I kappa, I run, int direction, long count, See see) {
    const I r = hull(low.r, high.r);
    I elapsed(0);
    for (long i = 0; i < count; ++i, direction = -direction) {
        const auto least = lowest_contact(low_end(low.c), low_end(low.kappa));
        const auto greatest = highest_contact(high_end(high.c), high_end(high.kappa));
        if (!least || !greatest) {
            return false;
        }
        const I x = hull(least->x, greatest->x);
        const I w = hull(greatest->cos_x, least->cos_x);
        const I speed = angular_speed(kappa, r);
        const I norm = sqr(w) + r;
        const I side(direction);
        elapsed = elapsed + (run + x) / speed;

        const auto reflection = reflect_at_light_wall(kappa, w, r);
        see(Bounce<I>{elapsed,
                      side * (half_pi<I>() + x),
                      hull(least->sin_x, greatest->sin_x),
                      {side * speed, kappa * speed},
                      {-side * speed * reflection.denominator / norm, speed * reflection.numerator / norm},
                      (w - kappa) * speed / sqrt(norm)});

        const auto lower = reflect_at_light_wall(low_end(low.kappa), least->cos_x, low_end(low.r));
        const auto upper = reflect_at_light_wall(high_end(high.kappa), greatest->cos_x, high_end(high.r));
        if (i + 1 < count &&
            !(certainly_positive(lower.denominator) && certainly_positive(upper.denominator))) {
            return false;
        }
        low.kappa = lower.numerator / lower.denominator;
        high.kappa = upper.numerator / upper.denominator;
        low.c = low_end(least->sin_x + low_end(low.kappa) * (least->x + pi<I>()));
        high.c = high_end(greatest->sin_x + high_end(high.kappa) * (greatest->x + pi<I>()));
        kappa = hull(low_end(low.kappa), high_end(high.kappa));
        run = pi<I>() + x;
    }
    return true;
}

/// Turns heights and velocities into the centre of mass's, y = beta2 yhat, and psi into phi.
template <class I>
Collision<I> physical(const Bounce<I>& b, const I& time, bool heavy, const I& beta2) {
    return {heavy,
            time,
            b.psi + half_pi<I>(),
            beta2 * b.height,
            beta2 * b.in.vertical,
            beta2 * b.out.vertical,
            b.in.angular,
            b.out.angular,
            b.grazing_sine};
}

}  // namespace

template <class I>
bool visit_orbit(const BridgeContact<I>& contact, const RatioRange<I>& range,
                 const std::function<void(const Collision<I>&)>& see) {
    const I r = hull(range.r_lo, range.r_hi);
    const I beta2 = I(1) / (I(1) + r);
    const Position<I> at = position(contact.e);
    const auto out = bridge_outgoing(at, contact.eta);
    const auto back_lo = bridge_reversed(at, contact.eta, range.r_hi);
    const auto back_hi = bridge_reversed(at, contact.eta, range.r_lo);
    // A descending slope r lambda falls when r grows, so it is no bound at either ray: the range of the first
    // slope is given apart.
    const I out_slope = r * out.lambda;
    const I in_slope = r * hull(back_lo.lambda, back_hi.lambda);
    const I out_speed = angular_speed(out_slope, r);
    const I in_speed = angular_speed(in_slope, r);
    const I bridge_norm = r * (I(1) + r * sqr(at.cos_e));
    const Bounce<I> turning{I(0),
                            half_pi<I>() - at.e,
                            r * at.sin_e,
                            reversed(Velocity<I>{in_speed, in_slope * in_speed}),
                            {-out_speed, out_slope * out_speed},
                            r * contact.eta * out_speed / sqrt(bridge_norm)};

    const auto see_later = [&](const Bounce<I>& b) { see(physical(b, b.elapsed, false, beta2)); };
    // The sine of the angle is the same before and after: |N.v| and |v| are.
    const auto see_earlier = [&](Bounce<I> b) {
        std::tie(b.in, b.out) = std::pair(reversed(b.out), reversed(b.in));
        see(physical(b, -b.elapsed, false, beta2));
    };
    see(physical(turning, I(0), true, beta2));
    return follow(lowest_over(out, range), highest_over(out, range), out_slope, pi<I>() - at.e, -1,
                  contact.forward, see_later) &&
           follow(lowest_over(back_lo, range), highest_over(back_hi, range), in_slope, at.e, +1,
                  contact.backward, see_earlier);
}

template <class I>
std::optional<std::vector<Collision<I>>> enclose_orbit(const BridgeContact<I>& contact,
                                                       const RatioRange<I>& range) {
    std::vector<Collision<I>> orbit;
    if (!visit_orbit<I>(contact, range, [&](const Collision<I>& c) { orbit.push_back(c); })) {
        return std::nullopt;
    }
    // Earlier ones were shown last, going back in time.
    std::rotate(orbit.begin(), orbit.end() - contact.backward, orbit.end());
    std::reverse(orbit.begin(), orbit.begin() + contact.backward);
    const I start = orbit.front().time;
    for (Collision<I>& c : orbit) {
        c.time = c.time - start;
    }
    orbit.front().time = I(0);
    return orbit;
}

template bool visit_orbit(const BridgeContact<Interval>&, const RatioRange<Interval>&,
                          const std::function<void(const Collision<Interval>&)>&);
template bool visit_orbit(const BridgeContact<BigInterval>&, const RatioRange<BigInterval>&,
                          const std::function<void(const Collision<BigInterval>&)>&);
template std::optional<std::vector<Collision<Interval>>> enclose_orbit(const BridgeContact<Interval>&,
                                                                       const RatioRange<Interval>&);
template std::optional<std::vector<Collision<BigInterval>>> enclose_orbit(const BridgeContact<BigInterval>&,
                                                                          const RatioRange<BigInterval>&);

}  // namespace dumbbell::flight
