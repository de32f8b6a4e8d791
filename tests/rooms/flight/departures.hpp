#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "attacks/oracle/chart.hpp"
#include "attacks/oracle/scalar.hpp"
#include "catch.hpp"
#include "flight/departure.hpp"
#include "reference.hpp"
#include "rooms/number/random.hpp"
#include "rooms/number/show.hpp"
#include "scale.hpp"

/// Boxes of departures from R to the left, and what the simulated dumbbell (tests/attacks/oracle: impulses on
/// two masses, no formula in common) does from their states.
namespace dumbbell_test {

inline constexpr long plain_cap = 200;  // of counts by plain interval evaluation

struct Span {
    double lo, hi;

    [[nodiscard]] double sample(Random& random) const {
        const int pick = random.below(4);
        return pick == 0 ? lo : pick == 1 ? hi : std::min(hi, std::max(lo, random.uniform(lo, hi)));
    }
};

/// Corner distance e, steepness eta over the wall's tangent, and r = 1/q: the chart departure.
struct DepartureBox {
    Span e, eta, r;
};
struct DepartureState {
    double e, eta, r;
};

inline std::string show(const DepartureBox& b) {
    return say("e", b.e.lo, b.e.hi, "eta", b.eta.lo, b.eta.hi, "r", b.r.lo, b.r.hi);
}
inline std::string show(const DepartureState& s) { return say("e", s.e, "eta", s.eta, "r", s.r); }

inline DepartureState sample(Random& random, const DepartureBox& box) {
    return {box.e.sample(random), box.eta.sample(random), box.r.sample(random)};
}

/// The collisions after the departure.
template <class S>
dumbbell_oracle::Run<S> simulated_run(const DepartureState& from) {
    using std::cos;
    using std::sin;
    const dumbbell_oracle::Dumbbell<S> body(S(1) / S(from.r));
    const S e(from.e);
    const S slope = S(from.eta) - cos(e);
    const dumbbell_oracle::State<S> state{S(dumbbell_oracle::pi<S>() + e), S(-1), S(body.beta2() * sin(e)),
                                          S(body.beta2() * slope)};
    return dumbbell_oracle::simulate(body, state, dumbbell_oracle::Mass::light);
}

/// What happens, in long double, and again with 80 digits where that is doubtful or `exact` is wanted.
struct Outcome {
    long collisions;
    std::optional<double> bridge_contact;  ///< psi = pi/2 - t of the next collision, if it is on the bridge
    bool doubtful;
};

template <class S>
Outcome outcome(const dumbbell_oracle::Run<S>& run) {
    Outcome result{static_cast<long>(run.collisions.size()), {}, run.care.doubtful()};
    if (!run.collisions.empty() && run.collisions[0].mass == dumbbell_oracle::Mass::heavy) {
        const S t = dumbbell_oracle::pi<S>() - run.collisions[0].before.phi;
        result.bridge_contact = static_cast<double>(t);
    }
    return result;
}

inline Outcome simulated(const DepartureState& from, bool exact = false) {
    const Outcome quick = outcome(simulated_run<long double>(from));
    if (!exact && !quick.doubtful) {
        return quick;
    }
    Outcome careful = outcome(simulated_run<dumbbell_oracle::Digits80>(from));
    careful.doubtful = quick.doubtful;
    return careful;
}

/// The corner distance at which `excess`, which grows with it, changes its sign; 0 or pi/2 if it does not.
template <class Excess>
double position_where(Excess excess) {
    double lo = 0;
    double hi = 0x1.921fb54442d18p+0;
    for (int i = 0; i < 60; ++i) {
        const double middle = (lo + hi) / 2;
        (excess(middle) < 0 ? lo : hi) = middle;
    }
    return lo;
}

/// Kinds of departures: near the corner, along the wall, near the peak, with a slope of few units of r,
/// nearly tangent to the bridge, the same after one more collision, nearly tangent to the wall ahead,
/// anywhere.
enum class Kind { corner, along, peak, flat, bridge_tangent, later_tangent, wall_tangent, anywhere };
inline constexpr Kind tangent_kinds[] = {Kind::bridge_tangent, Kind::later_tangent, Kind::wall_tangent};
inline Kind random_kind(Random& random) { return static_cast<Kind>(random.below(8)); }

/// The departure from the other wall after whose next collision the given state leaves (by reversal), if
/// there is one.
inline std::optional<DepartureState> one_earlier(const DepartureState& s) {
    const double w = std::cos(s.e);
    const double kappa = s.eta - w;
    const double turned = w * w + 2 * kappa * w - s.r;  // as L4 (2) for -kappa
    const double slope = (2 * w * s.r + kappa * s.r - kappa * w * w) / turned;
    const double height = std::sin(s.e) + slope * (s.e + 0x1.921fb54442d18p+1);
    if (!(turned > 0) || !(slope < 1)) {
        return std::nullopt;
    }
    const auto at = dumbbell::flight::guess_contact(dumbbell::Interval(height), dumbbell::Interval(slope));
    const double e = at.z.lo();
    return at.hits && std::cos(e) > slope ? std::optional(DepartureState{e, std::cos(e) - slope, s.r})
                                          : std::nullopt;
}

inline DepartureState random_departure(Random& random, Kind kind, double r) {
    constexpr double quarter_turn = 0x1.921fb54442d18p+0;
    constexpr double half_turn = 2 * quarter_turn;
    const auto with_slope = [r](double e, double kappa) {
        return DepartureState{e, std::max(0x1p-60, kappa + std::cos(e)), r};
    };
    const auto near = [&](double e) {
        const double moved = e * (1 + random.sign() * random.scaled(1e-16, 1e-3));
        return std::min(quarter_turn, std::max(moved, 1e-12));
    };
    switch (kind) {
        case Kind::corner:
            return {random.scaled(1e-12, 1e-3), random.scaled(1e-9, 2), r};
        case Kind::along:
            return {random.uniform(0.01, 1.57), random.scaled(1e-14, 1e-2), r};
        case Kind::peak:
            return with_slope(quarter_turn - random.scaled(1e-9, 0.1),
                              random.sign() * random.scaled(1e-9, 0.1));
        case Kind::flat:
            return with_slope(random.coin() ? random.uniform(0, 1.5) : r * random.uniform(0, 2),
                              r * random.uniform(-3, 2));
        case Kind::bridge_tangent: {  // at t
            const double t = random.uniform(0, half_turn);
            const double kappa = r * std::cos(t);
            return with_slope(near(position_where(
                                  [&](double e) { return std::sin(e) + kappa * (e + t) - r * std::sin(t); })),
                              kappa);
        }
        case Kind::later_tangent: {
            const auto earlier = one_earlier(random_departure(random, Kind::bridge_tangent, r));
            return earlier ? *earlier : random_departure(random, Kind::bridge_tangent, r);
        }
        case Kind::wall_tangent: {
            const double kappa = random.scaled(1e-6, 0.3);
            const double height = std::sqrt(1 - kappa * kappa) - kappa * std::acos(kappa);
            return with_slope(near(position_where(
                                  [&](double e) { return std::sin(e) + kappa * (e + half_turn) - height; })),
                              kappa);
        }
        default: {
            const double e = random.uniform(1e-3, 1.57);
            return {e, random.uniform(1e-6, 1 + std::cos(e)), r};
        }
    }
}

/// A box at a random departure: a point, or with sides of up to `widest` (relatively), to either side of it.
inline DepartureBox random_departure_box(Random& random, Kind kind, double least_r, double widest) {
    const double r = random.coin()   ? random.scaled(least_r, 1)
                     : random.coin() ? 1
                                     : 1 - random.scaled(1e-15, 0.1);
    const DepartureState from = random_departure(random, kind, r);
    const auto span = [&](double x, double most) {
        const double other =
            random.below(3) == 0 ? x : x * std::exp(random.sign() * random.scaled(1e-16, widest));
        return Span{std::min({x, other, most}), std::min(std::max(x, other), most)};
    };
    return {span(from.e, 0x1.921fb54442d18p+0), span(from.eta, 2), span(r, 1)};
}
inline DepartureBox random_departure_box(Random& random, double least_r, double widest) {
    return random_departure_box(random, random_kind(random), least_r, widest);
}

template <class I>
dumbbell::flight::RatioRange<I> ratios_of(const DepartureBox& box) {
    return {I(box.r.lo), I(box.r.hi)};
}

/// The number of collisions from a sampled state; fails if it is greater than the bound for its box.
inline long sampled_within(Random& random, const DepartureBox& box, long most) {
    const DepartureState state = sample(random, box);
    long found = simulated(state).collisions;
    if (found > most) {
        found = simulated(state, true).collisions;
    }
    if (found > most) {
        FAIL(say("from", state, "there are", found, "collisions, the bound is", most, "for", box));
    }
    return found;
}

}  // namespace dumbbell_test
