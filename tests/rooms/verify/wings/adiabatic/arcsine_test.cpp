// The arcsine over its argument against MPFR: enclosed from 0 to 1, at any precision, and close where it is
// used; and f = pi - arccos y of a contact, which rests on it.
#include "verify/wings/adiabatic/arcsine.hpp"

#include "catch.hpp"
#include "rooms/number/random.hpp"
#include "rooms/number/tightest.hpp"
#include "scale.hpp"
#include "verify/core/big.hpp"
#include "verify/wings/adiabatic/contact.hpp"

using namespace dumbbell_verify;
using dumbbell_test::Mpfr;
using dumbbell_verify::adiabatic::arcsine_share;
using dumbbell_verify::adiabatic::Masses;
using dumbbell_verify::adiabatic::Touch;

namespace {

dumbbell_test::Random arcsine_random(20250611);

mpq_class exact_rational(double x) { return mpq_class(x); }
mpq_class exact_rational(const Big& x) {
    mpq_class q;
    mpfr_get_q(q.get_mpq_t(), x.get());
    return q;
}
/// In this many bits, so that its error is far below all that is compared.
mpq_class share(const mpq_class& z, int bits) {
    if (z == 0) return 1;
    Mpfr x(bits, 0);
    mpfr_set_q(x, z.get_mpq_t(), MPFR_RNDN);
    mpfr_asin(x, x, MPFR_RNDN);
    mpq_class q;
    mpfr_get_q(q.get_mpq_t(), x);
    return q / z;
}
double arcsine_power_of_two(double lo, double hi) { return std::exp2(arcsine_random.uniform(lo, hi)); }

}  // namespace

