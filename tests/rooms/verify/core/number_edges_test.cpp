// The edges of number.hpp and big.hpp: where a bound is exact, where it is the weaker one, where there is
// none.
#include <cmath>
#include <utility>
#include <vector>
#ifdef __SSE2__
#include <fpu_control.h>
#include <xmmintrin.h>
#endif

#include "catch.hpp"
#include "verify/functions/angle.hpp"
#include "verify/functions/exact_value.hpp"
#include "verify/machine/meter.hpp"

using namespace dumbbell_verify;

namespace {

constexpr double infinity = HUGE_VAL;
/// Both bounds of an exact value, or of one that is known to be unbounded.
void check(double lo, double hi, double expected_lo, double expected_hi) {
    CHECK(lo == expected_lo);
    CHECK(hi == expected_hi);
}
void check_add(double a, double b, double lo, double hi) { check(add(down, a, b), add(up, a, b), lo, hi); }
void check_mul(double a, double b, double lo, double hi) { check(mul(down, a, b), mul(up, a, b), lo, hi); }
void check_div(double a, double b, double lo, double hi) { check(div(down, a, b), div(up, a, b), lo, hi); }
void check_bound(const mpq_class& x, double lo, double hi) {
    check(bound(down, x, 0.0), bound(up, x, 0.0), lo, hi);
}
mpq_class power(int k) { return k < 0 ? mpq_class(mpq_class(1) >> -k) : mpq_class(mpq_class(1) << k); }

template <class N>
bool is(const Interval<N>& x, double lo, double hi) {
    return to_double(down, x.lo) == lo && to_double(up, x.hi) == hi;
}
/// The same, or in double a neighbour outside.
template <class N>
bool is_about(const Interval<N>& x, double lo, double hi) {
    if (!std::is_same_v<N, double>) return is(x, lo, hi);
    return is(x, std::nextafter(lo, -infinity), std::nextafter(hi, infinity));
}

}  // namespace

TEST_CASE("sums are bounded from 2^-900 to 2^1000, and a sum that is 0 is known") {
    check_add(0x1p999, 0x1p999, 0x1.fffffffffffffp999, 0x1.0000000000001p1000);
    check_add(-0x1p1000, 0, -0x1.0000000000001p1000, -0x1.fffffffffffffp999);
    check_add(0x1.0000000000001p1000, 0, -infinity, infinity);
    check_add(0, -0x1.0000000000001p1000, -infinity, infinity);
    check_add(0x1p1001, -0x1p1001, 0, 0);
    check_add(1, 0x1p-60, 0x1.fffffffffffffp-1, 0x1.0000000000001p0);
    check_add(1, -0x1p-60, 0x1.fffffffffffffp-1, 0x1.0000000000001p0);
    check_add(-1, -0x1p-60, -0x1.0000000000001p0, -0x1.fffffffffffffp-1);
    check_add(1, -1, 0, 0);
    check_add(0x1p-901, 0x1p-901, 0x1.fffffffffffffp-901, 0x1.0000000000001p-900);
    check_add(0x1p-1074, 0, -0x1p-899, 0x1p-899);
    check_add(NAN, 1, -infinity, infinity);
    check(sub(down, 1.0, 0x1p-60), sub(up, 1.0, 0x1p-60), 0x1.fffffffffffffp-1, 0x1.0000000000001p0);
    check(sub(down, 0x1p-60, 1.0), sub(up, 0x1p-60, 1.0), -0x1.0000000000001p0, -0x1.fffffffffffffp-1);
}

TEST_CASE("the series in double holds for every error up to 2^-51 of its plain brackets") {
    for (int i = 1; i <= 20000; ++i)
        for (const int first : {1, 2}) {
            const double y = 4 - i / 30000., plain = brackets(y, first + 6, 10, 1.0);
            const Interval<double> found = series(Interval<double>(y), first);
            for (const double error : {-0x1p-51, 0x1p-51}) {
                mpq_class x = mpq_class(plain) + mpq_class(error);
                for (int k = first + 4; k >= first; k -= 2) x = 1 - mpq_class(y) / (k * (k + 1)) * x;
                CAPTURE(y, first, error);
                CHECK((mpq_class(found.lo) <= x && x <= mpq_class(found.hi)));
            }
        }
}

