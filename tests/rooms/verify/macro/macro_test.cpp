// L42 in the verifier: many collisions at once against one after the other, and polynomials that are just
// false.
#include <cmath>

#include "attacks/oracle/trial.hpp"
#include "catch.hpp"
#include "rooms/number/random.hpp"
#include "scale.hpp"
#include "verify/core/ray.hpp"
#include "verify/functions/exact_value.hpp"
#include "verify/guess/numbers.hpp"
#include "verify/machine/meter.hpp"
#include "verify/macro/leaps.hpp"
#include "verify/macro/orbit.hpp"

using namespace dumbbell_verify;
using dumbbell_test::Random;

namespace {

mpz_class number(double x, long places) { return fixed(down, mpq_class(x), places); }

/// A state in the middle of an orbit like the extremal ones, to be followed.
Start start_of(Random& random, Round d) {
    Start start;
    const double root = random.uniform(17, 40);
    start.root = std::lround(std::floor(root));
    start.places = 128;
    start.terms = 56;
    start.x = number(random.uniform(0.01, 1.2), 128);
    start.r = number(std::exp2(-2 * root), 128 + 2 * start.root);
    start.slope = number(random.uniform(0.05, 1.5), 128);
    Big::precision = 160;
    start.pi = fixed(down, exact_value(pi_bound(down, Big())), 128);
    start.k = mpz_class(std::floor(0.05 * std::exp2(root) * random.uniform(0.1, 1)));
    start.excess = shifted(start.k * start.r, -1 - 2 * start.root - std::lround(random.uniform(4, 20)));
    if (d == down) start.excess = -start.excess;
    return start;
}

/// The exact value of the series' polynomial at 2 n/k - 1.
mpq_class at(const Series& p, const mpz_class& n, const Start& start) {
    const mpq_class s = mpq_class(2 * n - start.k) / start.k;
    mpq_class value = 0;
    for (std::size_t i = p.term.size(); i-- > 0;) value = value * s + p.term[i];
    return value / shifted(1, start.places);
}

/// Whether the inequalities of L42 hold after collision n, by their definition, at 600 bits.
bool holds(Round d, const dumbbell_verify::Orbit& orbit, const Start& start, const mpz_class& n) {
    Big::precision = 600;
    using I = Interval<Big>;
    const auto number = [](const mpq_class& x) { return I(bound(down, x, Big()), bound(up, x, Big())); };
    const mpq_class scale = mpq_class(1) / shifted(1, start.root);
    const auto x = number(at(orbit.x, n, start)), next_x = number(at(orbit.x, n + 1, start));
    const auto kappa = number(at(orbit.slope, n, start) * scale),
               next_kappa = number(at(orbit.slope, n + 1, start) * scale),
               r = number(mpq_class(start.r) / shifted(1, start.places + 2 * start.root));
    const auto [next_s, w] = sin_cos(next_x.lo);
    const I height = next_s - sin_cos(x.lo).sin - kappa * (x + next_x + pi<Big>());
    const I turn = (next_kappa - kappa) * (w * w - r) - I(2) * w * (r + kappa * next_kappa);
    return d == up ? height.lo > Big(0) && turn.lo > Big(0) : height.hi < Big(0) && turn.hi < Big(0);
}

/// G, counted one after the other in double: between both.
struct LeastAndMost {
    std::uint64_t least, most;
};
LeastAndMost counted(double c, double kappa, double r) {
    const double pi = 2 * std::acos(0.);
    std::uint64_t count = 0;
    double margin = 1, z = 0;
    for (; kappa < 1; ++count) {
        const double top = std::acos(std::min(1., kappa));
        margin = std::sin(top) - c - kappa * top;
        if (margin <= 0 || !guess_root(c, kappa, z)) break;
        const double w = std::cos(z), d = w * w - 2 * kappa * w - r;
        if (d <= 0) break;
        kappa = (kappa * w * w + 2 * r * w - r * kappa) / d;
        c = std::sin(z) + kappa * (z + pi);
    }
    return {count - 1, count + 1};
}

}  // namespace

TEST_CASE("L42: the verifier's macro steps count what one collision after the other does") {
    Random random(424);
    for (int i = 0; i < scaled(5); ++i) {
        const double r = std::pow(10, random.uniform(-11, -9.5)), c = r * random.uniform(0, 4),
                     kappa = r * random.uniform(0, 3);
        const LeastAndMost plain = counted(c, kappa, r);
        Rays<double> rays(nullptr);
        CAPTURE(r, c, kappa, plain.least, plain.most);
        CHECK(rays.at_most("", {c, kappa, r}, plain.most));
        CHECK(rays.at_least("", {c, kappa, r}, plain.least));
        CHECK_FALSE(rays.at_most("", {c, kappa, r}, plain.least - 1));
        CHECK_FALSE(rays.at_least("", {c, kappa, r}, plain.most + 1));
    }
}

