// Sine, cosine, arcsine, pi and enclosed rationals of all interval layers against MPFR.
#include "attack.hpp"
#include "catch.hpp"
#include "number/rational.hpp"

using namespace dumbbell_test;

namespace {

template <class L, class Operation>
Tally attack_wave(const char* name, std::uint64_t seed, UnaryMpfr f, int at_peak,
                  const Operation& operation) {
    return attack<L>(name, seed, [&](Tally& tally, Random& random, int bits) {
        Ends x(bits);
        draw_angles(x, random);
        Hull range(bits + room);
        add_wave(range, f, at_peak, x);
        judge<L>(tally, name, operation(L::make(x.lo, x.hi)), range, x);
    });
}

/// A rational of any size up to 10^+-400; zero, dyadics and neighbours of doubles among them.
void draw(mpq_class& q, Random& random) {
    switch (random.below(4)) {
        case 0:  // next to a double
            q = mpq_class(adversarial(random));
            q *= mpq_class((mpz_class(1) << 80) + random.below(3) - 1, mpz_class(1) << 80);
            break;
        case 1: {  // next to the middle between two doubles
            const double v = random.sign() * random.scaled(0x1p-60, 0x1p60);
            q = (mpq_class(v) + mpq_class(neighbour(v, 1))) / 2;
            q *= mpq_class((mpz_class(1) << 90) + random.below(3) - 1, mpz_class(1) << 90);
            break;
        }
        case 2: {  // beyond the range of double
            mpz_class power;
            mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned>(random.below(400)));
            q = random.coin() ? mpq_class(power) : mpq_class(1, power);
            break;
        }
        default:
            q = mpq_class(static_cast<long>(random.bits() >> (1 + random.below(60))),
                          static_cast<unsigned long>(random.bits() >> random.below(63)) + 1);
    }
    q.canonicalize();
}

dumbbell::Interval enclosed(const mpq_class& q, const ProgramDouble& /*layer*/) {
    return dumbbell::enclose<dumbbell::Interval>(dumbbell::Rational(q.get_mpq_t()));
}
dumbbell::BigInterval enclosed(const mpq_class& q, const ProgramBig& /*layer*/) {
    return dumbbell::enclose<dumbbell::BigInterval>(dumbbell::Rational(q.get_mpq_t()));
}
template <class N>
dumbbell_verify::Interval<N> enclosed(const mpq_class& q, const Verifier<N>& /*layer*/) {
    using namespace dumbbell_verify;
    return {bound(down, q, N(0)), bound(up, q, N(0))};
}

}  // namespace

TEMPLATE_TEST_CASE("Sine and cosine of any interval hold the exact range", "", ProgramDouble, ProgramBig,
                   VerifierDouble, VerifierBig) {
    using L = TestType;
    using I = typename L::I;
    attack_wave<L>("sin", 201, mpfr_sin, 1, [](const I& x) { return L::sine(x); });
    attack_wave<L>("cos", 202, mpfr_cos, 0, [](const I& x) { return L::cosine(x); });
}

TEMPLATE_TEST_CASE("Arcsines hold the exact range", "", ProgramDouble, ProgramBig) {
    using L = TestType;
    attack<L>("asin", 203, [](Tally& tally, Random& random, int bits) {
        Ends x(bits);
        Ends part(bits);  // of [-1, 1]
        do {
            set_near(x.lo, adversarial_sine(random, attacking_angle), random);
            random.coin() ? set_near(x.hi, adversarial_sine(random, attacking_angle), random)
                          : static_cast<void>(mpfr_set(x.hi, x.lo, MPFR_RNDN));
            in_order(x);
            mpfr_set_si(part.lo, -1, MPFR_RNDN);
            mpfr_set_si(part.hi, 1, MPFR_RNDN);
            mpfr_max(part.lo, part.lo, x.lo, MPFR_RNDN);
            mpfr_min(part.hi, part.hi, x.hi, MPFR_RNDN);
        } while (mpfr_greater_p(mpfr_ptr(part.lo), mpfr_ptr(part.hi)) != 0);
        Hull range(bits + room);
        add_ends(range, mpfr_asin, part);
        judge<L>(tally, "asin", asin(L::make(x.lo, x.hi)), range, x);
    });
}

TEMPLATE_TEST_CASE("The verifier's sine and cosine on [0, 2] hold the exact values", "", VerifierDouble,
                   VerifierBig) {
    using L = TestType;
    const auto attack_series = [](const char* name, std::uint64_t seed, UnaryMpfr f, const auto& part) {
        attack<L>(name, seed, [&](Tally& tally, Random& random, int bits) {
            Ends x(bits);
            double v = std::abs(attacking_angle(random));
            set_near(x.lo, v <= 2 ? v : random.uniform(0, 2), random);
            mpfr_set(x.hi, x.lo, MPFR_RNDN);
            Hull range(bits + room);
            add_ends(range, f, x);
            judge<L>(tally, name, part(dumbbell_verify::sin_cos(L::make(x.lo, x.hi).lo)), range, x);
        });
    };
    attack_series("sin [0,2]", 204, mpfr_sin, [](const auto& both) { return both.sin; });
    attack_series("cos [0,2]", 205, mpfr_cos, [](const auto& both) { return both.cos; });
}

TEMPLATE_TEST_CASE("Enclosed rationals hold their value", "", ProgramDouble, ProgramBig, VerifierDouble,
                   VerifierBig) {
    using L = TestType;
    attack<L>("rational", 206, [](Tally& tally, Random& random, int bits) {
        mpq_class q;
        draw(q, random);
        Hull range(bits + room);
        range.add([&](mpfr_ptr to, mpfr_rnd_t rounding) { mpfr_set_q(to, q.get_mpq_t(), rounding); });
        std::string text = q.get_str();
        judge<L>(tally, "rational", enclosed(q, L()), range, text);
    });
}

TEMPLATE_TEST_CASE("pi lies in its enclosure, which is as narrow as can be", "", ProgramDouble, ProgramBig,
                   VerifierDouble, VerifierBig) {
    using L = TestType;
    Tally tally;
    for (int bits = 53; bits <= (L::in_double ? 53 : 2000); ++bits) {
        const WorkingBits scope(bits);
        Hull range(bits + room);
        range.add([](mpfr_ptr to, mpfr_rnd_t rounding) { mpfr_const_pi(to, rounding); });
        judge<L>(tally, "pi", L::turn(), range);
    }
    tally.print(L::name, "pi");
    CHECK(tally.not_tight() == 0);
}