TEST_CASE("the series in double are, bit for bit, those of which L14 (d) proves that they hold") {
    using I = Interval<double>;
    std::vector<double> squares;
    for (int i = 0; i <= 20000; ++i) squares.push_back(4 - i / 30000.);
    // Here an eleventh plain bracket, behind which the table of reciprocals ends, would show.
    for (const double y : {0x1.fffe202094fc6p+1, 0x1.fffba5ef7549bp+1, 0x1.fff3954a94a2bp+1})
        squares.push_back(y);
    for (const double lo : squares)
        for (const int first : {1, 2}) {
            const I y(lo, lo + 0x1p-40), found = series(y, first);
            const double plain = brackets(lo, first + 6, 10, 1.0);
            const I proved = brackets(y, first, 3, I(plain - 0x1p-50, plain + 0x1p-50));
            CAPTURE(lo, first);
            CHECK((found.lo == proved.lo && found.hi == proved.hi));
        }
}

TEST_CASE("the series in MPFR are, bit for bit, brackets around a tail in [0, 1]") {
    using I = Interval<Big>;
    // Found by random search: other tails show here.
    for (const auto& [bits, y] : {std::pair{69, 0x1.fc27ab8p+0},
                                  {72, 0x1.f00e33p-1},
                                  {69, 0x1.f51d52p+0},
                                  {72, 0x1.b5185a8p-1},
                                  {69, 0x1.f50a718p+0}}) {
        Big::precision = bits;
        const I square = bound(down, mpq_class(y), Big()), found = series(square, 1);
        const I proved = brackets(square, 1, terms(square.hi), I(Big(0), Big(1)));
        CAPTURE(bits, y);
        CHECK((found.lo == proved.lo && found.hi == proved.hi));
    }
    Big::precision = 53;
}

TEST_CASE("products are bounded by neighbours from 2^-900 to 2^1000, and 0 times a number is 0") {
    check_mul(0, 0x1p1020, 0, 0);
    check_mul(0x1p1020, 0, 0, 0);
    check_mul(0x1p-450, 0x1p-450, 0x1.fffffffffffffp-901, 0x1.0000000000001p-900);
    check_mul(0x1p-450, -0x1p-450, -0x1.0000000000001p-900, -0x1.fffffffffffffp-901);
    check_mul(0x1p-451, 0x1p-450, -0x1p-899, 0x1p-899);
    check_mul(-0x1p-600, 0x1p-600, -0x1p-899, 0x1p-899);
    check_mul(0x1p500, 0x1p500, 0x1.fffffffffffffp999, 0x1.0000000000001p1000);
    check_mul(0x1p500, 0x1.0000000000001p500, -infinity, infinity);
    check_mul(0x1.0000000000001p0, 0x1.0000000000001p0, 0x1.0000000000001p0, 0x1.0000000000003p0);
    check_mul(-0x1.0000000000001p0, 0x1.0000000000001p0, -0x1.0000000000003p0, -0x1.0000000000001p0);
}

TEST_CASE("quotients are bounded from 2^-900 to 2^1000, and 0 over what is not too large is 0") {
    check_div(0, 3, 0, 0);
    check_div(0, 0x1p900, 0, 0);
    check_div(0, 0x1.0000000000001p900, -infinity, infinity);
    check_div(1, 0, -infinity, infinity);
    check_div(0x1p1000, 1, 0x1.fffffffffffffp999, 0x1.0000000000001p1000);
    check_div(0x1.0000000000001p1000, 1, -infinity, infinity);
    check_div(1, 0x1p900, 0x1.fffffffffffffp-901, 0x1.0000000000001p-900);
    check_div(1, 0x1.0000000000001p900, -infinity, infinity);
    check_div(0x1p-1, 0x1p900, -0x1p-899, 0x1p-899);  // the quotient is 2^-901
    check_div(0x1p-1074, -3, -0x1p-899, 0x1p-899);
    check_div(0x1p-1074, 0x1p-1074, 0x1.fffffffffffffp-1, 0x1.0000000000001p0);
    check_div(1, 3, 0x1.5555555555554p-2, 0x1.5555555555556p-2);
    check_div(1, -3, -0x1.5555555555556p-2, -0x1.5555555555554p-2);
}

TEST_CASE(
    "rationals are bounded by their neighbours, 0 exactly, and by what is beyond 890 places otherwise") {
    check_bound(0, 0, 0);
    check_bound(mpq_class(1, 3), 0x1.5555555555555p-2, 0x1.5555555555556p-2);
    check_bound(mpq_class(-1, 3), -0x1.5555555555556p-2, -0x1.5555555555555p-2);
    check_bound(power(890), 0x1p890, 0x1p890);
    check_bound(power(891), -infinity, infinity);
    check_bound(power(-890), 0x1p-890, 0x1p-890);
    check_bound(power(-891), -0x1p-880, 0x1p-880);
}

