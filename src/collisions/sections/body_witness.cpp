#include "collisions/sections/body_witness.hpp"

#include <cmath>
#include <vector>

#include "flight/certain_count.hpp"

namespace dumbbell::collisions {
namespace {

/// `steps` places on the way down from `end`, ends excluded, and powers of two and the middles between them,
/// down to 2^-40. Long orbits start close to the corner, to the top, and to tangents of the bridge; the
/// first that is found is large enough to be seen.
std::vector<double> places(double end, int steps) {
    std::vector<double> all;
    for (int i = steps - 1; i > 0; --i) {
        // Few bits: the file spells them.
        all.push_back(std::ldexp(std::round(std::ldexp(end * i / steps, 16)), -16));
    }
    for (int depth = 3; depth <= 40; ++depth) {
        for (const double size : {1.5, 1.0}) {
            all.push_back(std::ldexp(size, -depth));
        }
    }
    return all;
}

/// Of the contacts of a grid the first one with `enough` collisions, or else one with the most.
Witness best_contact(const flight::Body<Interval>& body, long enough, const Interrupted& interrupted) {
    constexpr double right_angle = 1.5707963267948966;
    std::vector<double> distances = places(right_angle, 48);
    for (int depth = 20; depth > 2; --depth) {
        distances.push_back(1.5707 - std::ldexp(1.0, -depth));
    }
    const std::vector<double> slopes = places(1 + 1 / approximate(body.rho), 96);
    Witness best{0, 0, 0, 0};
    for (const double e : distances) {
        for (const double eta : slopes) {
            const auto rays = contact_rays(Interval(e), Interval(eta), body);
            const long forward = certain_count(rays.outgoing, body, enough - 1);
            const long backward = certain_count(rays.reversed, body, enough - 1 - forward);
            if (forward + backward > best.forward + best.backward) {
                best = {exact(e), exact(eta), forward, backward};
            }
        }
        if (best.total() >= enough || interrupted()) {
            break;
        }
    }
    return best;
}

flight::Body<Interval> bodies_of(const Range& q, const Range& rho) {
    using Body = flight::Body<Interval>;
    const Interval r = hull(enclose<Interval>(1 / q.hi), enclose<Interval>(1 / q.lo));
    return rho.lo * q.lo == 1 && rho.hi * q.hi == 1
               ? Body::massless(r)
               : Body::with_mass(hull(enclose<Interval>(rho.lo), enclose<Interval>(rho.hi)), r);
}

}  // namespace

long greatest_found(const Rational& q, const Rational& rho, const Interrupted& interrupted) {
    constexpr long most = 1000;
    return as_long(best_contact(bodies_of({q, q}, {rho, rho}), most, interrupted).total());
}

std::optional<Witness> found_contact(const Range& range, const System& system, long target,
                                     const Interrupted& interrupted) {
    const Witness best = best_contact(bodies_of(range, *system.rho), target, interrupted);
    return best.total() >= target ? std::optional(best) : std::nullopt;
}

}  // namespace dumbbell::collisions
