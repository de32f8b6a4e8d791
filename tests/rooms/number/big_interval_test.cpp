#include "number/big_interval.hpp"

#include <cmath>
#include <thread>
#include <vector>

#include "angles.hpp"
#include "base/error.hpp"
#include "catch.hpp"
#include "random.hpp"
#include "scale.hpp"
#include "tightest.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

/// Seen in doubles, rounded outward.
Interval seen(const BigInterval& x) { return {x.lo(), x.hi()}; }
bool is(const BigInterval& x, double lo, double hi) {  // arf_cmp_d says nothing of NaN
    return arf_is_nan(x.lower()) == 0 && arf_is_nan(x.upper()) == 0 && arf_cmp_d(x.lower(), lo) == 0 &&
           arf_cmp_d(x.upper(), hi) == 0;
}
bool is_nan(const BigInterval& x) { return arf_is_nan(x.lower()) != 0 && arf_is_nan(x.upper()) != 0; }
bool is_thin(const BigInterval& x) { return arf_equal(x.lower(), x.upper()) != 0; }

}  // namespace

TEST_CASE("The arcsine of a BigInterval is that of its part in [-1, 1]") {
    CHECK(encloses(seen(asin(BigInterval(-2, 3))), {-1.5707963267948966, 1.5707963267948966}));
    CHECK(asin(BigInterval(-2, 3)).hi() < 1.58);
}

namespace {

/// The thin interval's number in a function of MPFR's, tightly enclosed at the working precision.
BigInterval by_mpfr(int (*function)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t), const BigInterval& x) {
    Mpfr argument(2048, 0), value(PrecisionScope::current(), 0);
    REQUIRE(arf_get_mpfr(argument, x.lower(), MPFR_RNDN) == 0);
    BigInterval result;
    function(value, argument, MPFR_RNDD);
    arf_set_mpfr(result.lower(), value);
    function(value, argument, MPFR_RNDU);
    arf_set_mpfr(result.upper(), value);
    return result;
}
bool same(const BigInterval& a, const BigInterval& b) {
    return arf_equal(a.lower(), b.lower()) != 0 && arf_equal(a.upper(), b.upper()) != 0;
}

}  // namespace

TEST_CASE("Functions of a thin BigInterval have MPFR's ends, of a point with other precision too") {
    Random random(43);
    for (long i = 0; i < scaled(600); ++i) {
        const PrecisionScope scope(2 + random.below(300));
        const double x = i == 0 ? 0 : adversarial_angle(random);
        const BigInterval wide = BigInterval(x) * (random.coin() ? BigInterval(1) : pi<BigInterval>());
        const PrecisionScope other(2 + random.below(300));
        for (const BigInterval& bound : {low_end(wide), wide}) {
            BigInterval point = bound;
            arf_set(point.upper(), point.lower());
            const auto at = sin_cos(point);
            CAPTURE(show(point), show(at.sin), show(at.cos));
            REQUIRE(same(at.sin, by_mpfr(mpfr_sin, point)));
            REQUIRE(same(at.cos, by_mpfr(mpfr_cos, point)));
            const BigInterval sine = low_end(at.sin);
            REQUIRE(same(asin(sine), by_mpfr(mpfr_asin, sine)));
            if (certainly_positive(point)) {
                REQUIRE(same(log(point), by_mpfr(mpfr_log, point)));
            }
        }
    }
}

TEST_CASE("The logarithm of what is not certainly positive, or not finite, is NaN") {
    CHECK(is_nan(log(BigInterval(0, 1))));
    CHECK(is_nan(log(BigInterval(-2, -1))));
    CHECK(is_nan(log(BigInterval(1, infinity))));
    CHECK(is(log(BigInterval(1)), 0, 0));
}

TEST_CASE("A quotient by an interval that holds 0 is the whole line") {
    for (const BigInterval& divisor :
         {BigInterval(0, 1), BigInterval(-1, 0), BigInterval(-1, 1), BigInterval(0)}) {
        CHECK(is(BigInterval(1, 2) / divisor, -infinity, infinity));
    }
}

