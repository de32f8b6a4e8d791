// Random boxes and ratio ranges: whatever reason closes a box must hold at every state sampled from it, as
// recomputed in 80 digits.
#include <map>

#include "catch.hpp"
#include "collisions/leaf.hpp"
#include "reference.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;
using dumbbell_oracle::BridgeState;
using dumbbell_oracle::LightState;

namespace {

struct State {
    Rational e, slope, q;
};

State sample(Random& choices, const Box& box) {
    return {between(choices, box[Axis::position].lo, box[Axis::position].hi),
            between(choices, box[Axis::slope].lo, box[Axis::slope].hi),
            between(choices, box[Axis::ratio].lo, box[Axis::ratio].hi)};
}

// Somewhere in [0, 2] x [0, 2q], over all scales, at times beginning at 0; half of them at a single ratio.
Box random_box(Random& choices) {
    const auto side = [&](double top) {
        const double lo = choices.uniform(0, 1) < 0.25 ? 0 : choices.log_uniform(1e-4, 1.9) * top;
        return std::pair(exact(lo), exact(std::min(2 * top, lo + choices.log_uniform(1e-4, 1) * top)));
    };
    const double q = choices.log_uniform(1, choices.coin() ? 20 : 300);
    const double q_hi = choices.coin() ? q : q * (1 + choices.log_uniform(1e-6, 0.5));
    const auto [e_lo, e_hi] = side(1);
    const auto [slope_lo, slope_hi] = side(choices.coin() ? 1 : q);
    return {.sides = {{{e_lo, e_hi}, {slope_lo, slope_hi}, {exact(q), exact(q_hi)}}}};
}

// Whether a ray that leaves R at corner distance e with slope r lambda passes below the bridge's hump
// somewhere.
bool meets_bridge(const Real& e, const Real& lambda, const Real& r) {
    if (lambda >= 1) {
        return false;
    }
    const Real t = acos(lambda > 0 ? lambda : Real(0));
    return sin(e) / r + lambda * (e + t) < sin(t);
}

// Of the light chart: 2 w + r lambda - lambda w^2, of the sign of sigma X's vertical velocity, and D.
struct Reversed {
    Real climb, denominator;
    [[nodiscard]] Real mu() const { return climb / denominator; }
};

Reversed reversed(const Real& e, const Real& lambda, const Real& r) {
    const Real w = cos(e);
    return {2 * w + r * lambda - lambda * w * w, w * w + 2 * r * lambda * w - r};
}

bool in_section(Chart chart, const Real& e, const Real& slope, const Real& r) {
    return e <= dumbbell_oracle::pi<Real>() / 2 && r * slope < 1 &&
           (chart == Chart::bridge || reversed(e, slope, r).climb >= 0);
}

void check_bridge_counts(const Leaf& leaf, const Real& e, const Real& eta, const Real& r) {
    const BridgeState<Real> state{e, eta};
    REQUIRE(static_cast<long>(ray_count(bridge_ray(state, r), r)) <= leaf.forward);
    REQUIRE(static_cast<long>(ray_count(bridge_ray_reversed(state, r), r)) <= leaf.backward);
}

void check_light_counts(const Leaf& leaf, const Real& e, const Real& lambda, const Real& r) {
    const LightState<Real> state{e, lambda};
    REQUIRE(static_cast<long>(ray_count(light_ray(state, r), r)) <= leaf.forward);
    if (const auto back = light_ray_reversed(state, r)) {
        REQUIRE(static_cast<long>(ray_count(*back, r)) <= leaf.backward);
    }
}

void check(Chart chart, const Leaf& leaf, const State& state, long upper) {
    const Real e = real(state.e);
    const Real slope = real(state.slope);
    const Real r = 1 / real(state.q);
    CAPTURE(e, slope, r, upper, leaf.forward, leaf.backward);
    const bool inside = in_section(chart, e, slope, r);
    switch (leaf.reason) {
        case Reason::outside:
            REQUIRE_FALSE(inside);
            break;
        case Reason::once:
            FAIL("no leaf of the turning section");
            break;
        case Reason::meets:
            REQUIRE(chart == Chart::light);
            REQUIRE((!inside || meets_bridge(e, slope, r)));
            break;
        case Reason::meets_reversed: {
            REQUIRE(chart == Chart::light);
            const Reversed back = reversed(e, slope, r);
            REQUIRE((!inside || (back.denominator > 0 && meets_bridge(e, back.mu(), r))));
            break;
        }
        case Reason::count:
            REQUIRE(1 + leaf.forward + leaf.backward <= upper);
            if (inside) {
                (chart == Chart::bridge ? check_bridge_counts : check_light_counts)(leaf, e, slope, r);
            }
            break;
    }
}

template <class I>
std::map<Reason, int> soundness(std::uint64_t seed, Chart chart, int boxes) {
    Random choices(seed);
    std::map<Reason, int> closed;
    for (int i = 0; i < boxes; ++i) {
        const Box box = random_box(choices);
        const double q = approximate(box[Axis::ratio].hi);
        const long upper = 1 + static_cast<long>(choices.uniform(0, 3 + std::sqrt(q)));
        if (const auto leaf = judge<I>(chart, box, upper)) {
            ++closed[leaf->reason];
            for (int k = 0; k < 3; ++k) {
                check(chart, *leaf, sample(choices, box), upper);
            }
        }
    }
    return closed;
}

}  // namespace

TEST_CASE("chart bridge: no sampled state of a closed box contradicts the box's reason") {
    auto closed = soundness<Interval>(1, Chart::bridge, 1500);
    CHECK(closed[Reason::count] > 300);
    CHECK(closed[Reason::outside] > 30);
}

TEST_CASE("chart light: no sampled state of a closed box contradicts the box's reason") {
    auto closed = soundness<Interval>(2, Chart::light, 2500);
    CHECK(closed[Reason::count] > 300);
    CHECK(closed[Reason::outside] > 100);
    CHECK(closed[Reason::meets] > 50);
    CHECK(closed[Reason::meets_reversed] > 5);
}

TEST_CASE("the same holds in 128 bits") {
    const PrecisionScope scope(128);
    auto bridge = soundness<BigInterval>(3, Chart::bridge, 200);
    auto light = soundness<BigInterval>(4, Chart::light, 200);
    CHECK(bridge[Reason::count] > 30);
    CHECK(light[Reason::count] > 30);
}

TEST_CASE("near the corner, the peak and the tangents every closed box holds too") {
    Random choices(5);
    int counted = 0;
    for (int i = 0; i < 400; ++i) {
        const Rational q = exact(choices.log_uniform(1.0001, 200));
        const Rational e = choices.coin() ? exact(choices.log_uniform(1e-12, 1e-3))
                                          : exact(1.5707963267948966 - choices.log_uniform(1e-12, 1e-3));
        const Rational slope = choices.coin() ? Rational(0) : exact(choices.log_uniform(1e-14, 1e-2));
        const Rational factor = 1 + exact(choices.log_uniform(1e-15, 1));
        const Box box{e, e * factor, slope, slope * factor, q, q};
        for (const Chart chart : {Chart::bridge, Chart::light}) {
            const long upper =
                1 + static_cast<long>(choices.uniform(1, 2 + std::sqrt(q.convert_to<double>())));
            if (const auto leaf = judge<Interval>(chart, box, upper)) {
                counted += leaf->reason == Reason::count ? 1 : 0;
                check(chart, *leaf, sample(choices, box), upper);
                check(chart, *leaf, {box[Axis::position].lo, box[Axis::slope].lo, box[Axis::ratio].lo},
                      upper);
            }
        }
    }
    CHECK(counted > 150);
}
