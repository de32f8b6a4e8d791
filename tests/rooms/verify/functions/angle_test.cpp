// Sine and cosine of intervals anywhere: how wide they are, and where nothing is known of them. That they
// hold the exact range is tried in tests/attacks/interval/sine_attack_test.cpp.
#include "verify/functions/angle.hpp"

#include "catch.hpp"
#include "rooms/number/angles.hpp"
#include "scale.hpp"
#include "verify/functions/exact_value.hpp"

using namespace dumbbell_verify;

namespace {

double point(dumbbell_test::Random& random) {
    switch (random.below(3)) {
        case 0:
            return random.sign() * random.scaled(0x1p-60, 0x1p26);
        case 1:
            return dumbbell_test::near_quarter_turn(random);
        default:
            return random.uniform(-10, 10);
    }
}

template <class N>
double width_of(const Interval<N>& x) {
    return to_double(up, x.hi) - to_double(down, x.lo);
}

template <class N>
void check_widths(long trials) {
    const Interval<N> quarter = pi<N>() / Interval<N>(2);
    const auto number = [](double z) { return bound(down, mpq_class(z), N(0)); };
    dumbbell_test::Random random(11);
    for (long i = 0; i < trials; ++i) {
        const double lo = point(random), width = random.below(3) == 0 ? 0 : random.scaled(0x1p-50, 0x1p4);
        const auto [s, c] = sin_cos_on(Interval<N>(number(lo), number(lo + width)), quarter);
        INFO("[" << lo << ", " << lo + width << "]");
        if (width == 0 && std::abs(lo) < 100) REQUIRE((width_of(s) < 2e-13 && width_of(c) < 2e-13));
        // Not past an extremum without need: a short interval has a short image.
        REQUIRE(width_of(s) <= 2 * (width + 1e-7));
    }
}

}  // namespace

TEST_CASE("angles: sine and cosine of points and of short intervals are narrow, in double") {
    check_widths<double>(scaled(10'000));
}

TEST_CASE("angles: sine and cosine of points and of short intervals are narrow, in MPFR") {
    for (const int bits : {53, 113, 200}) {
        Big::precision = bits;
        check_widths<Big>(scaled(1'000));
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