TEST_CASE("L42: what macro steps lose is decided one collision after the other, of 20,000 to a million") {
    constexpr double r = 0x1p-32;
    const auto most = [](double c, int n) { return Rays<double>(nullptr).at_most("", {c * r, 0, r}, n); };
    const auto least = [](double c, int n) { return Rays<double>(nullptr).at_least("", {c * r, 0, r}, n); };
    CHECK(most(162440, 29'018));
    CHECK(least(162430, 29'019));
    CHECK_FALSE(most(162430, 29'018));
    CHECK_FALSE(least(162440, 29'019));
    CHECK(most(1804435712, 20'000));
    CHECK(least(1804608404, 20'000));
    Meter::begin();
    CHECK_FALSE(Rays<double>(nullptr).at_most("", {0x1p-45, 0, 0x1p-45}, 2'000'000));
    CHECK(Meter::done() < 100'000 * std::uint64_t{4096});
}

TEST_CASE("L42: behind a macro step the ray's height is bounded on the same side") {
    constexpr double x = 0x1p-18, kappa = 0x1p-20, r = 0x1p-36;
    for (const Round d : {down, up}) {
        mpz_class left = 20'000, same_left = left;
        WallBound wall{exact_value(x), exact_value(kappa), exact_value(r)};
        REQUIRE(Leaps().over(d, wall, 53, left, nullptr));
        RayBound<double> ray{0, kappa, r};
        Leaps leaps;
        REQUIRE(leap(leaps, d, ray, x, same_left, nullptr));
        CHECK((same_left == left && left >= 0));
        CHECK(ray.kappa == bound(d, wall.kappa, 0.0));
        Big::precision = 200;
        const Big at = bound(down, exact_value(bound(d, wall.x, 0.0)), Big());
        const Interval<Big> slope = bound(down, exact_value(ray.kappa), Big());
        const Interval<Big> height = sin_cos(at).sin + slope * (Interval<Big>(at) + pi<Big>());
        CHECK((d == down ? exact_value(height.lo) >= exact_value(ray.c)
                         : exact_value(height.hi) <= exact_value(ray.c)));
    }
}

TEST_CASE("L42: an explanation names the macro steps") {
    Log log;
    Rays<double> rays(&log);
    CHECK(rays.at_least("a <= G", {1e-12, 0, 1e-12}, 442'798));
    CHECK(log.text.find("collisions by L42") != std::string::npos);
}

TEST_CASE("L42: the verifier refuses polynomials that are just false") {
    Random random(425);
    const long trials = scaled(30);
    long accepted = 0, moved_accepted = 0, false_ones = 0;
    for (long i = 0; i < trials; ++i) {
        const Round d = random.coin() ? up : down;
        const Start start = start_of(random, d);
        dumbbell_verify::Orbit orbit{start.series(), start.series(), start.series(), start.series()};
        if (!guess_orbit(start, orbit)) continue;
        accepted += is_macro_step(d, orbit, start) ? 1 : 0;
        CHECK_FALSE(is_macro_step(d == up ? down : up, orbit, start));
        for (int j = 0; j < 10; ++j) {
            // A coefficient moved by about as much as there is room: some are true, some are not.
            dumbbell_verify::Orbit moved = orbit;
            Series& p = random.coin() ? moved.x : moved.slope;
            const mpz_class room = abs(shifted(start.excess, start.root + 1) / start.k) + 1;
            p.term[static_cast<std::size_t>(random.uniform(0, 6))] +=
                (random.coin() ? 1 : -1) * mpz_class(room * mpz_class(std::exp2(random.uniform(0, 14)))) /
                128;
            bool true_everywhere = true;
            for (int sample = 0; sample < 20 && true_everywhere; ++sample) {
                const mpz_class last = start.k - 1,
                                n = sample < 2 ? mpz_class(sample * last)
                                               : mpz_class(std::floor(random.uniform(0, 1) * last.get_d()));
                true_everywhere = holds(d, moved, start, n);
            }
            CHECK_FALSE((is_macro_step(d, moved, start) &&
                         (moved.x.at(-1) != start.x || moved.slope.at(-1) != start.slope)));
            Start there = start;
            there.x = moved.x.at(-1);
            there.slope = moved.slope.at(-1);
            const bool found = is_macro_step(d, moved, there);
            REQUIRE((true_everywhere || !found));
            moved_accepted += found ? 1 : 0;
            false_ones += true_everywhere ? 0 : 1;
        }
    }
    CHECK(accepted > trials * 2 / 5);
    CHECK(moved_accepted > trials / 3);
    CHECK(false_ones > trials * 2 / 3);
}
