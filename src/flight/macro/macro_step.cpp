#include "flight/macro/macro_step.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "base/ended_early.hpp"
#include "flight/macro/orbit_guess.hpp"

namespace dumbbell::flight::macro {
namespace {

using namespace macro;

/// How closely the polynomials are to follow the orbit, as a share of one collision, and with what.
struct Effort {
    double root_bits;  ///< of 1/root, root the square root of r
    long share_bits;   ///< 2^-share_bits of a collision's progress is lost in all
    long least;        ///< a step over fewer collisions is not worth it

    /// What both sides of L42 (6), (7), times collisions/2, are found to within, for a step over so many.
    [[nodiscard]] double resolution(const Count& collisions) const {
        return 2 * root_bits + static_cast<double>(share_bits) + 1 -
               std::log2(static_cast<double>(collisions));
    }
    [[nodiscard]] int bits(const Count& collisions) const {
        return static_cast<int>(resolution(collisions)) + 16;
    }
    [[nodiscard]] slong terms(const Count& collisions) const {
        return static_cast<slong>(resolution(collisions) / 2.2) + 4;
    }
};
Effort effort(double root_bits, int bound_bits) {
    const bool in_double = bound_bits == 53;
    const auto share =
        static_cast<long>(std::clamp(bound_bits - root_bits - 4, 8., std::max(12., bound_bits / 4. - 20)));
    Effort result{root_bits, share, 2000};
    if (!in_double || root_bits >= 30) {
        result.least = 40 + result.terms(1);
    }
    return result;
}

/// About how many collisions are left before the peak is reached. With the angle th, kappa = root tan th, the
/// orbit nearly keeps P = (2 x + pi) cos th, which leaves an integral over x = pi/2 - depth + u^2. At most
/// sqrt(depth) / sqrt(2 end) / root <= 0.71 / root, as is each of the sum's terms.
double collisions_left(double depth, double kappa, double root) {
    constexpr int nodes = 32;
    const double end = std::numbers::pi - depth;
    const double angle = std::atan(kappa / root);
    const double least = end * end * std::sin(angle) * std::sin(angle);
    const double range = std::sqrt(depth);
    double sum = 0;
    for (int i = 0; i < nodes; ++i) {
        const double u = range * (i + 0.5) / nodes;
        sum += std::sin(depth - u * u) * u / ((end + u * u) * std::sqrt(u * u * (2 * end + u * u) + least));
    }
    return end * std::cos(angle) * sum * range / nodes / root;
}

template <class I>
int working_bits() {
    return std::is_same_v<I, Interval> ? 53 : PrecisionScope::current();
}
Ball ball(const Interval& x) { return Ball(x.lo()); }
Ball ball(const BigInterval& x) { return Ball(x); }

void round_to(Interval& bound, const Ball& x, bool up, int /*bits*/) {
    bound = Interval(arf_get_d(arb_midref(end(x, up).raw()), up ? ARF_RND_CEIL : ARF_RND_FLOOR));
}
void round_to(BigInterval& bound, const Ball& x, bool up, int bits) {
    const Ball exact = end(x, up);
    arf_set_round(bound.lower(), arb_midref(exact.raw()), bits, up ? ARF_RND_CEIL : ARF_RND_FLOOR);
    arf_set(bound.upper(), bound.lower());
}

template <class I>
Count stepped(BoundSide side, const I& r, WallState<I>& state, const Count& most,
              const Interrupted& interrupted) try {
    const bool above = side == BoundSide::upper;
    const int bound_bits = working_bits<I>();
    const double depth = approximate(half_pi<I>() - state.x);
    const double root = std::sqrt(approximate(r));
    const Effort work = effort(-std::log2(root), bound_bits);
    const double left = collisions_left(depth, approximate(state.kappa), root);
    const double longest = std::min(0.33 * left, static_cast<double>(most));
    if (!std::isfinite(longest)) return 0;

    const int at_start = 8 + static_cast<int>(-std::log2(std::clamp(approximate(state.x), root * root, 1.)));
    for (double length = longest; length >= static_cast<double>(work.least); length /= 2) {
        const Count collisions(length);
        // X_0 >= 0, which a lower bound needs, may be far below its neighbours.
        const PrecisionScope scope(std::max(work.bits(collisions), at_start));
        Task task;
        task.r = ball(r);
        task.x = ball(state.x);
        task.kappa = ball(state.kappa);
        task.collisions = collisions;
        task.terms = work.terms(collisions);
        task.interrupted = interrupted;
        const Ball unit = whole(collisions) * power_of_two(-1 - work.share_bits) * task.r;
        task.x_excess = middle(above ? unit : Ball(-1) * unit);
        task.kappa_excess = middle(task.x_excess * Ball(root));
        auto orbit = guess_orbit(task);
        if (!orbit) continue;
        // From there on the polynomials start at a bound of the state.
        const auto start = [&](Series& p, const Ball& value) {
            p.set(0, end(p[0] + value - p.at(Ball(-1)), above));
        };
        start(orbit->x, task.x);
        start(orbit->kappa, task.kappa);
        if (!is_macro_step(side, *orbit, task)) continue;
        round_to(state.x, orbit->x.at(Ball(1)), above, bound_bits);
        round_to(state.kappa, orbit->kappa.at(Ball(1)), above, bound_bits);
        return collisions;
    }
    return 0;
} catch (const EndedEarly&) {
    return 0;
}

}  // namespace

template <>
Count macro_step(BoundSide side, const Interval& r, WallState<Interval>& state, const Count& most,
                 const Interrupted& interrupted) {
    return stepped(side, r, state, most, interrupted);
}
template <>
Count macro_step(BoundSide side, const BigInterval& r, WallState<BigInterval>& state, const Count& most,
                 const Interrupted& interrupted) {
    return stepped(side, r, state, most, interrupted);
}

template <>
long least_worth_a_macro_step<BigInterval>() {
    // More bits make the polynomials dearer than the collisions. With few bits a macro step costs little, but
    // loses so many of them that the next precision has to be tried.
    const long bits = PrecisionScope::current();
    return std::max(5'000L, bits * bits / 30);
}

}  // namespace dumbbell::flight::macro
