// Sine and cosine of intervals anywhere, against MPFR at 300 bits.
#include "verify/functions/angle.hpp"

#include <random>

#include "catch.hpp"
#include "scale.hpp"
#include "verify/functions/exact_value.hpp"

using namespace dumbbell_verify;

namespace {

/// Certified: the bounds of X hold f(z) (`distance` may be missing), computed by MPFR.
template <class N>
bool holds(const Interval<N>& x, double z, int (*function)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t)) {
    mpfr_t value;
    mpfr_init2(value, 300);
    mpfr_set_d(value, z, MPFR_RNDN);
    function(value, value, MPFR_RNDN);
    const bool inside =
        mpfr_cmp_d(value, to_double(down, x.lo)) >= 0 && mpfr_cmp_d(value, to_double(up, x.hi)) <= 0;
    mpfr_clear(value);
    return inside;
}
double point(std::mt19937& random) {
    const double size = std::exp2(std::uniform_real_distribution<>(-60, 26)(random));
    const double quarters =
        std::floor(std::uniform_real_distribution<>(-40, 40)(random)) * 1.5707963267948966;
    switch (random() % 3) {
        case 0:
            return random() % 2 ? size : -size;
        case 1:
            return quarters + std::uniform_real_distribution<>(-1e-9, 1e-9)(random);
        default:
            return std::uniform_real_distribution<>(-10, 10)(random);
    }
}
Big exact(double z, const Big&) { return Big::rounded(down, mpfr_set_d, z); }
double exact(double z, double) { return z; }

template <class N>
void check_enclosures(long trials) {
    const Interval<N> quarter = pi<N>() / Interval<N>(2);
    std::mt19937 random(11);
    for (long i = 0; i < trials; ++i) {
        const double lo = point(random);
        const double width =
            random() % 3 == 0 ? 0 : std::exp2(std::uniform_real_distribution<>(-50, 4)(random));
        const double hi = lo + width;
        const auto [s, c] = sin_cos_on(Interval<N>(exact(lo, N(0)), exact(hi, N(0))), quarter);
        for (int j = 0; j < 5; ++j) {
            const double z = std::min(hi, lo + (hi - lo) * j / 4);
            INFO("[" << lo << ", " << hi << "] at " << z);
            REQUIRE(holds(s, z, mpfr_sin));
            REQUIRE(holds(c, z, mpfr_cos));
        }
        if (width == 0 && std::abs(lo) < 100) {
            REQUIRE(to_double(up, s.hi) - to_double(down, s.lo) < 2e-13);
            REQUIRE(to_double(up, c.hi) - to_double(down, c.lo) < 2e-13);
        }
        // Not past an extremum without need: a short interval has a short image.
        REQUIRE(to_double(up, s.hi) - to_double(down, s.lo) <= 2 * (width + 1e-7));
    }
}

}  // namespace

TEST_CASE("angles: sine and cosine of intervals enclose, in double") {
    check_enclosures<double>(scaled(10'000));
}

TEST_CASE("angles: sine and cosine of intervals enclose, in MPFR") {
    for (const int bits : {53, 113, 200}) {
        Big::precision = bits;
        check_enclosures<Big>(scaled(1'000));
    }
}

TEST_CASE("angles: what is too far out or too wide is [-1, 1]") {
    const Interval<double> quarter = pi<double>() / Interval<double>(2);
    for (const auto& x : {Interval<double>(0, 7), Interval<double>(-HUGE_VAL, 0),
                          Interval<double>(0, HUGE_VAL), Interval<double>(1e18, 1e18),
                          Interval<double>(-1e300, -1e300), Interval<double>(HUGE_VAL, HUGE_VAL)}) {
        const auto [s, c] = sin_cos_on(x, quarter);
        CHECK((s.lo == -1 && s.hi == 1));
        CHECK((c.lo == -1 && c.hi == 1));
    }
}

TEST_CASE("angles: a number of 2^28 right angles or more is too far out by itself") {
    const Interval<double> quarter = pi<double>() / Interval<double>(2);
    for (const double z : {quarter.lo * 0x1p28, -quarter.lo * 0x1p28, 5e8, -2e9, 1e18}) {
        const auto [s, c] = sin_cos_at(z, quarter);
        CHECK((s.lo == -1 && s.hi == 1));
        CHECK((c.lo == -1 && c.hi == 1));
    }
    const auto [s, c] = sin_cos_at(4e8, quarter);
    CHECK(s.hi - s.lo < 1e-6);
    CHECK(c.hi - c.lo < 1e-6);
}

TEST_CASE("angles: square roots enclose, and are 0 of what is not positive") {
    const auto check = [](const auto& number, double narrow) {
        using N = std::decay_t<decltype(number)>;
        const auto root_of = [](const Interval<N>& x) {
            const Interval<N> y = root(x);
            return std::pair{exact_value(y.lo), exact_value(y.hi)};
        };
        CHECK((root_of({N(-1), N(0)}) == std::pair{mpq_class(0), mpq_class(0)}));
        // Exact in MPFR, a neighbour of it in double.
        const mpq_class pad = std::is_same_v<N, Big> ? 0 : 0x1p-51;
        const auto [none, two] = root_of({N(-1), N(4)});
        CHECK((none == 0 && two >= 2 && two <= 2 + pad));
        const auto [less, three] = root_of({N(4), N(9)});
        CHECK((less <= 2 && less >= 2 - pad && three >= 3 && three <= 3 + pad));
        for (int i = 1; i < 300; ++i) {
            const N x = bound(down, mpq_class(i * i + 1, 500), number);
            const auto [lo, hi] = root_of(x);
            REQUIRE((lo * lo <= exact_value(x)));
            REQUIRE((hi * hi >= exact_value(x)));
            REQUIRE((lo > 0 && hi < lo * (1 + narrow)));
        }
    };
    check(0.0, 1e-15);
    Big::precision = 8;
    check(Big(0), 0.02);
}
