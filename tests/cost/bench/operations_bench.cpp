// Google Benchmark: one operation of each shipped arithmetic and of CGAL's, next to the same in plain double.

#include "number/big_interval.hpp"
#include "number/interval.hpp"
#include "operations.hpp"

using namespace dumbbell;
using namespace dumbbell_bench;

namespace {

template <class I>
void measure_enclosures(const std::string& arithmetic, int bits) {
    const auto enter = [bits] { return PrecisionScope(bits); };
    const auto make = [] { return enclosures<I>(least_operand, most_operand); };
    measure_arithmetic(arithmetic, enter, enclosures<I>);
    measure("sin and cos", arithmetic, enter, make, [](const I& a, const I&) { return sin_cos(a); });
    measure("sin and cos, not thin", arithmetic, enter, make,
            [](const I&, const I& b) { return sin_cos(b); });
}

}  // namespace

int main(int argc, char** argv) {
    const auto nothing = [] { return 0; };
    const auto make = [] { return points(least_operand, most_operand); };
    measure_arithmetic("double", nothing, points);
    const auto libm = [](double a, double) { return SinCosGuess{std::sin(a), std::cos(a)}; };
    measure("sin and cos", "double", nothing, make, libm);
    measure("sin and cos, not thin", "double", nothing, make, libm);
    measure_enclosures<Interval>("Interval", 53);
    measure_cgal();
    for (const int bits : {64, 128, 256, 512, 1024}) {
        measure_enclosures<BigInterval>("BigInterval " + std::to_string(bits), bits);
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
