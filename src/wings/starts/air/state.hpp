#pragma once

#include "flight/body.hpp"
#include "number/elementary.hpp"

/// A body over the floor in free flight and at a contact, by the angle phi of its rod, without any chart:
/// lemma L0; also of a rigid body (L70).
namespace dumbbell::starts {

/// A moment of a flight: phi (radians; psi = phi - pi/2), the centre of mass's height yhat = y / d1 (of
/// massless dumbbells y / beta2), their velocities, the body, and the time.
template <class S>
struct State {
    S phi;
    S yhat;
    S phidot;
    S yhatdot;
    flight::Body<S> body;
    S time;
};

/// All its numbers changed by f.
template <class S, class F>
[[nodiscard]] auto mapped(const State<S>& s, const F& f) {
    using T = decltype(f(s.phi));
    const auto& [rho, r, g, is_massless] = s.body;
    return State<T>{f(s.phi), f(s.yhat), f(s.phidot), f(s.yhatdot), {f(rho), f(r), f(g), is_massless},
                    f(s.time)};
}

/// Where all its numbers lie.
template <class S>
[[nodiscard]] State<Enclosure<S>> ranges_of(const State<S>& s) {
    return mapped(s, [](const S& x) { return Enclosure<S>(range(x)); });
}

/// The flight `t` after a state: its sine and cosine serve both ends.
template <class S>
class Moment {
  public:
    Moment(const State<S>& s, const S& t) : s_(s), t_(t), at_(sin_cos(s.phi + s.phidot * t)) {}

    /// The height of an end, in units of d1.
    [[nodiscard]] S clearance(flight::End end) const {
        return s_.yhat + s_.yhatdot * t_ + turned(end, s_.body.leveraged(end, at_.sin));
    }
    /// Its derivative in time.
    [[nodiscard]] S clearance_rate(flight::End end) const {
        return s_.yhatdot + turned(end, s_.body.leveraged(end, s_.phidot * at_.cos));
    }

  private:
    const State<S>& s_;
    S t_;
    SinCos<S> at_;
};

template <class S>
[[nodiscard]] S clearance(const State<S>& s, flight::End end, const S& t) {
    return Moment<S>(s, t).clearance(end);
}
template <class S>
[[nodiscard]] S clearance_rate(const State<S>& s, flight::End end, const S& t) {
    return Moment<S>(s, t).clearance_rate(end);
}

/// A contact: the states before and after it differ in their velocities only.
template <class S>
struct Bounce {
    flight::End end;
    State<S> before;
    State<S> after;
};

/// The rate at which an end of this state rises, where c = cos phi: N.v of L0.
template <class S>
[[nodiscard]] S rise_of(const State<S>& s, flight::End end, const S& c) {
    return s.yhatdot + turned(end, s.body.leveraged(end, c) * s.phidot);
}

/// The elastic reflection (1) of L0 when `end` reaches the floor `t` after `s`. With its leverage l, its
/// weight w, c = cos phi, and N.v = yhatdot + l c phidot (light) or yhatdot - l c phidot (heavy),
///   phidot' = phidot -+ 2 N.v c/(w + l c^2),   yhatdot' = yhatdot - 2 N.v w/(w + l c^2).
template <class S>
[[nodiscard]] Bounce<S> bounce(const State<S>& s, flight::End end, const S& t) {
    const S phi = s.phi + s.phidot * t;
    const SinCos<S> at = sin_cos(phi);
    const State<S> before{phi, s.body.contact_height(end, at.sin), s.phidot, s.yhatdot, s.body, s.time + t};
    State<S> after = before;
    const S push = S(2) * rise_of(s, end, at.cos) / s.body.resistance(end, at.cos);
    after.phidot = s.phidot - turned(end, push * at.cos);
    after.yhatdot = s.yhatdot - s.body.weighted(end, push);
    return {end, before, after};
}

}  // namespace dumbbell::starts