TEST_CASE("arcsine: the share encloses, and is tight where a contact needs it") {
    for (long i = 0; i < scaled(4'000); ++i) {
        const double z = i % 3 == 0   ? arcsine_power_of_two(-400, -1)
                         : i % 3 == 1 ? arcsine_random.uniform(0, 0.89)
                                      : 1 - arcsine_power_of_two(-40, -3);
        const Interval<double> enclosed = arcsine_share(Interval<double>(z));
        const mpq_class value = share(exact_rational(z), 1200);
        INFO(z << " " << enclosed.lo << " " << enclosed.hi);
        REQUIRE((exact_rational(enclosed.lo) <= value));
        if (std::isfinite(enclosed.hi)) REQUIRE((value <= exact_rational(enclosed.hi)));
        if (z < 0.89) REQUIRE(enclosed.hi - enclosed.lo < 0x1p-43);
        if (z < 0.125) REQUIRE(enclosed.hi - enclosed.lo < 0x1p-47);
    }
}

TEST_CASE("arcsine: of intervals, every number in them") {
    for (long i = 0; i < scaled(4'000); ++i) {
        const double lo = arcsine_random.uniform(-0.2, 0.95),
                     hi = std::min(1.0, lo + arcsine_power_of_two(-40, -2));
        const Interval<double> enclosed = arcsine_share(Interval<double>(lo, hi));
        for (int j = 0; j < 4; ++j) {
            const double z = j == 0 ? lo : j == 1 ? hi : arcsine_random.uniform(lo, hi);
            if (!(z >= lo && z < 1)) continue;
            const mpq_class value = share(exact_rational(std::abs(z)), 300);
            INFO(z << " in [" << lo << ", " << hi << "]: " << enclosed.lo << " " << enclosed.hi);
            REQUIRE((exact_rational(enclosed.lo) <= value));
            if (std::isfinite(enclosed.hi)) REQUIRE((value <= exact_rational(enclosed.hi)));
        }
    }
}

TEST_CASE("arcsine: nothing is said of numbers that reach 1, and 0 has the share 1") {
    for (const double hi : {1.0, 1.5, 1e300, HUGE_VAL}) {
        const Interval<double> enclosed = arcsine_share(Interval<double>(0.5, hi));
        CHECK(enclosed.hi == HUGE_VAL);
        CHECK(enclosed.lo <= 1.0471976);
        if (hi < 2) CHECK(enclosed.lo > 1.04);
    }
    const Interval<double> none = arcsine_share(Interval<double>(0.0));
    CHECK(none.lo <= 1);
    CHECK(none.lo > 1 - 0x1p-48);
    CHECK(none.hi >= 1);
    CHECK(none.hi < 1 + 0x1p-48);
}

TEST_CASE("arcsine: the share encloses and is tight at any precision") {
    for (const int bits : {53, 100, 256, 512}) {
        Big::precision = bits;
        for (int i = 0; i <= 66; ++i) {
            const Big z = bound(down, mpq_class(i, 100), Big());
            const Interval<Big> enclosed = arcsine_share(Interval<Big>(z));
            const mpq_class value = share(exact_rational(z), bits + 200), lo = exact_rational(enclosed.lo),
                            hi = exact_rational(enclosed.hi);
            INFO(bits << " bits, " << i);
            REQUIRE((lo <= value && value <= hi));
            REQUIRE(((hi - lo) * (mpz_class(1) << static_cast<mp_bitcnt_t>(bits - 12)) < 1));
        }
    }
}

TEST_CASE("arcsine: f of a contact is enclosed over ranges of u and delta, and tight at points") {
    const Interval<double> quarter = pi<double>() / Interval<double>(2);
    for (int i = 0; i < 5'000; ++i) {
        const double delta = arcsine_power_of_two(-10, -1.01), u = arcsine_power_of_two(-8, 0.6),
                     du = u * arcsine_power_of_two(-30, -2),
                     dd = i % 2 == 0 ? 0 : std::min(0.5 - delta, delta * arcsine_power_of_two(-30, 0));
        const Interval<double> angle(u, std::min(u + du, 1.57)), range(delta, delta + dd);
        if (!(angle.lo <= angle.hi)) continue;
        const auto at = Touch<double>::at(Masses<double>(range), angle, quarter);
        for (int j = 0; j < 4; ++j) {
            const double d = j == 0   ? range.lo
                             : j == 1 ? range.hi
                                      : arcsine_random.uniform(range.lo, range.hi),
                         v = j == 0   ? angle.hi
                             : j == 1 ? angle.lo
                                      : arcsine_random.uniform(angle.lo, angle.hi);
            if (d < range.lo || d > range.hi || v < angle.lo || v > angle.hi) continue;
            const long double y = (1 - static_cast<long double>(d) * d) *
                                  std::cos(static_cast<long double>(v)),
                              f = std::acos(-y), F = std::acos(-std::cos(static_cast<long double>(v)));
            INFO("delta " << d << " u " << v << " f " << f << " in [" << at.f.lo << ", " << at.f.hi << "]");
            REQUIRE(at.f.lo <= f + 1e-15L);
            REQUIRE(f <= at.f.hi + 1e-15L);
            REQUIRE(at.asin_Z.lo <= F - f + 1e-15L);
            REQUIRE(F - f <= at.asin_Z.hi + 1e-15L);
        }
        const auto point = Touch<double>::at(Masses<double>(delta), Interval<double>(u), quarter);
        if (u > 1.57) continue;
        CAPTURE(delta, u);
        REQUIRE(point.f.hi - point.f.lo < 0x1p-40);
        REQUIRE(point.asin_Z.hi - point.asin_Z.lo < 0x1p-40);
        // Over a range of delta alone f is as wide as its values are apart, and no wider.
        const auto ends = Touch<double>::at(Masses<double>(range), Interval<double>(u), quarter);
        const auto other = Touch<double>::at(Masses<double>(range.hi), Interval<double>(u), quarter);
        REQUIRE(ends.f.hi - ends.f.lo < point.f.hi - other.f.lo + 0x1p-40);
    }
}