TEST_CASE("More bits give tighter enclosures, down to the precision asked for") {
    const PrecisionScope scope(300);
    const BigInterval third = BigInterval(1) / BigInterval(3);
    CHECK(width(third) <= 0x1p-300);
    CHECK(width(third) > 0);
    CHECK(width(pi<BigInterval>()) <= 0x1p-297);
    CHECK(width(half_pi<BigInterval>()) <= 0x1p-298);
    CHECK(width(sin_cos(BigInterval(1)).sin) <= 0x1p-298);
    const BigInterval zero = pi<BigInterval>() - half_pi<BigInterval>() - half_pi<BigInterval>();
    CHECK((zero.lo() <= 0 && zero.hi() >= 0));
    CHECK(certainly_less(pi<BigInterval>(), BigInterval(0x1.921fb54442d19p+1)));
    CHECK(certainly_less(BigInterval(0x1.921fb54442d18p+1), pi<BigInterval>()));
}

TEST_CASE("A new value has the thread's working precision, whatever its operands have") {
    CHECK(PrecisionScope::current() == 128);
    BigInterval outer(1);
    {
        const PrecisionScope scope(300);
        CHECK(width(BigInterval(1) / BigInterval(3)) == 0x1p-301);
        {
            const PrecisionScope inner(53);
            CHECK(PrecisionScope::current() == 53);
        }
        CHECK(PrecisionScope::current() == 300);
        outer = BigInterval(1) / BigInterval(3);
    }
    CHECK(PrecisionScope::current() == 128);
    CHECK(width(outer) == 0x1p-301);
    const BigInterval shorter = outer + BigInterval(0);
    CHECK(width(shorter) == 0x1p-129);
    CHECK(certainly_at_most(low_end(shorter), outer));
    CHECK(certainly_at_most(outer, high_end(shorter)));
    CHECK_FALSE(certainly_less(shorter, outer));
    CHECK_FALSE(certainly_less(outer, shorter));
}

TEST_CASE("A precision scope concerns its own thread only, and rejects absurd precisions") {
    const PrecisionScope scope(200);
    int elsewhere = 0;
    std::thread([&] {
        elsewhere = PrecisionScope::current();
        const PrecisionScope theirs(70);
    }).join();
    CHECK(elsewhere == 128);
    CHECK(PrecisionScope::current() == 200);
    CHECK_THROWS_AS(PrecisionScope(1), BrokenInvariant);
    CHECK_THROWS_AS(PrecisionScope(-5), BrokenInvariant);
    CHECK_THROWS_AS(PrecisionScope((1 << 20) + 1), BrokenInvariant);
    {
        const PrecisionScope finest(1 << 20);
        CHECK(PrecisionScope::current() == 1 << 20);
    }
    CHECK(PrecisionScope::current() == 200);
}

TEST_CASE("Copies are deep and keep every bit, moved-from values can be used again") {
    const PrecisionScope scope(90);
    BigInterval a(1, 2);
    BigInterval copy = a;
    a = BigInterval(5);
    CHECK(is(copy, 1, 2));
    BigInterval assigned;
    {
        const PrecisionScope wider(200);
        assigned = BigInterval(3, 4);
    }
    copy = assigned;
    CHECK(is(copy, 3, 4));
    BigInterval& self = copy;
    copy = self;
    CHECK(is(copy, 3, 4));
    copy = std::move(self);
    CHECK(is(copy, 3, 4));

    BigInterval moved = std::move(copy);
    CHECK(is(moved, 3, 4));
    copy = BigInterval(7, 8);  // NOLINT(bugprone-use-after-move): what is tested
    CHECK(is(copy, 7, 8));
    std::vector<BigInterval> many;
    for (int i = 0; i < 100; ++i) {
        many.emplace_back(i);
    }
    CHECK(is(many[42], 42, 42));
}

