#pragma once

#include "flight/plain.hpp"
#include "number/elementary.hpp"

/// The dumbbell over the floor in free flight and at a contact, by the angle phi of its rod, without any
/// chart: lemma L0. Also bodies with mass between their contacts (L70): then `light` is the end at the
/// distance d1 from the centre of mass, `heavy` the one at d2.
namespace dumbbell::starts {

enum class Mass { light, heavy };

/// A moment of a flight: phi (radians; psi = phi - pi/2), the centre of mass's height yhat = y / beta2 (of
/// bodies y / d1), their velocities, the mass ratio as r = 1/q (1/Q), and the time.
template <class S>
struct State {
    S phi;
    S yhat;
    S phidot;
    S yhatdot;
    S r;
    S time;
    S rho = r;             ///< d2/d1 of a body
    bool is_body = false;  ///< else the massless dumbbell, whose rho is r, whatever `rho` says

    /// The highest point of the floor under the heavy end.
    [[nodiscard]] const S& heavy_height() const { return is_body ? rho : r; }
};

/// All its numbers changed by f.
template <class S, class F>
[[nodiscard]] auto mapped(const State<S>& s, const F& f) {
    using T = decltype(f(s.phi));
    return State<T>{f(s.phi), f(s.yhat), f(s.phidot), f(s.yhatdot), f(s.r), f(s.time), f(s.rho), s.is_body};
}

/// Its numbers as flights from wall to wall have them.
template <class I>
[[nodiscard]] flight::Body<I> body_of(const State<I>& s) {
    return s.is_body ? flight::Body<I>(s.rho, s.r, false) : flight::Body<I>(s.r);
}

/// The flight `t` after a state: its sine and cosine serve both masses.
template <class S>
class Moment {
  public:
    Moment(const State<S>& s, const S& t) : s_(s), t_(t), at_(sin_cos(s.phi + s.phidot * t)) {}

    /// The height of a mass, in units of beta2: yhat + sin phi (light), yhat - rho sin phi (heavy).
    [[nodiscard]] S clearance(Mass mass) const {
        const S height = s_.yhat + s_.yhatdot * t_;
        return mass == Mass::light ? height + at_.sin : height - s_.heavy_height() * at_.sin;
    }
    /// Its derivative in time.
    [[nodiscard]] S clearance_rate(Mass mass) const {
        const S turning = s_.phidot * at_.cos;
        return mass == Mass::light ? s_.yhatdot + turning : s_.yhatdot - s_.heavy_height() * turning;
    }

  private:
    const State<S>& s_;
    S t_;
    SinCos<S> at_;
};

template <class S>
[[nodiscard]] S clearance(const State<S>& s, Mass mass, const S& t) {
    return Moment<S>(s, t).clearance(mass);
}
template <class S>
[[nodiscard]] S clearance_rate(const State<S>& s, Mass mass, const S& t) {
    return Moment<S>(s, t).clearance_rate(mass);
}

/// A contact: the states before and after it differ in their velocities only.
template <class S>
struct Bounce {
    Mass mass;
    State<S> before;
    State<S> after;
};

/// The elastic reflection (1) of L0 when `mass` reaches the floor `t` after `s`. With c = cos phi the wall's
/// slope is -c (light) or r c (heavy), N.v = yhatdot + c phidot or yhatdot - r c phidot, and
///   light: phidot' = phidot - 2 N.v c/(c^2 + r),     yhatdot' = yhatdot - 2 N.v r/(c^2 + r),
///   heavy: phidot' = phidot + 2 N.v c/(1 + r c^2),   yhatdot' = yhatdot - 2 N.v /(1 + r c^2),
/// and of a body with rho, where N.v = yhatdot - rho c phidot and g = r/rho,
///   heavy: phidot' = phidot + 2 N.v c/(g + rho c^2), yhatdot' = yhatdot - 2 N.v g/(g + rho c^2).
template <class S>
[[nodiscard]] Bounce<S> bounce(const State<S>& s, Mass mass, const S& t) {
    const S phi = s.phi + s.phidot * t;
    const SinCos<S> at = sin_cos(phi);
    const bool light = mass == Mass::light;
    const State<S> before{
        phi,      light ? -at.sin : s.heavy_height() * at.sin, s.phidot, s.yhatdot, s.r, s.time + t, s.rho,
        s.is_body};
    State<S> after = before;
    const S two(2);
    if (light) {
        const S push = two * (s.yhatdot + at.cos * s.phidot) / (sqr(at.cos) + s.r);
        after.phidot = s.phidot - push * at.cos;
        after.yhatdot = s.yhatdot - push * s.r;
    } else if (s.is_body) {
        const S g = s.r / s.rho;
        const S push = two * (s.yhatdot - s.rho * at.cos * s.phidot) / (g + s.rho * sqr(at.cos));
        after.phidot = s.phidot + push * at.cos;
        after.yhatdot = s.yhatdot - push * g;
    } else {
        const S push = two * (s.yhatdot - s.r * at.cos * s.phidot) / (S(1) + s.r * sqr(at.cos));
        after.phidot = s.phidot + push * at.cos;
        after.yhatdot = s.yhatdot - push;
    }
    return {mass, before, after};
}

}  // namespace dumbbell::starts
