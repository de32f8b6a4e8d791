#pragma once

#include <vector>

#include "reference.hpp"

namespace dumbbell_test {

/// A collision as the dumbbell has it, see flight/orbit.hpp.
struct Event {
    bool heavy;
    Real time, phi, y, ydot_before, ydot_after, phidot_before, phidot_after, grazing_sine;
};

/// Positions and velocities in (psi, yhat), in the unit of time in which the kinetic norm is 1.
struct Bump {
    Real elapsed, psi, yhat;
    Vector<Real> before, after;
};

inline Real kinetic_norm(const Vector<Real>& v, const Real& r) {
    return sqrt(v.angular * v.angular + v.vertical * v.vertical / r);
}

/// The slope of the floor curve under psi: of a light wall beyond +-pi/2, of the bridge between.
inline Real floor_slope(const Real& psi, const Real& r) {
    return abs(psi) > pi_in<Real>() / 2 ? Real(sin(psi)) : Real(-r * sin(psi));
}

/// The next `count` collisions with light walls from (psi, yhat), or fewer if there are no more.
inline std::vector<Bump> follow(Real psi, Real yhat, Vector<Real> v, const Real& r, std::size_t count) {
    std::vector<Bump> bumps;
    Real elapsed = 0;
    const Real half_turn = pi_in<Real>();
    while (bumps.size() < count) {
        const int side = v.angular > 0 ? 1 : -1;
        const Real speed = abs(v.angular);
        const Real kappa = v.vertical / speed;
        const Real run = half_turn / 2 - side * psi;
        if (kappa >= 1) {
            break;
        }
        const auto to_wall = exact_flight(Real(yhat + kappa * run), kappa);
        if (!to_wall.hits) {
            break;
        }
        elapsed += (run + to_wall.x) / speed;
        psi = side * (half_turn / 2 + to_wall.x);
        yhat = -cos(psi);
        const Vector<Real> after = reflect(v, floor_slope(psi, r), r);
        bumps.push_back({elapsed, psi, yhat, v, after});
        v = after;
        if (side * v.angular >= 0) {
            break;
        }
    }
    return bumps;
}

/// All collisions of the orbit through the chart-bridge state (e, eta), at most the given numbers after and
/// before.
inline std::vector<Event> orbit_through(const Real& e, const Real& eta, const Real& r, std::size_t forward,
                                        std::size_t backward) {
    const Real psi = pi_in<Real>() / 2 - e;
    const Real yhat = r * sin(e);
    Vector<Real> out{Real(-1), r * (cos(e) + eta)};
    const Real norm = kinetic_norm(out, r);
    out = {out.angular / norm, out.vertical / norm};
    const Vector<Real> in = reflect(out, floor_slope(psi, r), r);

    std::vector<Bump> bumps;
    for (const Bump& b : follow(psi, yhat, {-in.angular, -in.vertical}, r, backward)) {
        bumps.insert(bumps.begin(), {-b.elapsed,
                                     b.psi,
                                     b.yhat,
                                     {-b.after.angular, -b.after.vertical},
                                     {-b.before.angular, -b.before.vertical}});
    }
    const std::size_t turning = bumps.size();
    bumps.push_back({Real(0), psi, yhat, in, out});
    const auto later = follow(psi, yhat, out, r, forward);
    bumps.insert(bumps.end(), later.begin(), later.end());

    std::vector<Event> events;
    const Real beta2 = 1 / (1 + r);
    for (std::size_t i = 0; i < bumps.size(); ++i) {
        const Bump& b = bumps[i];
        const Real slope = floor_slope(b.psi, r);
        const Real approach = slope * b.before.angular - b.before.vertical;  // -N.v
        events.push_back({i == turning, b.elapsed - bumps[0].elapsed, b.psi + pi_in<Real>() / 2,
                          beta2 * b.yhat, beta2 * b.before.vertical, beta2 * b.after.vertical,
                          b.before.angular, b.after.angular, approach / sqrt(slope * slope + r)});
    }
    return events;
}

}  // namespace dumbbell_test
