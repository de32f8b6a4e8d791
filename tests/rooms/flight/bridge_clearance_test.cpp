#include "flight/bridge_clearance.hpp"

#include "catch.hpp"
#include "rays.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

/// The least height of a ray from R over the bridge, sin e + kappa (e + t) - r sin t for t in [0, pi]: convex
/// in t. Negative iff the ray crosses the bridge.
Real least_clearance(const Real& e, const Real& kappa, const Real& r) {
    const Real t = kappa >= r ? Real(0) : Real(acos(kappa / r));
    return sin(e) + kappa * (e + t) - r * sin(t);
}

struct State {
    double e, lambda, r_lo, r_hi;
};

State random_state(Random& random) {
    State state{};
    state.r_hi = random_r(random, 1e-4);
    state.r_lo = random.coin() ? state.r_hi : state.r_hi * (1 - random.scaled(1e-15, 0.5));
    state.e = random.coin() ? state.r_lo * random.uniform(0, 1.2) : random.scaled(1e-12, 1.57);
    state.lambda = random.coin() ? random.uniform(0, 1.1) : random.scaled(1e-12, 1);
    return state;
}

template <class I>
bool meets(const State& s) {
    return certainly_meets_bridge(flight::position(I(s.e)), I(s.lambda),
                                  flight::RatioRange<I>{I(s.r_lo), I(s.r_hi)});
}

std::string show(const State& s) { return say("e", s.e, "lambda", s.lambda, "r", s.r_lo, s.r_hi); }

}  // namespace

TEST_CASE("Where the bridge is certainly met, every lower and flatter ray crosses it at every ratio") {
    Random random(171);
    int certain = 0;
    for (int i = 0; i < 12'000; ++i) {
        const PrecisionScope scope(6 + random.below(35));
        const State s = random_state(random);
        if (i % 2 == 0 ? !meets<Interval>(s) : !meets<BigInterval>(s)) {
            continue;
        }
        ++certain;
        for (int j = 0; j < 4; ++j) {
            const Real e = s.e * (j < 2 ? Real(1) : Real(random.uniform(0, 1)));
            const Real r =
                j % 2 == 0 ? Real(s.r_lo) : Real(s.r_lo) + (Real(s.r_hi) - s.r_lo) * random.uniform(0, 1);
            const Real kappa = r * s.lambda * (j < 2 ? Real(1) : Real(random.uniform(0, 1)));
            if (!(least_clearance(e, kappa, r) < 0)) {
                FAIL(say(s, "but a ray passes: e", e, "kappa", kappa, "r", r));
            }
        }
    }
    CHECK(certain > 1'000);
}

TEST_CASE("The bridge is met as soon as the ray crosses it by more than rounding") {
    Random random(172);
    int crossing = 0;
    for (int i = 0; i < 10'000; ++i) {
        const State s = random_state(random);
        const Real clearance = least_clearance(Real(s.e), s.r_lo * Real(s.lambda), Real(s.r_lo)) / s.r_lo;
        crossing += clearance < -1e-13 ? 1 : 0;
        if (meets<Interval>(s) != (clearance < 0) && abs(clearance) > 1e-13) {
            FAIL(say(s, "clearance in units of r", clearance));
        }
    }
    CHECK(crossing > 1'000);
}

TEST_CASE("In multiple precision the decision is closer, and the same elsewhere") {
    const PrecisionScope scope(128);
    Random random(173);
    for (int i = 0; i < 2'000; ++i) {
        const State s = random_state(random);
        const Real clearance = least_clearance(Real(s.e), s.r_lo * Real(s.lambda), Real(s.r_lo)) / s.r_lo;
        if (meets<BigInterval>(s) != (clearance < 0) && abs(clearance) > 1e-28) {
            FAIL(say(s, "clearance in units of r", clearance));
        }
    }
}

TEST_CASE("Rays at least as steep as the bridge anywhere, and NaN, are never said to meet it") {
    CHECK(meets<Interval>({0.01, 0.1, 0.1, 0.2}));
    CHECK_FALSE(meets<Interval>({1e-9, 1, 0.1, 0.1}));
    CHECK_FALSE(meets<Interval>({1e-9, 5, 0.1, 0.1}));
    CHECK_FALSE(meets<Interval>({0, 1, 1, 1}));
    CHECK_FALSE(meets<Interval>({not_a_number, 0.1, 0.1, 0.1}));
    CHECK_FALSE(meets<Interval>({0.01, not_a_number, 0.1, 0.1}));
    CHECK_FALSE(meets<Interval>({0.01, 0.1, not_a_number, 0.1}));
    CHECK_FALSE(meets<BigInterval>({0.01, not_a_number, 0.1, 0.1}));
    CHECK_FALSE(meets<BigInterval>({0.01, 0.1, not_a_number, 0.1}));
}