TEST_CASE("numbers of MPFR of all sizes are copied and assigned, to themselves, too") {
    std::vector<Big> thirds;
    for (const int bits : {53, 320, 321, 4096, 64}) {
        Big::precision = bits;
        thirds.push_back(bound(down, mpq_class(1, 3), Big()));  // moves the others as the vector grows
    }
    Big::precision = 53;
    for (const Big& from : thirds)
        for (Big to : thirds) {
            to = from;
            const Big& same = to;
            to = same;
            CHECK(to == from);
            CHECK((exact_value(to) == exact_value(from)));
        }
    CHECK((exact_value(thirds[3]) > exact_value(thirds[2])));  // each with its own bits
}

TEMPLATE_TEST_CASE("a quotient by an interval that is not positive is unbounded", "", double, Big) {
    using I = Interval<TestType>;
    const TestType zero(0), one(1);
    const I two(2);
    CHECK(is(two / I(-one, one), -infinity, infinity));
    CHECK(is(two / I(zero, one), -infinity, infinity));
    CHECK(is(two / I(-one, -one), -infinity, infinity));
    CHECK(is_about(I(-one, one) / two, -0.5, 0.5));
    CHECK(is_about(two / I(one, TestType(4)), 0.5, 2));
    CHECK(is_about(-two / I(one, TestType(4)), -2, -0.5));
    CHECK(is(square(I(-one, TestType(3))), 0, std::is_same_v<TestType, Big> ? 9 : 0x1.2000000000001p3));
}

TEMPLATE_TEST_CASE("sine and cosine are known on [0, 2] and nowhere else", "", double, Big) {
    for (const int z : {-1, 3}) {
        const auto [s, c] = sin_cos(TestType(z));
        CHECK(is(s, -1, 1));
        CHECK(is(c, -1, 1));
    }
    const auto [s0, c0] = sin_cos(TestType(0));
    CHECK(is(s0, 0, 0));
    CHECK((to_double(down, c0.lo) > 0.999 && to_double(up, c0.hi) < 1.001));
    const auto [s2, c2] = sin_cos(TestType(2));
    CHECK((to_double(down, s2.lo) > 0.909 && to_double(up, s2.hi) < 0.910));
    CHECK((to_double(down, c2.lo) > -0.417 && to_double(up, c2.hi) < -0.416));
}

TEST_CASE("numbers of MPFR are compared with whole numbers and divided by them") {
    CHECK((Big(2) > 1 && Big(-2) < -1 && Big(0) >= 0 && Big(0) <= 0 && !(Big(0) > 0)));
    for (const int sign : {1, -1}) {
        const mpq_class exact(sign, 3);
        CHECK((exact_value(div(down, Big(sign), 3)) < exact));
        CHECK((exact_value(div(up, Big(sign), 3)) > exact));
    }
    CHECK((exact_value(div(down, Big(3), 4)) == mpq_class(3, 4)));
    CHECK(to_double(up, sub(up, Big(1), Big(3))) == -2);
    Big::precision = 100;
    const Big third = div(down, Big(1), 3);
    CHECK(to_double(down, third) == 0x1.5555555555555p-2);
    CHECK(to_double(up, third) == 0x1.5555555555556p-2);
    CHECK(to_double(down, -third) == -0x1.5555555555556p-2);
    CHECK(to_double(up, -third) == -0x1.5555555555555p-2);
    Big::precision = 53;
}

TEST_CASE("numbers of MPFR give back what memory they take") {
    static long blocks = 0;
    static void* (*take)(std::size_t) = nullptr, *(*more)(void*, std::size_t, std::size_t) = nullptr;
    static void (*give)(void*, std::size_t) = nullptr;
    mp_get_memory_functions(&take, &more, &give);
    mp_set_memory_functions([](std::size_t n) { return ++blocks, take(n); }, more,
                            [](void* p, std::size_t n) { --blocks, give(p, n); });
    const auto work = [] {
        Interval<Big> x = Big(2), y;
        y = sin_cos(x.lo).sin * x;
        return y / x;
    };
    for (int i = 0; i < 10; ++i) work();  // MPFR's own caches
    const long before = blocks;
    for (int i = 0; i < 100; ++i) work();
    mp_set_memory_functions(take, more, give);
    CHECK(blocks <= before);
}

