// L42: many collisions at once against one after the other, and polynomials that are just false.
#include <cmath>
#include <vector>

#include "base/ended_early.hpp"
#include "catch.hpp"
#include "flight/count.hpp"
#include "flight/macro/orbit_guess.hpp"
#include "number/rational.hpp"
#include "rooms/number/random.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell::flight::macro;
using dumbbell_test::Random;

namespace {

constexpr long macro_cap = 2'000'000;

/// A state in the middle of an orbit like the extremal ones, and polynomials that should bound it.
Task task_of(Random& random, BoundSide side) {
    const double root = std::pow(10, random.uniform(-12, -5));
    Task task;
    task.r = Ball(root) * Ball(root);
    task.x = Ball(random.uniform(0.01, 1.2));
    task.kappa = Ball(root * random.uniform(0.05, 1.5));
    task.collisions = static_cast<long>(0.05 / root * random.uniform(0.1, 1));
    task.terms = 56;
    const Ball share(std::pow(2, -random.uniform(4, 20)) * (side == BoundSide::upper ? 1 : -1));
    task.x_excess = middle(whole(task.collisions) * Ball(0.5) * share * task.r);
    task.kappa_excess = middle(task.x_excess * Ball(root));
    return task;
}

/// Whether the inequalities of L42 hold after collision n, by their definition. Certain at 500 bits but for
/// ties.
bool holds(BoundSide side, const Orbit& orbit, const Task& task, long n) {
    const PrecisionScope scope(500);
    const Ball k = whole(task.collisions);
    const Ball s = Ball(2) * whole(n) / k - Ball(1), next_s = Ball(2) * whole(n + 1) / k - Ball(1);
    const Ball x = orbit.x.at(s), next_x = orbit.x.at(next_s);
    const Ball kappa = orbit.kappa.at(s), next_kappa = orbit.kappa.at(next_s);
    Ball sine, next_sine, w;
    arb_sin(sine.raw(), x.raw(), bits());
    arb_sin_cos(next_sine.raw(), w.raw(), next_x.raw(), bits());
    const Ball height = next_sine - sine - kappa * (x + next_x + pi());
    const Ball turn = (next_kappa - kappa) * (w * w - task.r) - Ball(2) * w * (task.r + kappa * next_kappa);
    const Ball sign(side == BoundSide::upper ? 1 : -1);
    return positive(sign * height) && positive(sign * turn);
}

/// The count's upper (`most`) or lower bound, one collision after the other.
long counted(const Ray<double>& ray, bool most) {
    const auto bound = [&](const Interval& x) { return most ? low_end(x) : high_end(x); };
    const Interval r(ray.r);
    Interval c(ray.c), kappa(ray.kappa);
    ContactTrend<Interval> trend;
    for (long count = 0;; ++count) {
        const auto contact =
            most ? lowest_contact(c, kappa, trend.next()) : highest_contact(c, kappa, trend.next());
        if (!contact || kappa.lo() >= 1) {
            return count;
        }
        const auto out = reflect_at_light_wall(kappa, contact->cos_x, r);
        if (!certainly_positive(out.denominator)) {
            return count + 1;
        }
        kappa = bound(out.numerator / out.denominator);
        c = bound(contact->sin_x + kappa * (contact->x + pi<Interval>()));
        trend.add(*contact, kappa);
    }
}

/// A question that counts how often it is asked, and says yes from the `patience`-th time on.
struct Asked {
    long patience = 1'000'000'000;
    long times = 0;
    Interrupted question = [this] { return ++times > patience; };
};

}  // namespace

TEST_CASE("L42: bounds by macro steps are those of one collision after the other") {
    Random random(421);
    int equal = 0;
    const long rays = scaled(12);
    for (int i = 0; i < rays; ++i) {
        const double r = std::pow(10, random.uniform(-11, -9));
        const Ray<double> ray{r * random.uniform(0, 4), r * random.uniform(-0.9, 3), r};
        const Ray<Interval> same{Interval(ray.c), Interval(ray.kappa), Interval(ray.r)};
        const long most = count_at_most(same, macro_cap), fewest = count_at_least(same, macro_cap);
        const long plain_most = counted(ray, true), plain_least = counted(ray, false);
        CAPTURE(ray.c, ray.kappa, ray.r, most, fewest, plain_most, plain_least);
        REQUIRE(fewest <= plain_most);
        REQUIRE(plain_least <= most);
        equal += most == fewest && plain_most == plain_least ? 1 : 0;
    }
    CHECK(equal > rays * 9 / 10);
}

