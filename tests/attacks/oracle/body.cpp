#include "body.hpp"

#include "scalar.hpp"

namespace dumbbell_oracle {

template <class S>
S Dumbbell<S>::compliance(Mass mass, const State<S>& state) const {
    using std::cos;
    const S lever = arm(mass) * cos(state.phi);
    return S(1) + lever * lever / inertia();
}

template <class S>
S Dumbbell<S>::grazing_sine(Mass mass, const State<S>& state) const {
    using std::abs;
    using std::sqrt;
    return abs(climb(mass, state)) / sqrt(compliance(mass, state) * twice_energy(state));
}

template <class S>
State<S> Dumbbell<S>::bounce(Mass mass, const State<S>& state) const {
    using std::cos;
    const S lever = arm(mass) * cos(state.phi);
    const S impulse = S(-2) * climb(mass, state) / compliance(mass, state);
    State<S> after = state;
    after.ydot += impulse;
    after.phidot += impulse * lever / inertia();
    return after;
}

template <class S>
State<S> Dumbbell<S>::bounce_by_law4(Mass mass, const State<S>& state) const {
    using std::cos;
    // The paper's remark: for the heavy mass exchange beta1 and beta2 and change the sign of cos phi.
    const S b1 = mass == Mass::light ? beta1_ : beta2_;
    const S b2 = mass == Mass::light ? beta2_ : beta1_;
    const S c = mass == Mass::light ? S(cos(state.phi)) : S(-cos(state.phi));
    const S weight = b1 + b2 * c * c;
    State<S> after = state;
    after.ydot =
        state.ydot * (S(-1) + S(2) * b2 * c * c / weight) - state.phidot * (S(2) * b1 * b2 * c / weight);
    after.phidot = state.phidot * (S(1) - S(2) * b2 * c * c / weight) - state.ydot * (S(2) * c / weight);
    return after;
}

template class Dumbbell<long double>;
template class Dumbbell<Digits80>;

}  // namespace dumbbell_oracle