TEST_CASE("Bounds in double are rounded outward, also beyond its range") {
    const PrecisionScope scope(200);
    const BigInterval third = BigInterval(1) / BigInterval(3);
    CHECK(third.lo() == 0x1.5555555555555p-2);
    CHECK(third.hi() == next_up(0x1.5555555555555p-2));
    const BigInterval huge = sqr(BigInterval(1e300));
    CHECK(huge.lo() == greatest);
    CHECK(huge.hi() == infinity);
    const BigInterval tiny = sqr(BigInterval(-1e-300));
    CHECK(tiny.lo() == 0);
    CHECK(tiny.hi() == least);
    CHECK(certainly_positive(tiny));
}

TEST_CASE("Ends, middle and width of a BigInterval") {
    const PrecisionScope scope(200);
    const BigInterval x = BigInterval(1, 2) / BigInterval(3);
    CHECK((is_thin(low_end(x)) && is_thin(high_end(x)) && is_thin(midpoint(x))));
    CHECK(certainly_less(low_end(x), midpoint(x)));
    CHECK(certainly_less(midpoint(x), high_end(x)));
    CHECK(width(x) >= 1.0 / 3);
    CHECK(approximate(x) == Approx(0.5));
    const PrecisionScope coarse(10);
    CHECK(certainly_at_most(low_end(x), x));
    CHECK(certainly_at_most(x, high_end(x)));
}

TEST_CASE("What only copies ends rounds them outward, to the working precision") {
    const auto far_from = [](double sign) {
        const PrecisionScope scope(300);
        const BigInterval third = BigInterval(1) / BigInterval(3);
        return hull(third, BigInterval(2) * third) + BigInterval(sign);
    };
    for (const BigInterval& x : {far_from(1), far_from(-2)}) {
        const PrecisionScope coarse(20);
        for (const BigInterval& same : {-(-x), hull(x, x), min(x, x), max(x, x), x + BigInterval(0)}) {
            CHECK(arf_cmp(same.lower(), x.lower()) < 0);
            CHECK(arf_cmp(same.upper(), x.upper()) > 0);
            CHECK(width(same) < 0.34);
        }
    }
    const PrecisionScope coarse(10);
    CHECK(width(BigInterval(-0x1p-30, 1)) == 1 + 0x1p-9);
}

TEST_CASE("A power of two is exact, and the root of what is below 0 is 0") {
    for (const int exponent : {-1000, -1, 0, 3, 1000}) {
        CHECK(is(two_to(exponent), std::ldexp(1.0, exponent), std::ldexp(1.0, exponent)));
    }
    CHECK(is(sqrt(BigInterval(-2, -1)), 0, 0));
    CHECK(is(sqrt(BigInterval(-2, 0)), 0, 0));
    CHECK(is(sqrt(BigInterval(-2, 9)), 0, 3));
    CHECK(is(sqrt(BigInterval(4, 9)), 2, 3));
}

