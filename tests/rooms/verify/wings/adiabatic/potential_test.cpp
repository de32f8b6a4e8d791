// The potential of a class at the edges of its cells, also for numbers with more and with fewer bits than a
// double, which are rounded on the way: a bound may only become weaker.
#include "verify/wings/adiabatic/potential.hpp"

#include "catch.hpp"
#include "verify/core/big.hpp"

using namespace dumbbell_verify;

namespace {

/// v = 3 on [1/2, 11/7], 1 on [1/4, 1/2].
adiabatic::Potential two_cells() {
    adiabatic::Potential potential(mpq_class(11, 7));
    potential.add_cell(mpq_class(1, 2), 3);
    potential.add_cell(mpq_class(1, 4), 1);
    return potential;
}
template <class N>
N exact(const mpq_class& x) {
    const N value = bound(down, x, N(0));
    REQUIRE(value == bound(up, x, N(0)));
    return value;
}
mpq_class power_of_half(unsigned n) { return mpq_class(1, mpz_class(1) << n); }

}  // namespace

TEMPLATE_TEST_CASE("the least of a potential is that of every cell that is touched", "", double, Big) {
    Big::precision = 80;
    const adiabatic::Potential potential = two_cells();
    const auto least = [&](const mpq_class& from, const mpq_class& until) {
        return potential.least(Interval<TestType>(exact<TestType>(from), exact<TestType>(until)));
    };
    const mpq_class half(1, 2), quarter(1, 4), one = 1;
    CHECK(least(mpq_class(3, 4), one) == TestType(3));
    CHECK(least(half, one) == TestType(1));  // at 1/2 both are v
    CHECK(least(half + power_of_half(52), one) == TestType(3));
    CHECK(least(quarter, mpq_class(3, 8)) == TestType(1));
    CHECK(least(quarter, quarter) == TestType(1));
    CHECK(least(mpq_class(1, 8), one) == TestType(0));
    CHECK(least(quarter - power_of_half(55), one) == TestType(0));
    CHECK(adiabatic::Potential(mpq_class(11, 7)).least(Interval<TestType>(TestType(1))) == TestType(0));
}

TEST_CASE("a potential knows numbers that doubles do not tell from the edge of a cell") {
    Big::precision = 80;
    adiabatic::Potential steps(mpq_class(11, 7));
    steps.add_cell(mpq_class(1, 3), 3);
    steps.add_cell(mpq_class(1, 4), 1);
    // A little below and above 1/2 and 1/4, beyond the bits of a double.
    const adiabatic::Potential potential = two_cells();
    const auto least = [](const adiabatic::Potential& of, const mpq_class& from) {
        return of.least(Interval<Big>(exact<Big>(from), Big(1)));
    };
    CHECK(least(potential, mpq_class(1, 4) - power_of_half(70)) == Big(0));
    CHECK(least(potential, mpq_class(1, 2) - power_of_half(70)) == Big(1));
    CHECK(potential.upper(exact<Big>(mpq_class(1, 2) - power_of_half(70))) >
          potential.upper(exact<Big>(mpq_class(1, 2))));
    // 1/3 is between two doubles: both belong to both cells.
    const double below = bound(down, mpq_class(1, 3), 0.0), above = bound(up, mpq_class(1, 3), 0.0);
    CHECK(steps.least(Interval<double>(below, 1.0)) == 1);
    CHECK(steps.least(Interval<double>(above, 1.0)) == 1);
    CHECK(steps.least(Interval<double>(0.3, below)) == 1);
}

TEST_CASE("a potential is bounded from above, and closely") {
    for (const mpq_class& v : {mpq_class(3), mpq_class(1, 3), mpq_class(7, 5)}) {
        adiabatic::Potential potential(mpq_class(11, 7));
        potential.add_cell(mpq_class(1, 3), v);
        potential.add_cell(mpq_class(1, 7), 2 * v);
        for (const mpq_class& u : {mpq_class(3, 2), mpq_class(1), mpq_class(2, 5), mpq_class(1, 3),
                                   mpq_class(1, 5), mpq_class(1, 7), mpq_class(1, 9), mpq_class(0)}) {
            const mpq_class high = std::max(u, mpq_class(1, 3)), low = std::max(u, mpq_class(1, 7));
            mpq_class V = v * (mpq_class(11, 7) - high);
            if (low < mpq_class(1, 3)) V += 2 * v * (mpq_class(1, 3) - low);
            const auto near = [&](const mpq_class& found, const mpq_class& share) {
                CHECK((V <= found));
                CHECK((found <= V * (1 + share) + share));
            };
            near(mpq_class(potential.upper(bound(down, u, 0.0))), power_of_half(48));
            Big::precision = 9;
            mpq_class few;
            mpfr_get_q(few.get_mpq_t(), potential.upper(bound(down, u, Big(0))).get());
            near(few, power_of_half(6));
            Big::precision = 53;
        }
    }
}

TEST_CASE("beyond the last cell a potential is as high as at its end, and without cells 0") {
    const adiabatic::Potential none(mpq_class(11, 7)), potential = two_cells();
    CHECK(none.upper(0.5) == 0);
    CHECK(none.size() == 0);
    CHECK(potential.size() == 2);
    CHECK(potential.upper(0.0) == potential.upper(0.25));
    CHECK(potential.upper(1.6) == 0);
}

TEST_CASE("no rounding makes a potential too low, nor its least too high") {
    // In each of these all but one operation is exact.
    using Cells = std::vector<std::pair<mpq_class, mpq_class>>;
    const auto made = [](const mpq_class& top, const Cells& cells) {
        adiabatic::Potential potential(top);
        for (const auto& [low, v] : cells) potential.add_cell(low, v);
        return potential;
    };
    const auto exactly = [](double x) { return mpq_class(x); };
    const mpq_class third(1, 3), tiny = power_of_half(60), next = 1 + power_of_half(52);
    CHECK((exactly(made(2, {{1, third}}).upper(1.0)) >= third));
    CHECK((exactly(made(2, {{1, third}}).least(Interval<double>(1.0, 2.0))) <= third));
    CHECK((exactly(made(mpq_class(1, 2), {{third, 1}}).upper(0.0)) >= mpq_class(1, 6)));
    CHECK((exactly(made(4, {{3, 1}, {2, tiny}}).upper(1.0)) >= 1 + tiny));
    CHECK((exactly(made(2, {{0, 1}}).upper(0x1p-60)) >= 2 - tiny));
    CHECK((exactly(made(3, {{1, next}}).upper(2 - 0x1p-52)) >= next * next));
}

TEST_CASE("a potential too great for a double is unbounded, and above its top nothing is known") {
    adiabatic::Potential great(mpq_class(11, 7));
    great.add_cell(mpq_class(1, 2), mpz_class(1) << 900);
    CHECK(great.upper(1.0) == HUGE_VAL);
    CHECK(great.upper(exact<Big>(1)) > exact<Big>(mpz_class(1) << 1000));
    CHECK(two_cells().least(Interval<double>(1.6, 1.7)) == 0);
}