TEST_CASE(
    "L42: multiple precision takes macro steps earlier, and counts as one collision after the other does") {
    const PrecisionScope scope(128);
    Random random(422);
    for (int i = 0; i < scaled(6); ++i) {
        const double r = std::pow(10, random.uniform(-8, -7));
        const Ray<double> ray{r * random.uniform(0, 4), r * random.uniform(0, 3), r};
        const Ray<BigInterval> same{BigInterval(ray.c), BigInterval(ray.kappa), BigInterval(ray.r)};
        const Count most = count_at_most(same, macro_cap), fewest = count_at_least(same, macro_cap);
        CHECK(fewest <= counted(ray, true));
        CHECK(counted(ray, false) <= most);
        CHECK(most - fewest <= 1);
    }
}

TEST_CASE("L42: the last of very many collisions are taken together, too") {
    const PrecisionScope scope(160);
    const BigInterval r = low_end(BigInterval(1e-44));
    for (const BoundSide side : {BoundSide::upper, BoundSide::lower}) {
        WallState<BigInterval> state{low_end(half_pi<BigInterval>() - BigInterval(1e-8)),
                                     low_end(BigInterval(1.7e-22))};
        CHECK(macro_step(side, r, state, macro_cap) > 1000);
    }
}

TEST_CASE("A macro step asks at each coefficient whether to end, and then ends at once") {
    const PrecisionScope scope(1000);
    const BigInterval r = low_end(BigInterval(1e-18));
    for (const BoundSide side : {BoundSide::upper, BoundSide::lower}) {
        const WallState<BigInterval> start{BigInterval(1), BigInterval(1e-9)};
        WallState<BigInterval> state = start;
        Asked all;
        REQUIRE(macro_step(side, r, state, Count(1e9), all.question) > 1'000'000);
        REQUIRE(all.times > 100);
        for (const long patience : {0L, 1L, all.times / 2, all.times - 1}) {
            state = start;
            Asked few{patience};
            CHECK(macro_step(side, r, state, Count(1e9), few.question) == 0);
            CHECK(few.times == patience + 1);
            CHECK(exact_lo(state.x) == exact_lo(start.x));
            CHECK(exact_lo(state.kappa) == exact_lo(start.kappa));
        }
    }
}

TEST_CASE("Guesses and checks of a macro step ask at each coefficient whether to end") {
    const PrecisionScope scope(200);
    Random random(424);
    Task task = task_of(random, BoundSide::upper);
    Asked guess;
    task.interrupted = guess.question;
    const auto orbit = guess_orbit(task);
    REQUIRE(orbit);
    CHECK(guess.times > 4 * task.terms);
    Asked check;
    task.interrupted = check.question;
    (void)is_macro_step(BoundSide::upper, *orbit, task);
    CHECK(check.times > 3 * task.terms);
    Asked impatient{10};
    task.interrupted = impatient.question;
    CHECK_THROWS_AS(guess_orbit(task), EndedEarly);
    CHECK_THROWS_AS(is_macro_step(BoundSide::upper, *orbit, task), EndedEarly);
}

TEST_CASE("L42: polynomials that are just false are refused") {
    const PrecisionScope scope(200);
    Random random(423);
    const long tasks = scaled(25);
    int accepted = 0, moved_accepted = 0, false_ones = 0;
    for (int i = 0; i < tasks; ++i) {
        const BoundSide side = random.coin() ? BoundSide::upper : BoundSide::lower;
        const BoundSide other = side == BoundSide::upper ? BoundSide::lower : BoundSide::upper;
        const Task task = task_of(random, side);
        const auto orbit = guess_orbit(task);
        if (!orbit) continue;
        accepted += is_macro_step(side, *orbit, task) ? 1 : 0;
        CHECK_FALSE(is_macro_step(other, *orbit, task));
        for (int j = 0; j < 10; ++j) {
            // A coefficient moved by about as much as there is room: some are true, some are not.
            Orbit moved = *orbit;
            Series& p = random.coin() ? moved.x : moved.kappa;
            const auto at = static_cast<slong>(random.uniform(0, 6));
            const double room = approximate(task.kappa_excess / (whole(task.collisions) * task.r)) *
                                (&p == &moved.x ? 1 : std::sqrt(approximate(task.r)));
            p.set(at, p[at] + Ball(random.sign() * room * std::pow(10, random.uniform(-2, 2))));
            bool true_everywhere = true;
            for (int sample = 0; sample < 20 && true_everywhere; ++sample) {
                const double part = sample < 2 ? sample : random.uniform(0, 1);
                const auto n = static_cast<long>(part * static_cast<double>(task.collisions - 1));
                true_everywhere = holds(side, moved, task, n);
            }
            const bool found = is_macro_step(side, moved, task);
            REQUIRE((true_everywhere || !found));
            moved_accepted += found ? 1 : 0;
            false_ones += true_everywhere ? 0 : 1;
        }
    }
    CHECK(accepted > tasks * 2 / 5);
    CHECK(moved_accepted > tasks / 3);
    CHECK(false_ones > tasks * 2 / 3);
}