TEST_CASE("The range of sine and cosine is the hull of the ends' values, and of the extrema inside") {
    struct Row {
        double lo, hi;
        bool sine_top, sine_bottom, cosine_top, cosine_bottom;
    };
    for (const Row& row : {Row{0.25, 1.5, false, false, false, false},  // by quarter turns
                           Row{1, 2, true, false, false, false}, Row{1.75, 3, false, false, false, false},
                           Row{2, 4, false, false, false, true}, Row{3.25, 4.5, false, false, false, false},
                           Row{4, 5, false, true, false, false}, Row{4.75, 6, false, false, false, false},
                           Row{6, 7, false, false, true, false}, Row{-1, 0, false, false, true, false},
                           Row{0, 1, false, false, true, false}, Row{-1, 1, false, false, true, false},
                           Row{-0.5, 2.5, true, false, true, false}, Row{2, 5, false, true, false, true},
                           Row{0.25, 3.5, true, false, false, true},  // in two parts, and in four
                           Row{0.125, 6.1875, true, true, false, true},
                           Row{1.6875, 7.75, false, true, true, true}, Row{0, 7, true, true, true, true}}) {
        const BigInterval x(row.lo, row.hi);
        const auto from = sin_cos(BigInterval(row.lo)), to = sin_cos(BigInterval(row.hi));
        const auto range = [](const BigInterval& a, const BigInterval& b, bool top, bool bottom) {
            const BigInterval upper = top ? hull(a, BigInterval(1)) : a;
            return hull(bottom ? hull(upper, BigInterval(-1)) : upper, b);
        };
        CAPTURE(row.lo, row.hi, show(sin_cos(x).sin), show(sin_cos(x).cos));
        CHECK(same(sin_cos(x).sin, range(from.sin, to.sin, row.sine_top, row.sine_bottom)));
        CHECK(same(sin_cos(x).cos, range(from.cos, to.cos, row.cosine_top, row.cosine_bottom)));
    }
    for (const BigInterval& wide :
         {BigInterval(0, 8), BigInterval(-100, 100), BigInterval(0, infinity), BigInterval(-infinity, 0),
          BigInterval(infinity), BigInterval(-infinity, infinity)}) {
        CHECK(is(sin_cos(wide).sin, -1, 1));
        CHECK(is(sin_cos(wide).cos, -1, 1));
    }
}

TEST_CASE("What would need absurdly many bits is enclosed, if not tightly") {
    BigInterval tiny(0.5);  // squared to 2^-(2^70), which its sine differs from after some 2^71 bits
    for (int i = 0; i < 70; ++i) {
        tiny = sqr(tiny);
    }
    CHECK(is(sin_cos(tiny).sin, -1, 1));
    CHECK(is(sin_cos(tiny).cos, -1, 1));
    const BigInterval arc = asin(tiny);
    CHECK(certainly_at_most(low_end(arc), tiny));
    CHECK(certainly_less(tiny, high_end(arc)));
    CHECK(certainly_less(arc, BigInterval(2) * tiny));
    CHECK(certainly_positive(arc));
}

TEST_CASE("Comparisons of BigInterval are certain only where every pair of points agrees") {
    CHECK(certainly_less(BigInterval(1, 2), BigInterval(3, 4)));
    CHECK_FALSE(certainly_less(BigInterval(1, 2), BigInterval(2, 3)));
    CHECK(certainly_at_most(BigInterval(1, 2), BigInterval(2, 3)));
    CHECK_FALSE(certainly_at_most(BigInterval(1, 2.5), BigInterval(2, 3)));
    CHECK(certainly_positive(BigInterval(0x1p-1074)));
    CHECK_FALSE(certainly_positive(BigInterval(0, 1)));
}

TEST_CASE("Both ends of a BigInterval are NaN, or none is, and then they are in order") {
    const BigInterval endless(infinity), ray(1, infinity), one(1, 2), zero(0);
    for (const BigInterval& bad :
         {BigInterval(not_a_number), BigInterval(not_a_number, 1), BigInterval(1, not_a_number),
          BigInterval(2, 1), ray - endless, endless - ray, ray + -endless, endless / ray, -endless / ray}) {
        REQUIRE(is_nan(bad));
        const BigInterval results[] = {
            -bad,           bad + one,      one + bad,       bad - one,     one - bad,
            bad * one,      one * bad,      bad * zero,      zero * bad,    bad / one,
            one / bad,      bad / zero,     zero / bad,      sqr(bad),      sqrt(bad),
            hull(bad, one), hull(one, bad), min(bad, one),   min(one, bad), max(bad, one),
            max(one, bad),  low_end(bad),   high_end(bad),   midpoint(bad), sin_cos(bad).sin,
            asin(bad),      log(bad),       sin_cos(bad).cos};
        for (std::size_t i = 0; i < std::size(results); ++i) {
            CAPTURE(i, show(results[i]));
            CHECK(is_nan(results[i]));
            CHECK_FALSE(says_something(results[i]));
        }
        CHECK(std::isnan(approximate(bad)));
        CHECK(std::isnan(width(bad)));
    }
}
