// Fixed evaluations of the verifier's interval layer in double.
#include "fixed.hpp"
#include "verify/functions/angle.hpp"

namespace dumbbell_verify {

double lo(const Interval<double>& x) { return x.lo; }
double hi(const Interval<double>& x) { return x.hi; }

namespace {

using namespace dumbbell_test;

void evaluate() {
    using I = Interval<double>;
    arithmetic<I>({"+", "-", "*", "/"});
    const I quarter = pi<double>() / I(2);
    const auto any = [](Bits& bits) { return bits.any(); };
    const auto small = [](Bits& bits) { return std::abs(bits.number(-60, 61)); };
    const auto angle = [](Bits& bits) { return bits.number(-60, 88); };
    unary<I>("sqr", mpfr_sqr, any, [](const I& x) { return square(x); });
    unary<I>("sin 0:2", mpfr_sin, small, [](const I& x) { return sin_cos(x.lo).sin; });
    unary<I>("cos 0:2", mpfr_cos, small, [](const I& x) { return sin_cos(x.lo).cos; });
    unary<I>("sin", mpfr_sin, angle, [&](const I& x) { return sin_cos_on(x, quarter).sin; });
    unary<I>("cos", mpfr_cos, angle, [&](const I& x) { return sin_cos_on(x, quarter).cos; });
}

std::string refusal() { return arithmetic_works() ? "" : "the verifier's self-test refuses"; }

}  // namespace
}  // namespace dumbbell_verify

int main(int argc, char** argv) {
    return dumbbell_test::run(argc, argv, dumbbell_verify::refusal, dumbbell_verify::evaluate);
}