TEST_CASE("a number of many bits is copied and negated exactly where fewer are in use") {
    Big::precision = 500;
    const Big third = bound(down, mpq_class(1, 3), Big()), zero;
    Big::precision = 53;
    const Big copy = third;
    Big assigned;
    assigned = third;
    const Interval<Big> x = third;
    CHECK((copy == third && assigned == third && x.lo == third && x.hi == third));
    CHECK((exact_value(-third) == -exact_value(third) && std::max(zero, third) == third));
    CHECK(add(up, third, zero) > third);  // a result is rounded to the precision that is in use
}

TEMPLATE_TEST_CASE("edges: what is made of an unbounded number is unbounded", "", double, Big) {
    using N = TestType;
    Big::precision = 53;
    const N over = div(up, N(1), N(0)), under = div(down, N(-1), N(0));
    for (const Round d : {down, up}) {
        const auto is_unbounded = [d](const N& x) {
            return to_double(d, x) == (d == up ? infinity : -infinity);
        };
        for (const N& x : {over, under})
            for (const N& y : {N(0), N(1), N(-3), over, under}) {
                CAPTURE(d, to_double(d, x), to_double(d, y));
                CHECK(
                    (is_unbounded(add(d, x, y)) && is_unbounded(sub(d, x, y)) && is_unbounded(sub(d, y, x))));
                CHECK((is_unbounded(mul(d, x, y)) && is_unbounded(mul(d, y, x))));
                CHECK((is_unbounded(div(d, x, y)) && is_unbounded(div(d, y, x))));
            }
    }
    const Interval<N> nothing = Interval<N>(0) * (Interval<N>(1) / Interval<N>(0));
    CHECK((to_double(down, nothing.lo) == -infinity && to_double(up, nothing.hi) == infinity));
}

TEST_CASE("what MPFR cannot say is unbounded") {
    const Big infinite = div(up, Big(1), Big(0)), none = add(down, infinite, -infinite);
    CHECK(to_double(down, none) == -infinity);
    CHECK(to_double(down, add(up, infinite, -infinite)) == infinity);
    CHECK(to_double(down, mul(up, infinite, Big(0))) == infinity);
    CHECK(to_double(up, mul(down, infinite, Big(0))) == -infinity);
    CHECK(to_double(down, bound(down, mpq_class(1, 3), Big())) == 0x1.5555555555555p-2);
    CHECK(to_double(up, bound(up, mpq_class(1, 3), Big())) == 0x1.5555555555556p-2);
}

TEST_CASE("the work of a leaf is counted, from the same on, and refused beyond its share") {
    Meter::begin();
    const std::uint64_t first = Meter::done();
    Work::operation(53);
    CHECK(Meter::done() == first + 309);
    Work::collision();
    CHECK(Meter::done() == first + 4405);
    constexpr std::uint64_t units = std::uint64_t{1} << 30;
    Shares shares(1, units);
    Meter::begin(&shares);
    CHECK(Meter::done() == first);
    CHECK_NOTHROW(Meter::spend(units - first));
    CHECK_THROWS_AS(Meter::spend(std::uint64_t{1} << 24), std::length_error);
    Meter::begin();
}

#ifdef __SSE2__
// fegetround asks the x87 unit, too; these modes concern the unit that the bounds use, and nothing else.
TEST_CASE("the arithmetic is refused in each mode of the SSE unit alone") {
    const unsigned usual = _mm_getcsr();
    CHECK(arithmetic_works());
    for (const unsigned mode :
         {0x2000U, 0x4000U, 0x6000U, 0x8000U, 0x0040U}) {  // down, up, to zero, FTZ, DAZ
        CAPTURE(mode);
        _mm_setcsr(usual | mode);
        const bool works = arithmetic_works();
        _mm_setcsr(usual);
        CHECK_FALSE(works);
    }
}
TEST_CASE("the arithmetic is refused in each rounding mode of the x87 unit alone") {
    fpu_control_t usual = 0;
    _FPU_GETCW(usual);
    for (const int mode : {_FPU_RC_DOWN, _FPU_RC_UP, _FPU_RC_ZERO}) {
        CAPTURE(mode);
        const auto changed = static_cast<fpu_control_t>(usual | mode);
        _FPU_SETCW(changed);
        const bool works = arithmetic_works();
        _FPU_SETCW(usual);
        CHECK_FALSE(works);
    }
}
#endif
