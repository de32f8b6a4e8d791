#include "chart.hpp"

#include "scalar.hpp"

namespace dumbbell_oracle {
namespace {

// To the left: phi falls, at unit speed.
template <class S>
Contact<S> leaving_left(const Dumbbell<S>& body, Mass mass, const S& phi, const S& slope) {
    using std::sin;
    return {mass, {phi, S(-1), S(-body.arm(mass) * sin(phi)), S(body.beta2() * slope)}};
}

}  // namespace

template <class S>
Contact<S> contact_of(const Dumbbell<S>& body, const BridgeState<S>& state) {
    using std::cos;
    return leaving_left(body, Mass::heavy, S(pi<S>() - state.e),
                        S((cos(state.e) + state.eta) / body.ratio()));
}

template <class S>
Contact<S> contact_of(const Dumbbell<S>& body, const LightState<S>& state) {
    return leaving_left(body, Mass::light, S(pi<S>() + state.e), S(state.lambda / body.ratio()));
}

template <class S>
S psi_of(const State<S>& state) {
    return state.phi - pi<S>() / 2;
}

template <class S>
S slope_of(const Dumbbell<S>& body, const State<S>& state) {
    using std::abs;
    return state.ydot / (body.beta2() * abs(state.phidot));
}

template <class S>
Place<S> place_of(Mass mass, const State<S>& state) {
    using std::abs;
    using std::floor;
    const S turn = 2 * pi<S>();
    const S cell = floor((psi_of(state) + pi<S>()) / turn);
    const S psi = psi_of(state) - cell * turn;
    const int side = psi < 0 ? -1 : 1;
    const Wall wall = mass == Mass::heavy ? Wall::bridge : side < 0 ? Wall::left : Wall::right;
    const S from_middle = abs(psi);
    const S e = mass == Mass::heavy ? S(pi<S>() / 2 - from_middle) : S(from_middle - pi<S>() / 2);
    return {static_cast<long>(cell), wall, side, e};
}

template <class S>
std::optional<BridgeState<S>> bridge_state_of(const Dumbbell<S>& body, const Collision<S>& collision) {
    using std::cos;
    if (collision.mass != Mass::heavy) return std::nullopt;
    const Place<S> place = place_of(collision.mass, collision.after);
    for (const State<S>& ray : {collision.after, reversed(collision.before)}) {
        if (ray.phidot * place.side < 0) {
            return BridgeState<S>{place.e, S(slope_of(body, ray) * body.ratio() - cos(place.e))};
        }
    }
    return std::nullopt;
}

template <class S>
std::optional<LightState<S>> light_state_of(const Dumbbell<S>& body, const Collision<S>& collision) {
    if (collision.mass != Mass::light || collision.before.ydot > 0 || collision.after.ydot < 0)
        return std::nullopt;
    const Place<S> place = place_of(collision.mass, collision.after);
    for (const State<S>& ray : {collision.after, reversed(collision.before)}) {
        if (ray.phidot * place.side < 0 && slope_of(body, ray) < 1) {
            return LightState<S>{place.e, S(slope_of(body, ray) * body.ratio())};
        }
    }
    return std::nullopt;
}

#define DUMBBELL_ORACLE_INSTANTIATE(S)                                                               \
    template Contact<S> contact_of(const Dumbbell<S>&, const BridgeState<S>&);                       \
    template Contact<S> contact_of(const Dumbbell<S>&, const LightState<S>&);                        \
    template S psi_of(const State<S>&);                                                              \
    template S slope_of(const Dumbbell<S>&, const State<S>&);                                        \
    template Place<S> place_of(Mass, const State<S>&);                                               \
    template std::optional<BridgeState<S>> bridge_state_of(const Dumbbell<S>&, const Collision<S>&); \
    template std::optional<LightState<S>> light_state_of(const Dumbbell<S>&, const Collision<S>&);
DUMBBELL_ORACLE_INSTANTIATE(long double)
DUMBBELL_ORACLE_INSTANTIATE(Digits80)
#undef DUMBBELL_ORACLE_INSTANTIATE

}  // namespace dumbbell_oracle
