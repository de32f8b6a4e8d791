// The verifier's arithmetic against MPFR: every bound is on the right side, and close.
#include <cfenv>
#include <vector>

#include "catch.hpp"
#include "rooms/number/random.hpp"
#include "rooms/number/tightest.hpp"
#include "scale.hpp"
#include "verify/core/big.hpp"
#include "verify/core/interval.hpp"
#include "verify/core/reader.hpp"
#include "verify/functions/exact_value.hpp"

using namespace dumbbell_verify;
using dumbbell_test::adversarial, dumbbell_test::BinaryMpfr, dumbbell_test::Mpfr, dumbbell_test::Random;

namespace {

Random random_numbers(20240607);

double below(double x) { return std::nextafter(x, -HUGE_VAL); }
double above(double x) { return std::nextafter(x, HUGE_VAL); }

using directed = double (*)(Round, double, double);

void compare(const char* name, directed bounded, BinaryMpfr exact, double least, double most) {
    for (long i = 0; i < scaled(20'000); ++i) {
        const double a = adversarial(random_numbers), b = adversarial(random_numbers);
        Mpfr x(a), y(b), z(4400, 0);
        if (exact == mpfr_div && b == 0) continue;
        exact(z, x, y, MPFR_RNDN);  // exact, or by 4400 bits
        const double lo = bounded(down, a, b), hi = bounded(up, a, b);
        INFO(name << " " << a << " " << b << " -> " << lo << " " << hi);
        REQUIRE(mpfr_cmp_d(z, lo) >= 0);
        REQUIRE(mpfr_cmp_d(z, hi) <= 0);
        const double size = std::abs(mpfr_get_d(z, MPFR_RNDN));
        if (size < least || size > most || std::abs(a) < least || std::abs(b) > most) continue;
        const double nearest = mpfr_get_d(z, MPFR_RNDN);
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
            const double some = 1 + std::ldexp(static_cast<double>(random_numbers.bits() >> 12), -52);
            const double sizes[] = {1, above(1), below(2), 1.5, below(1.5), some};
            const double s = std::ldexp(sizes[std::min(i, 5)], k);
            CAPTURE(s);
            REQUIRE((outward(up, s, false) == above(s) && outward(down, s, false) == below(s)));
            REQUIRE((outward(up, -s, false) == above(-s) && outward(down, -s, false) == below(-s)));
        }
    for (double s = 0; s < 0x1p-900; s = above(2 * s))
        CHECK((outward(down, s, false) == -0x1p-899 && outward(up, -s, false) == 0x1p-899));
}

TEST_CASE("the bounds of sums, products and quotients of doubles are the neighbours of what is rounded") {
    compare("add", add, mpfr_add, 0x1p-899, 0x1p999);
    compare("mul", mul, mpfr_mul, 0x1p-899, 0x1p999);
    compare("div", div, mpfr_div, 0x1p-899, 0x1p899);
}

TEST_CASE("rationals are bounded exactly") {
    for (int i = 0; i < 20'000; ++i) {
        mpq_class x(
            static_cast<long>(random_numbers.bits() >> (random_numbers.bits() % 60 + 2)),
            static_cast<unsigned long>(random_numbers.bits() >> (random_numbers.bits() % 60 + 1)) + 1);
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

TEST_CASE("sin and cos enclose and are tight in double") {
    Mpfr x, s(300, 0), c(300, 0);
    for (long i = 0; i < scaled(20'000); ++i) {
        double z = static_cast<double>(random_numbers.bits() >> 11) * 0x1p-52;
        if (i % 5 == 0) z = std::ldexp(z, -static_cast<int>(random_numbers.bits() % 400));
        if (i % 7 == 0) z = std::nextafter(1.5707963267948966, i % 2 ? 2 : 0);
        mpfr_set_d(x, z, MPFR_RNDN);
        mpfr_sin_cos(s, c, x, MPFR_RNDN);
        const auto [sine, cosine] = sin_cos(z);
        INFO(z);
        REQUIRE(encloses(sine, s, compare_double));
        REQUIRE(encloses(cosine, c, compare_double));
        const bool in_quarter = z <= 1.5708;
        REQUIRE(sine.hi - sine.lo <=
                (in_quarter ? 6 * 0x1p-52 * z : 0x1p-48));  // relative, down to the corner
        REQUIRE(cosine.hi - cosine.lo <= (in_quarter ? 10 * 0x1p-52 : 0x1p-48));
    }
    for (const double z : {0.0, 2.0, -1.0, 2.1, std::nan("")}) {
        const auto [sine, cosine] = sin_cos(z);
        CHECK((sine.lo <= std::sin(z) || std::isnan(z)));
        CHECK((cosine.lo >= -1 && cosine.hi <= above(1)));
    }
}

TEST_CASE("sin and cos enclose and are tight at any precision, for small arguments, too") {
    std::vector<mpq_class> points{mpq_class(mpq_class(1) >> 700), mpq_class(mpq_class(1) >> 40)};
    for (int i = 0; i <= 40; ++i) points.push_back(mpq_class(i) / 20);
    for (const int bits : {53, 64, 100, 256, 1024, 2048, 4096}) {
        Big::precision = bits;
        const mpq_class unit = mpq_class(64) >> static_cast<unsigned>(bits);
        Mpfr s(bits + 200, 0), c(bits + 200, 0);
        for (const mpq_class& q : points) {
            const Big z = bound(down, q, Big());
            mpfr_sin_cos(s, c, z.get(), MPFR_RNDN);
            const auto [sine, cosine] = sin_cos(z);
            INFO(bits << " bits, " << q.get_d());
            REQUIRE(encloses(sine, s, compare_big));
            REQUIRE(encloses(cosine, c, compare_big));
            const mpq_class size = q == 0 ? mpq_class(1) : std::min(q, mpq_class(1));
            REQUIRE((exact_value(sub(up, sine.hi, sine.lo)) < size * unit));
            REQUIRE((exact_value(sub(up, cosine.hi, cosine.lo)) < unit));
        }
    }
    Big::precision = 53;
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
