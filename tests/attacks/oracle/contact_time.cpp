#include "contact_time.hpp"

#include <type_traits>

#include "scalar.hpp"

namespace dumbbell_oracle {
namespace {

// height(t) = start + climb t + arm sin(angle + spin t), spin >= 0 (a negative spin mirrors angle and arm).
template <class S>
struct HeightCurve {
    S start;
    S climb;
    S arm;
    S angle;
    S spin;

    [[nodiscard]] S value(const S& t) const {
        using std::sin;
        return start + climb * t + arm * sin(angle + spin * t);
    }
    [[nodiscard]] S slope(const S& t) const {
        using std::cos;
        return climb + arm * spin * cos(angle + spin * t);
    }
};

// Root in [lo, hi] with value(lo) >= 0 > value(hi), value decreasing: Newton kept inside a shrinking bracket.
template <class S>
S bracketed_root(const HeightCurve<S>& curve, S lo, S hi) {
    using std::abs;
    S t = (lo + hi) / 2;
    if constexpr (!std::is_same_v<S, double>) {
        // Only a first guess: the bracket decides.
        const HeightCurve<double> rough{static_cast<double>(curve.start), static_cast<double>(curve.climb),
                                        static_cast<double>(curve.arm), static_cast<double>(curve.angle),
                                        static_cast<double>(curve.spin)};
        const S guess = bracketed_root(rough, static_cast<double>(lo), static_cast<double>(hi));
        if (guess > lo && guess < hi) t = guess;
    }
    S previous_width = hi - lo;
    // Rounding of the angle alone moves the root by this much; a smaller step means nothing.
    const S noise = curve.spin > 0 ? S(unit_roundoff<S>() * abs(curve.angle) / curve.spin) : S(0);
    for (int i = 0; i < 2000; ++i) {
        const S value = curve.value(t);
        if (value == 0) return t;
        (value > 0 ? lo : hi) = t;
        const S slope = curve.slope(t);
        S next = slope < 0 ? S(t - value / slope) : S(lo);
        // Bisect whenever Newton leaves the bracket or two steps have not halved it.
        if (!(next > lo && next < hi) || (i % 3 == 2 && hi - lo > previous_width / 2)) next = (lo + hi) / 2;
        if (i % 3 == 2) previous_width = hi - lo;
        const S step = abs(next - t);
        t = next;
        if (step <= noise + 2 * unit_roundoff<S>() * abs(t) || !(lo < t && t < hi)) return t;
    }
    return t;
}

// Least angle > from that is congruent to target modulo a full turn.
template <class S>
S next_angle(const S& target, const S& from) {
    using std::floor;
    const S turn = 2 * pi<S>();
    S angle = target + turn * (floor((from - target) / turn) + 1);
    if (angle <= from) angle += turn;
    return angle;
}

}  // namespace

template <class S>
NextContact<S> next_contact(const Dumbbell<S>& body, Mass mass, const State<S>& state, bool touching) {
    using std::abs;
    using std::acos;
    using std::floor;
    const bool mirror = state.phidot < 0;
    const HeightCurve<S> curve{state.y, state.ydot, mirror ? S(-body.arm(mass)) : body.arm(mass),
                               mirror ? S(-state.phi) : state.phi, abs(state.phidot)};
    const S size = abs(curve.arm);

    // slope = 0  <=>  cos(angle) = stationary. Without stationary points the height is monotone.
    if (curve.spin == 0 || abs(curve.climb) >= size * curve.spin) {
        if (curve.climb >= 0 || touching) return {std::nullopt, S(1)};
        const S below = (curve.start + 2 * size) / -curve.climb;  // value there <= -size
        return {bracketed_root(curve, S(0), below), S(1)};
    }
    const S acute = acos(-curve.climb / (curve.arm * curve.spin));
    // The second derivative is -arm spin^2 sin: a minimum where arm sin < 0.
    const S minimum_at = curve.arm > 0 ? S(-acute) : acute;
    const S turn = 2 * pi<S>();
    // A touching mass rises first, to its next maximum; the minimum wanted comes after that.
    const S ignore_until = touching ? next_angle(S(-minimum_at), curve.angle) : curve.angle;
    const S angle = next_angle(minimum_at, ignore_until);
    S time = (angle - curve.angle) / curve.spin;
    const S depth = curve.value(time);
    S clearance = depth >= 0 ? S(depth / size) : S(1);
    const S period = turn / curve.spin;
    if (depth >= 0) {
        if (curve.climb >= 0) return {std::nullopt, clearance};  // later minima are no lower
        const S turns = floor(depth / (-curve.climb * period)) + 1;
        clearance = (depth + (turns - 1) * curve.climb * period) / size;
        time += turns * period;
        if (!(curve.value(time) < 0)) time += period;
    }
    // The height falls from the maximum before this minimum.
    const S fall = curve.arm > 0 ? S(turn - 2 * acute) : S(2 * acute);
    S from = time - fall / curve.spin;
    if (from < 0) from = 0;
    if (curve.value(from) <= 0) return {from, clearance};  // only by rounding, next to a corner
    return {bracketed_root(curve, from, time), clearance};
}

template NextContact<long double> next_contact(const Dumbbell<long double>&, Mass, const State<long double>&,
                                               bool);
template NextContact<Digits80> next_contact(const Dumbbell<Digits80>&, Mass, const State<Digits80>&, bool);

}  // namespace dumbbell_oracle
