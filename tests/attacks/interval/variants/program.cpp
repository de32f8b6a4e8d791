// Fixed evaluations of the program's interval layer in double.
#include "base/error.hpp"
#include "fixed.hpp"
#include "number/elementary.hpp"
#include "number/self_test.hpp"

namespace dumbbell {

double lo(const Interval& x) { return x.lo(); }
double hi(const Interval& x) { return x.hi(); }

namespace {

using namespace dumbbell_test;

void evaluate() {
    arithmetic<Interval>({"+", "-", "*", "/"});
    const auto any = [](Bits& bits) { return bits.any(); };
    const auto positive = [](Bits& bits) { return std::abs(bits.any()); };
    const auto angle = [](Bits& bits) { return bits.number(-60, 82); };
    const auto sine = [](Bits& bits) { return bits.number(-60, 60) / 2; };
    unary<Interval>("sqr", mpfr_sqr, any, [](const Interval& x) { return sqr(x); });
    unary<Interval>("sqrt", mpfr_sqrt, positive, [](const Interval& x) { return sqrt(x); });
    unary<Interval>("sin", mpfr_sin, angle, [](const Interval& x) { return sin(x); });
    unary<Interval>("cos", mpfr_cos, angle, [](const Interval& x) { return cos(x); });
    unary<Interval>("asin", mpfr_asin, sine, [](const Interval& x) { return asin(x); });
}

std::string refusal() try {
    require_sound_arithmetic();
    return {};
} catch (const BrokenInvariant& broken) {
    return broken.what();
}

}  // namespace
}  // namespace dumbbell

int main(int argc, char** argv) {
    return dumbbell_test::run(argc, argv, dumbbell::refusal, dumbbell::evaluate);
}
