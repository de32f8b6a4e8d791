// The physical dumbbell: rod of length 1, masses m1 = 1/(1+q) (light) and m2 = q/(1+q) (heavy), floor at
// height 0. Everything here is mechanics of two points on a rod; no formula of src/ or proofs/ is used.
#pragma once

#include <cmath>

namespace dumbbell_oracle {

enum class Mass { none, light, heavy };

[[nodiscard]] constexpr Mass other(Mass mass) { return mass == Mass::light ? Mass::heavy : Mass::light; }

// phi: the paper's rod angle; y: height of the centre of mass.
template <class S>
struct State {
    S phi;
    S phidot;
    S y;
    S ydot;
};

template <class S>
[[nodiscard]] State<S> reversed(State<S> state) {
    state.phidot = -state.phidot;
    state.ydot = -state.ydot;
    return state;
}

template <class S>
class Dumbbell {
  public:
    explicit Dumbbell(const S& ratio)
        : ratio_(ratio),
          beta1_(S(1) / (S(1) + ratio)),
          beta2_(ratio / (S(1) + ratio)),
          inertia_(beta1_ * beta2_) {}

    // Any rigid body of mass 1 with two contacts: their distances from the centre of mass, the greater one
    // first
    // ("light"), and its moment of inertia.
    Dumbbell(const S& far, const S& near, const S& inertia)
        : ratio_(far / near), beta1_(near), beta2_(far), inertia_(inertia) {}

    [[nodiscard]] const S& ratio() const { return ratio_; }
    [[nodiscard]] const S& beta1() const {
        return beta1_;
    }  // = m1, distance of the heavy mass from the centre
    [[nodiscard]] const S& beta2() const {
        return beta2_;
    }  // = m2, distance of the light mass from the centre
    [[nodiscard]] const S& inertia() const { return inertia_; }

    // The mass stands at arm * (cos phi, sin phi) from the centre of mass.
    [[nodiscard]] S arm(Mass mass) const { return mass == Mass::light ? beta2_ : S(-beta1_); }

    [[nodiscard]] S height(Mass mass, const State<S>& state) const {
        using std::sin;
        return state.y + arm(mass) * sin(state.phi);
    }

    // Vertical velocity of one mass.
    [[nodiscard]] S climb(Mass mass, const State<S>& state) const {
        using std::cos;
        return state.ydot + arm(mass) * state.phidot * cos(state.phi);
    }

    // Twice the kinetic energy (total mass 1).
    [[nodiscard]] S twice_energy(const State<S>& state) const {
        return state.ydot * state.ydot + inertia() * state.phidot * state.phidot;
    }

    // 1 / effective mass that a vertical impulse on `mass` meets: 1/m + lever^2 / I, lever = horizontal
    // distance.
    [[nodiscard]] S compliance(Mass mass, const State<S>& state) const;

    // |sine| of the angle between path and wall in the metric of the kinetic energy: 0 grazing, 1 head-on.
    [[nodiscard]] S grazing_sine(Mass mass, const State<S>& state) const;

    // Elastic contact by impulse: the vertical velocity of the touching mass changes its sign.
    [[nodiscard]] State<S> bounce(Mass mass, const State<S>& state) const;

    // The same contact by law (4) of the paper and its remark (for the heavy mass). Tests compare the two.
    [[nodiscard]] State<S> bounce_by_law4(Mass mass, const State<S>& state) const;

  private:
    S ratio_;
    S beta1_;
    S beta2_;
    S inertia_;
};

}  // namespace dumbbell_oracle
