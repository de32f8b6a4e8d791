// Quantities with what they do near U = 0: values, slopes and what is left after the slope at 0.
#include "verify/wings/law/slope.hpp"

#include "catch.hpp"
#include "verify/core/big.hpp"

using namespace dumbbell_verify;
using dumbbell_verify::law::Along;

TEMPLATE_TEST_CASE("law: the operations on quantities with slopes enclose them", "", double, Big) {
    using I = Interval<TestType>;
    Big::precision = 53;
    const auto holds = [](const I& x, double value) {
        return to_double(down, x.lo) <= value + 1e-14 && value - 1e-14 <= to_double(up, x.hi);
    };
    const auto is_narrow = [](const I& x) { return to_double(up, x.hi) - to_double(down, x.lo) < 1e-12; };
    for (const int quarters : {1, 2, 3}) {
        const double U = quarters / 4.0;
        const Along<TestType> along{I(quarters) / I(4)};
        const auto x = along.line(I(2), I(3)), y = along.sinc_of(I(2)), z = along.cos_of(I(1));
        const auto all = square_root(square(x) + y) / (x - z) * (I(1) / x) + cube(z) * I(2);
        const auto value = [](double u) {
            const double a = 2 + 3 * u, b = u == 0 ? 1 : std::sin(2 * u) / (2 * u), c = std::cos(u);
            return std::sqrt(a * a + b) / (a - c) / a + 2 * c * c * c;
        };
        // The derivative of sqrt(a^2 + 1)/((a - 1) a) at a = 2 times 3: b and c have none at 0.
        const double root = std::sqrt(5), first = 3 * (2 / root / 2 - root * 3 / 4);
        CHECK(holds(all.whole, value(U)));
        CHECK(holds(all.zero, value(0)));
        CHECK(holds(all.first, first));
        CHECK(holds(all.rise, (value(U) - value(0)) / U));
        CHECK(holds(all.bend, ((value(U) - value(0)) / U - first) / U));
        for (const I& part : {all.whole, all.zero, all.first, all.rise, all.bend}) CHECK(is_narrow(part));
        CHECK(holds(along.values(all), value(U)));
    }
}

TEST_CASE("law: only what has neither value nor slope at U = 0 is multiplied by what depends on U") {
    using I = Interval<double>;
    const Along<double> along{I(0.5, 0.75)};
    const I factor(0.9, 1);
    const auto x = along.times(along.curve(0, 2), factor);  // 2 U^2 (1 - 0.1 t), t in [0, 1]
    CHECK((x.bend.lo <= 1.8 && x.bend.lo > 1.7 && x.whole.lo <= 0.45 && x.rise.hi < 1.6));
    for (const auto& wrong : {along.line(0, 1), along.curve(1, 2), along.line(1, 0)})
        CHECK(along.times(wrong, factor).whole.hi == HUGE_VAL);
    CHECK_THROWS_AS(along.values({I(0), I(0), I(0), I(0), I(2)}), Excluded);
}
