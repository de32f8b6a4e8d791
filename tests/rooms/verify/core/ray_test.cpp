// G along a ray (L4, L5) against the iteration in long double, and the steps of a worked example.
#include "verify/core/ray.hpp"

#include <random>

#include "attacks/oracle/ray_count.hpp"
#include "catch.hpp"
#include "verify/guess/numbers.hpp"

using namespace dumbbell_verify;

namespace {

/// G in long double (tests/attacks/oracle); `margin` is the least distance of any decision from its turning
/// point.
std::uint64_t simulated(long double c, long double kappa, long double r, long double& margin) {
    margin = 1;
    return dumbbell_oracle::ray_count(dumbbell_oracle::Ray<long double>{c, kappa}, r, &margin);
}

template <class N>
void compare(double c, double kappa, double r, std::uint64_t g) {
    Rays<N> rays(nullptr);
    const auto n = [](double x) { return bound(down, mpq_class(x), N(0)); };
    const typename Rays<N>::Ray ray{n(c), n(kappa), n(r)};
    CHECK(rays.at_most("", ray, g));
    CHECK(rays.at_most("", ray, g + 3));
    CHECK(rays.at_least("", ray, g));
    if (g > 0) CHECK_FALSE(rays.at_most("", ray, g - 1));
    CHECK_FALSE(rays.at_least("", ray, g + 1));
}

}  // namespace

TEST_CASE("a thin ray is counted exactly, in both back-ends") {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    int compared = 0;
    for (int i = 0; i < 4000; ++i) {
        const double q = std::exp(unit(random) * 9), r = 1 / q;
        const double kappa = r * (std::pow(unit(random), 3) * std::sqrt(q) * 2 - 1),
                     c = std::pow(unit(random), 4) * 1.1;
        long double margin = 0;
        const std::uint64_t g = simulated(c, kappa, r, margin);
        if (margin < 1e-9) continue;
        ++compared;
        INFO("c " << c << " kappa " << kappa << " r " << r << " G " << g);
        compare<double>(c, kappa, r, g);
        Big::precision = 90;
        if (i % 20 == 0) compare<Big>(c, kappa, r, g);
    }
    CHECK(compared > 3500);
}

TEST_CASE("hundreds of bounces at q = 10^6 lose nothing") {
    long double margin = 0;
    for (const double c : {0.0, 1e-9, 1e-3, 0.2}) {
        const std::uint64_t g = simulated(c, 1e-6, 1e-6, margin);
        CHECK(g > 300);
        CHECK(margin > 1e-12L);
        if (c > 0) {
            compare<double>(c, 1e-6, 1e-6, g);
        } else {
            CHECK(Rays<double>(nullptr).at_most("", {c, 1e-6, 1e-6}, g));
        }
    }
}

TEST_CASE("more precision decides what double cannot") {
    // sin x = c + kappa x touches at cos x = kappa for c = sqrt(1 - kappa^2) - kappa acos(kappa): here 10^-25
    // above.
    Big::precision = 200;
    Big kappa = bound(down, mpq_class(3, 5), Big()), top, c;
    top = Big::rounded(down, mpfr_acos, kappa.get());
    c = bound(down, mpq_class(4, 5), Big()) - kappa * top +
        bound(down, mpq_class(mpz_class(1), mpz_class("10000000000000000000000000")), Big());
    const Big r = bound(down, mpq_class(1, 10), Big());
    CHECK(Rays<Big>(nullptr).at_most("", {c, kappa, r}, 0));
    const double r53 = 0.1, kappa53 = to_double(down, kappa), c53 = to_double(down, c);
    CHECK_FALSE(Rays<double>(nullptr).at_most("", {c53, kappa53, r53}, 0));
}

TEST_CASE("certified misses, steep rays and rays that do not return end the count") {
    Rays<double> rays(nullptr);
    CHECK(rays.at_most("", {0.5, 1.0, 0.1}, 0));
    CHECK(rays.at_most("", {0, 1.0, 0.1}, 0));
    CHECK(rays.at_most("", {1.0001, 0.0, 0.1}, 0));
    CHECK_FALSE(rays.at_most("", {0.9999, 0.0, 0.1}, 0));
    CHECK(rays.at_most("", {0.9999, 0.0, 0.1}, 1));  // D < 0: cos x is about 0.014
    CHECK_FALSE(rays.at_least("", {0.9999, 0.0, 0.1}, 2));
    CHECK(rays.at_least("", {0.9999, 0.0, 0.1}, 1));
    CHECK(rays.at_least("", {0.5, 2.0, 0.1}, 0));
    CHECK_FALSE(rays.at_least("", {0.5, 1.0, 0.1}, 1));
    CHECK_FALSE(rays.at_most("", {0.5, 1.0, 0.1}, -1));
}

TEST_CASE("nothing is certified of undefined or unbounded rays") {
    for (const double bad : {std::nan(""), HUGE_VAL}) {
        CHECK_FALSE(Rays<double>(nullptr).at_least("", {bad, 0.1, 0.1}, 1));
        CHECK_FALSE(Rays<double>(nullptr).at_least("", {0.1, bad, 0.1}, 1));
        CHECK_FALSE(Rays<double>(nullptr).at_least("", {0.1, 0.1, bad}, 2));
    }
    CHECK_FALSE(Rays<double>(nullptr).at_most("", {std::nan(""), 0.1, 0.1}, 0));
    CHECK_FALSE(Rays<double>(nullptr).at_most("", {-HUGE_VAL, -HUGE_VAL, 0.1}, 0));
}

TEST_CASE("a number of 2^64 collisions or more is not taken for its last 64 bits") {
    const mpz_class over = mpz_class(1) << 64;
    for (const int more : {0, 1}) {
        CHECK(Rays<double>(nullptr).at_least("", {0.9999, 0.0, 0.1}, more));
        CHECK_FALSE(Rays<double>(nullptr).at_least("", {0.9999, 0.0, 0.1}, over + more));
        CHECK(Rays<Big>(nullptr).at_most("", {Big(1), Big(0), Big(1)}, over + more));
    }
}
