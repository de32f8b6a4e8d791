// The verifier's arithmetic against MPFR: every bound is on the right side, and close.
#include <cfenv>
#include <random>

#include "catch.hpp"
#include "scale.hpp"
#include "verify/core/big.hpp"
#include "verify/core/interval.hpp"
#include "verify/core/reader.hpp"

using namespace dumbbell_verify;

namespace {

/// An exact value in 2200 bits, in which sums and products of doubles are exact.
class Exact {
  public:
    Exact(double x) {
        mpfr_init2(x_, 4400);
        mpfr_set_d(x_, x, MPFR_RNDN);
    }
    Exact(const Exact&) = delete;
    Exact& operator=(const Exact&) = delete;
    ~Exact() { mpfr_clear(x_); }
    mpfr_ptr get() { return x_; }

  private:
    mpfr_t x_;
};

std::mt19937_64 random_bits(20240607);

/// Numbers of all sizes, and those at which rounding goes wrong: neighbours of powers of two, halves of
/// units.
double adversarial() {
    const std::uint64_t bits = random_bits();
    double x =
        std::ldexp(1 + std::ldexp(static_cast<double>(bits >> 12), -52), static_cast<int>(bits % 41) - 20);
    if (bits % 7 == 0) x = std::ldexp(1.0, static_cast<int>(bits % 61) - 30);
    if (bits % 11 == 0)
        x = std::nextafter(std::ldexp(1.0, static_cast<int>(bits % 61) - 30), bits % 2 ? 0.0 : 1e300);
    if (bits % 13 == 0)
        x = std::ldexp(static_cast<double>(bits % 1000), static_cast<int>(bits % 2000) - 1000);
    return bits % 2 == 0 ? x : -x;
}

double below(double x) { return std::nextafter(x, -HUGE_VAL); }
double above(double x) { return std::nextafter(x, HUGE_VAL); }

using directed = double (*)(Round, double, double);
using Operation = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

void compare(const char* name, directed bounded, Operation exact, double least, double most) {
    for (long i = 0; i < scaled(20'000); ++i) {
        const double a = adversarial(), b = adversarial();
        Exact x(a), y(b), z(0);
        if (exact == mpfr_div && b == 0) continue;
        exact(z.get(), x.get(), y.get(), MPFR_RNDN);  // exact, or by 4400 bits
        const double lo = bounded(down, a, b), hi = bounded(up, a, b);
        INFO(name << " " << a << " " << b << " -> " << lo << " " << hi);
        REQUIRE(mpfr_cmp_d(z.get(), lo) >= 0);
        REQUIRE(mpfr_cmp_d(z.get(), hi) <= 0);
        const double size = std::abs(mpfr_get_d(z.get(), MPFR_RNDN));
        if (size < least || size > most || std::abs(a) < least || std::abs(b) > most) continue;
        const double nearest = mpfr_get_d(z.get(), MPFR_RNDN);
        REQUIRE((lo == below(nearest) && hi == above(nearest)));
    }
}

template <class N>
bool encloses(const Interval<N>& x, mpfr_srcptr value, int (*compare)(mpfr_srcptr, const N&)) {
    return compare(value, x.lo) >= 0 && compare(value, x.hi) <= 0;
}
int compare_double(mpfr_srcptr a, const double& b) { return mpfr_cmp_d(a, b); }
int compare_big(mpfr_srcptr a, const Big& b) { return mpfr_cmp(a, b.get()); }

}  // namespace

TEST_CASE("L13: outward gives the neighbour, in every binade that it does not call unbounded or small") {
    for (int k = -900; k < 1000; ++k)
        for (int i = 0; i < 40; ++i) {
            // Where rounding goes wrong: next to powers of two, and in their middle.
            const double some = 1 + std::ldexp(static_cast<double>(random_bits() >> 12), -52);
            const double sizes[] = {1, above(1), below(2), 1.5, below(1.5), some};
            const double s = std::ldexp(sizes[std::min(i, 5)], k);
            CAPTURE(s);
            REQUIRE((outward(up, s, false) == above(s) && outward(down, s, false) == below(s)));
            REQUIRE((outward(up, -s, false) == above(-s) && outward(down, -s, false) == below(-s)));
        }
    for (double s = 0; s < 0x1p-900; s = above(2 * s))
        CHECK((outward(down, s, false) == -0x1p-899 && outward(up, -s, false) == 0x1p-899));
}

TEST_CASE("L13: the factor is the least that moves all numbers beyond what is rounded to them, exactly") {
    const auto moves = [](double s, double moved) {
        return mpq_class(moved) >= mpq_class(s) + (mpq_class(above(s)) - mpq_class(s)) / 2;
    };
    for (int k = -900; k < 1000; ++k) {
        const double s = std::ldexp(1.0, k);
        for (const double x : {s, above(s), 1.5 * s, below(2 * s)}) REQUIRE(moves(x, outward(up, x, false)));
        REQUIRE_FALSE(moves(s, s + s * 0x1p-53));  // one digit less
    }
    CHECK(
        (outward(up, below(0x1p-900), false) == 0x1p-899 && outward(up, above(0x1p1000), false) == HUGE_VAL));
}

TEST_CASE("the bounds of sums, products and quotients of doubles are the neighbours of what is rounded") {
    compare("add", add, mpfr_add, 0x1p-899, 0x1p999);
    compare("mul", mul, mpfr_mul, 0x1p-899, 0x1p999);
    compare("div", div, mpfr_div, 0x1p-899, 0x1p899);
}

TEST_CASE("operations on extreme numbers stay bounds and are never NaN") {
    const double numbers[] = {0.0,     -0.0,    DBL_TRUE_MIN, DBL_MIN,  0x1p-901, 0x1p-500, 1.0,
                              0x1p500, 0x1p901, 0x1p1000,     0x1p1001, DBL_MAX,  HUGE_VAL};
    for (const double p : numbers)
        for (const double q : numbers)
            for (const double a : {p, -p})
                for (const double b : {q, -q}) {
                    INFO(a << " " << b);
                    for (const directed operation : {directed{add}, directed{mul}, directed{div}})
                        for (const Round d : {down, up}) REQUIRE_FALSE(std::isnan(operation(d, a, b)));
                    if (std::isinf(a) || std::isinf(b)) continue;
                    Exact x(a), y(b), z(0);
                    mpfr_add(z.get(), x.get(), y.get(), MPFR_RNDN);
                    REQUIRE((mpfr_cmp_d(z.get(), add(down, a, b)) >= 0 &&
                             mpfr_cmp_d(z.get(), add(up, a, b)) <= 0));
                    mpfr_mul(z.get(), x.get(), y.get(), MPFR_RNDN);
                    REQUIRE((mpfr_cmp_d(z.get(), mul(down, a, b)) >= 0 &&
                             mpfr_cmp_d(z.get(), mul(up, a, b)) <= 0));
                    if (b == 0) continue;
                    mpfr_div(z.get(), x.get(), y.get(), MPFR_RNDN);
                    REQUIRE((mpfr_cmp_d(z.get(), div(down, a, b)) >= 0 &&
                             mpfr_cmp_d(z.get(), div(up, a, b)) <= 0));
                }
}

TEST_CASE("rationals are bounded exactly") {
    for (int i = 0; i < 20'000; ++i) {
        mpq_class x(static_cast<long>(random_bits() >> (random_bits() % 60 + 2)),
                    static_cast<unsigned long>(random_bits() >> (random_bits() % 60 + 1)) + 1);
        x.canonicalize();
        const double lo = bound(down, x, 0.0), hi = bound(up, x, 0.0);
        REQUIRE((mpq_class(lo) <= x && x <= mpq_class(hi)));
        REQUIRE((lo == hi || std::nextafter(lo, HUGE_VAL) == hi));
        REQUIRE((lo == hi) == (mpq_class(lo) == x));
    }
    mpq_class huge = 1;
    for (int i = 0; i < 2100; ++i) huge *= 10;
    CHECK(bound(up, huge, 0.0) == HUGE_VAL);
    CHECK(bound(down, 1 / huge, 0.0) <= 0);
    CHECK(bound(up, 1 / huge, 0.0) > 0);
    CHECK(bound(down, mpq_class(0), 0.0) == 0);
}

TEST_CASE("pi lies strictly between two neighbouring numbers") {
    const auto x = pi<double>();
    CHECK(std::nextafter(x.lo, 4.0) == x.hi);
    Exact value(0);
    mpfr_const_pi(value.get(), MPFR_RNDN);
    CHECK(encloses(x, value.get(), compare_double));
    Big::precision = 300;
    CHECK(encloses(pi<Big>(), value.get(), compare_big));
}

TEST_CASE("sin and cos enclose and are tight in double") {
    Exact x(0), s(0), c(0);
    mpfr_set_prec(s.get(), 300);
    mpfr_set_prec(c.get(), 300);
    for (long i = 0; i < scaled(20'000); ++i) {
        double z = static_cast<double>(random_bits() >> 11) * 0x1p-52;
        if (i % 5 == 0) z = std::ldexp(z, -static_cast<int>(random_bits() % 400));
        if (i % 7 == 0) z = std::nextafter(1.5707963267948966, i % 2 ? 2 : 0);
        mpfr_set_d(x.get(), z, MPFR_RNDN);
        mpfr_sin_cos(s.get(), c.get(), x.get(), MPFR_RNDN);
        const auto [sine, cosine] = sin_cos(z);
        INFO(z);
        REQUIRE(encloses(sine, s.get(), compare_double));
        REQUIRE(encloses(cosine, c.get(), compare_double));
        if (z > 1.5708) continue;
        REQUIRE(sine.hi - sine.lo <= 6 * 0x1p-52 * z);  // relative, down to the corner
        REQUIRE(cosine.hi - cosine.lo <= 10 * 0x1p-52);
    }
    for (const double z : {0.0, 2.0, -1.0, 2.1, std::nan("")}) {
        const auto [sine, cosine] = sin_cos(z);
        CHECK((sine.lo <= std::sin(z) || std::isnan(z)));
        CHECK((cosine.lo >= -1 && cosine.hi <= above(1)));
    }
}

TEST_CASE("sin and cos enclose and are tight at any precision") {
    for (const mpfr_prec_t bits : {53, 64, 100, 256, 1024, 4096}) {
        Big::precision = bits;
        Exact x(0), s(0), c(0);
        for (mpfr_ptr y : {s.get(), c.get()}) mpfr_set_prec(y, bits + 200);
        for (int i = 0; i <= 40; ++i) {
            const Big z = bound(down, mpq_class(i, 20), Big());
            mpfr_sin_cos(s.get(), c.get(), z.get(), MPFR_RNDN);
            const auto [sine, cosine] = sin_cos(z);
            INFO(bits << " bits, " << i);
            REQUIRE(encloses(sine, s.get(), compare_big));
            REQUIRE(encloses(cosine, c.get(), compare_big));
            const Big width =
                mul(up, add(up, sine.hi, -sine.lo), bound(up, mpq_class(mpz_class(1) << (bits - 6)), Big()));
            REQUIRE(width < Big(1));
        }
    }
}

TEST_CASE("interval operations enclose, for all signs, in both back-ends") {
    Big::precision = 80;
    for (int i = 0; i < 20'000; ++i) {
        const auto number = [] {
            return static_cast<double>(static_cast<int>(random_bits() % 2001) - 1000) / 64;
        };
        double a[] = {number(), number()}, b[] = {number(), number()};
        std::sort(a, a + 2);
        std::sort(b, b + 2);
        const Interval<double> x(a[0], a[1]), y(b[0], b[1]);
        const auto big = [](double v) { return bound(down, mpq_class(v), Big()); };
        const Interval<Big> bx(big(a[0]), big(a[1])), by(big(b[0]), big(b[1]));
        for (const double u : a)
            for (const double v : b) {
                const auto holds = [&](const Interval<double>& set, const Interval<Big>& big_set,
                                       double value) {
                    return set.lo <= value && value <= set.hi && big_set.lo <= big(value) &&
                           big(value) <= big_set.hi;
                };
                INFO(u << " in [" << a[0] << ", " << a[1] << "], " << v << " in [" << b[0] << ", " << b[1]
                       << "]");
                REQUIRE(holds(x + y, bx + by, u + v));  // exact in double: small multiples of 1/64
                REQUIRE(holds(x - y, bx - by, u - v));
                REQUIRE(holds(x * y, bx * by, u * v));
                const Interval<double> q = x / y;
                if (y.lo > 0) {
                    REQUIRE((mpq_class(q.lo) <= mpq_class(u) / mpq_class(v) &&
                             mpq_class(u) / mpq_class(v) <= mpq_class(q.hi)));
                } else {
                    REQUIRE((q.lo == -HUGE_VAL && q.hi == HUGE_VAL));
                }
            }
    }
}

TEST_CASE("the self-test refuses every rounding mode but the nearest") {
    CHECK(arithmetic_works());
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const bool works = arithmetic_works();
        const auto found = judge(3, "count", [] { return static_cast<const char*>(nullptr); });
        std::fesetround(FE_TONEAREST);
        CHECK_FALSE(works);
        CHECK((found.has_value() && found->verdict == Verdict::limit && found->line == 3));  // of any leaf
    }
    CHECK_FALSE(judge(3, "count", [] { return static_cast<const char*>(nullptr); }).has_value());
}

#if defined(__x86_64__)
#include <xmmintrin.h>
TEST_CASE("the self-test refuses flush-to-zero and denormals-are-zero") {
    const unsigned before = _mm_getcsr();
    for (const unsigned flag : {0x8000U, 0x0040U}) {
        _mm_setcsr(before | flag);
        const bool works = arithmetic_works();
        _mm_setcsr(before);
        CHECK_FALSE(works);
    }
}
#endif
