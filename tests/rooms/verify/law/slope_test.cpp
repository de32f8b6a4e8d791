// Factors of a quantity with a slope: their type says whether they depend on U.
#include "verify/law/slope.hpp"

#include "catch.hpp"
#include "verify/core/big.hpp"

using namespace dumbbell_verify;
using dumbbell_verify::law::Along;
using dumbbell_verify::law::Dependent;
using dumbbell_verify::law::Slope;

// What depends on U does not turn into a number that does not.
static_assert(!std::is_convertible_v<Dependent<double>, Interval<double>>);
static_assert(!std::is_convertible_v<decltype(Along<double, Slope>::U), Interval<double>>);

TEMPLATE_TEST_CASE("law: what depends on U is a factor of what is 0 at U = 0, and of nothing else", "",
                   double, Big) {
    using I = Interval<TestType>;
    Big::precision = 53;
    const Along<TestType, Slope> along{I(I(1).lo, I(2).hi)};
    // Exact in MPFR; a double's end is moved to its neighbour by each operation.
    const double pad = std::is_same_v<TestType, Big> ? 0 : 0x1p-47;
    const auto is = [&](const I& x, int lo, int hi) {
        const double below = lo - to_double(down, x.lo), above = to_double(up, x.hi) - hi;
        return below >= 0 && below <= pad && above >= 0 && above <= pad;
    };
    const auto U = along.line(I(0), I(1)), square = U * along.U;  // on [1, 2]
    CHECK((is(square.zero, 0, 0) && is(square.rise, 1, 2) && is(square.whole, 1, 4)));
    const auto next = along.line(I(1), I(1)), unknown = next * along.U;
    CHECK(is(unknown.whole, 2, 6));
    for (const I& x : {unknown.zero, unknown.rise})
        CHECK((to_double(down, x.lo) == -HUGE_VAL && to_double(up, x.hi) == HUGE_VAL));
    const auto fixed = next * I(3);
    CHECK((is(fixed.zero, 3, 3) && is(fixed.rise, 3, 3) && is(fixed.whole, 6, 9)));
}
