// The axis to halve is chosen by derivatives in doubles: they are those of the enclosed orbit.
#include "starts/cover/spread.hpp"

#include <cmath>

#include "catch.hpp"
#include "rooms/wings/starts/box.hpp"
#include "starts/air/box_state.hpp"
#include "starts/walls/follow.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;

namespace {

Box centre_of(const Box& box) {
    Box centre;
    for (std::size_t i = 0; i < axis_count; ++i) {
        centre.lo.at(i) = centre.hi.at(i) = (box.lo.at(i) + box.hi.at(i)) / 2;
    }
    return centre;
}

/// The same from the jets of the centre's orbit.
std::array<double, axis_count> by_jets(const Box& box, const BoxJets<Interval>& jets,
                                       const Followed<Jet<Interval>>& followed, std::size_t shared) {
    const auto start = jets.state();
    const auto& s = shared == 0 ? start : followed.bounces.at(shared - 1).after;
    const double r = approximate(range(s.body.r));
    const double speed =
        std::hypot(approximate(range(s.phidot)), approximate(range(s.yhatdot)) / std::sqrt(r));
    std::array<double, axis_count> spread{};
    for (std::size_t i = 0; i < axis_count; ++i) {
        const auto change = [&](const Jet<Interval>& x) {
            return std::abs(approximate(x.gradient()[static_cast<int>(i)]));
        };
        spread.at(i) = (box.hi.at(i) - box.lo.at(i)).convert_to<double>() *
                       (change(s.phi) + change(s.yhat) + (change(s.phidot) + change(s.yhatdot) / r) / speed);
    }
    return spread;
}

}  // namespace

TEST_CASE("what an axis spreads follows from the derivatives of the enclosed orbit") {
    std::mt19937_64 engine(14);
    int compared = 0;
    for (int i = 0; i < 300; ++i) {
        const double q = std::exp(dumbbell_trace_test::uniform(engine, 0, 6));
        Box box = dumbbell_trace_test::random_sides(engine, q, 0.1).box();
        box.hi.back() = box.lo.back() + 1;
        const BoxJets<Interval> jets(centre_of(box));
        const auto followed = follow(jets.state());
        for (std::size_t shared = 0; shared <= followed.bounces.size(); ++shared) {
            const auto expected = by_jets(box, jets, followed, shared);
            const auto found = spreads(box, static_cast<long>(shared));
            for (std::size_t axis = 0; axis < axis_count; ++axis) {
                INFO("q " << q << " axis " << axis << " after " << shared << " of "
                          << followed.bounces.size());
                CHECK(found.at(axis) == Approx(expected.at(axis)).epsilon(1e-6).margin(1e-9));
                ++compared;
            }
        }
    }
    CHECK(compared > 4000);
}

TEST_CASE("of a centre that cannot be followed every axis spreads by what is known") {
    // Flat onto both masses at once: no contact to go to.
    const Box box{{exact(-0.5), Rational(0), Rational(3), Rational(-1), Rational(10)},
                  {exact(0.5), Rational(0), Rational(3), Rational(-1), Rational(10)}};
    const auto spread = spreads(box, 5);
    CHECK(spread.front() > 0);
    CHECK(spread == spreads(box, 0));
}
