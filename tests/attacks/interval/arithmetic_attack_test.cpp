// Sums, products, quotients, squares, roots and bounds of all interval layers against MPFR.
#include "attack.hpp"
#include "catch.hpp"

using namespace dumbbell_test;

namespace {

/// One operation on two intervals, monotone in each argument; `usable` says of which second ones.
template <class L, class Operation, class Usable>
Tally attack_corners(const char* name, std::uint64_t seed, BinaryMpfr exact, const Operation& operation,
                     const Usable& usable) {
    return attack<L>(name, seed, [&](Tally& tally, Random& random, int bits) {
        Ends x(bits);
        Ends y(bits);
        draw(x, random);
        do {
            draw(y, random);
        } while (!usable(y));
        Hull range(bits + room);
        add_corners(range, exact, x, y);
        judge<L>(tally, name, operation(L::make(x.lo, x.hi), L::make(y.lo, y.hi)), range, x, y);
    });
}

/// One operation on one interval, its range told by `exact(range, x)`; `usable` says of which intervals.
template <class L, class Operation, class Exact>
Tally attack_unary(
    const char* name, std::uint64_t seed, const Operation& operation, const Exact& exact,
    bool (*usable)(Ends&) = [](Ends&) { return true; }) {
    return attack<L>(name, seed, [&](Tally& tally, Random& random, int bits) {
        Ends x(bits);
        do {
            draw(x, random);
        } while (!usable(x));
        Hull range(bits + room);
        exact(range, x);
        judge<L>(tally, name, operation(L::make(x.lo, x.hi)), range, x);
    });
}

void add_value(Hull& range, mpfr_ptr x) {
    range.add([x](mpfr_ptr to, mpfr_rnd_t rounding) { mpfr_set(to, x, rounding); });
}

template <class L>
constexpr bool of_program = L::has_roots;

}  // namespace

TEMPLATE_TEST_CASE("Sums, differences, products and quotients hold the exact range", "", ProgramDouble,
                   ProgramBig, VerifierDouble, VerifierBig) {
    using L = TestType;
    using I = typename L::I;
    const auto any = [](Ends&) { return true; };
    const Tally tallies[] = {attack_corners<L>(
                                 "+", 101, mpfr_add, [](const I& x, const I& y) { return x + y; }, any),
                             attack_corners<L>(
                                 "-", 102, mpfr_sub, [](const I& x, const I& y) { return x - y; }, any),
                             attack_corners<L>(
                                 "*", 103, mpfr_mul, [](const I& x, const I& y) { return x * y; }, any),
                             attack_corners<L>(
                                 "/", 104, mpfr_div, [](const I& x, const I& y) { return x / y; },
                                 [](Ends& y) { return !y.holds_zero(); })};
    if (of_program<L>) {
        for (const Tally& tally : tallies) {
            CHECK(tally.loose() == 0);
        }
    }
}

TEMPLATE_TEST_CASE("Quotients by intervals that hold 0 hold every quotient there is", "", ProgramDouble,
                   ProgramBig, VerifierDouble, VerifierBig) {
    using L = TestType;
    attack<L>("/ 0", 105, [](Tally& tally, Random& random, int bits) {
        Ends x(bits);
        Ends y(bits);
        draw(x, random);
        do {
            draw(y, random);
        } while (!y.holds_zero() || (mpfr_zero_p(mpfr_ptr(y.lo)) != 0 && mpfr_zero_p(mpfr_ptr(y.hi)) != 0));
        // Some divisors of both signs: the ends, and numbers next to 0.
        Hull range(bits + room);
        for (mpfr_ptr end : {mpfr_ptr(y.lo), mpfr_ptr(y.hi)}) {
            if (mpfr_zero_p(end) == 0) {
                Ends thin(bits);
                mpfr_set(thin.lo, end, MPFR_RNDN);
                mpfr_set(thin.hi, end, MPFR_RNDN);
                add_corners(range, mpfr_div, x, thin);
                Ends tiny(bits);
                mpfr_mul_2si(tiny.lo, end, -40, MPFR_RNDN);
                mpfr_mul_2si(tiny.hi, end, -40, MPFR_RNDN);
                add_corners(range, mpfr_div, x, tiny);
            }
        }
        judge<L>(tally, "/", L::make(x.lo, x.hi) / L::make(y.lo, y.hi), range, x, y);
    });
}

TEMPLATE_TEST_CASE("Negatives, squares and hulls hold the exact range", "", ProgramDouble, ProgramBig,
                   VerifierDouble, VerifierBig) {
    using L = TestType;
    using I = typename L::I;
    const Tally negatives = attack_unary<L>(
        "neg", 106, [](const I& x) { return -x; },
        [](Hull& range, Ends& x) { add_ends(range, mpfr_neg, x); });
    CHECK(negatives.not_tight() == 0);
    const Tally squares = attack_unary<L>(
        "sqr", 107, [](const I& x) { return L::square(x); },
        [](Hull& range, Ends& x) {
            add_ends(range, mpfr_sqr, x);
            if (x.holds_zero()) {
                range.add(0);
            }
        });
    CHECK((!of_program<L> || squares.loose() == 0));
    const Tally hulls = attack<L>("hull", 108, [](Tally& tally, Random& random, int bits) {
        Ends x(bits);
        Ends y(bits);
        draw(x, random);
        draw(y, random);
        Hull range(bits + room);
        for (mpfr_ptr end : {mpfr_ptr(x.lo), mpfr_ptr(x.hi), mpfr_ptr(y.lo), mpfr_ptr(y.hi)}) {
            add_value(range, end);
        }
        judge<L>(tally, "hull", L::join(L::make(x.lo, x.hi), L::make(y.lo, y.hi)), range, x, y);
    });
    CHECK(hulls.not_tight() == 0);
}

TEMPLATE_TEST_CASE("Square roots, minima and maxima hold the exact range", "", ProgramDouble, ProgramBig) {
    using L = TestType;
    using I = typename L::I;
    const Tally roots = attack_unary<L>(
        "sqrt", 109, [](const I& x) { return sqrt(x); },
        [](Hull& range, Ends& x) {
            Ends part(static_cast<int>(mpfr_get_prec(mpfr_ptr(x.lo))));
            mpfr_max(part.lo, x.lo, part.lo, MPFR_RNDN);
            mpfr_set(part.hi, x.hi, MPFR_RNDN);
            add_ends(range, mpfr_sqrt, part);
        },
        [](Ends& x) { return mpfr_sgn(mpfr_ptr(x.hi)) >= 0; });
    CHECK(roots.loose() == 0);
    const auto attack_bound = [](const char* name, std::uint64_t seed, BinaryMpfr exact,
                                 const auto& operation) {
        return attack_corners<L>(name, seed, exact, operation, [](Ends&) { return true; });
    };
    CHECK(attack_bound("min", 110, mpfr_min, [](const I& x, const I& y) { return min(x, y); }).not_tight() ==
          0);
    CHECK(attack_bound("max", 111, mpfr_max, [](const I& x, const I& y) { return max(x, y); }).not_tight() ==
          0);
}

TEST_CASE("Absolute values hold the exact range") {
    using L = ProgramDouble;
    const Tally values = attack_unary<L>(
        "abs", 112, [](const L::I& x) { return abs(x); },
        [](Hull& range, Ends& x) {
            add_ends(range, mpfr_abs, x);
            if (x.holds_zero()) {
                range.add(0);
            }
        });
    CHECK(values.not_tight() == 0);
}
