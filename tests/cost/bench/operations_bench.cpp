// Google Benchmark: one operation of Interval and of CGAL's intervals, next to the same in plain double.

#include "number/elementary.hpp"
#include "operations.hpp"

using namespace dumbbell;
using namespace dumbbell_bench;

int main(int argc, char** argv) {
    const auto nothing = [] { return 0; };
    const auto make = [] { return points(least_operand, most_operand); };
    measure_arithmetic("double", nothing, points);
    const auto libm = [](double a, double) { return SinCosGuess{std::sin(a), std::cos(a)}; };
    measure("sin and cos", "double", nothing, make, libm);
    measure("sin and cos, not thin", "double", nothing, make, libm);
    measure_cgal();
    const auto enclosed = [] { return enclosures<Interval>(least_operand, most_operand); };
    measure_arithmetic("Interval", nothing, enclosures<Interval>);
    measure("sin and cos", "Interval", nothing, enclosed,
            [](const Interval& a, const Interval&) { return sin_cos(a); });
    measure("sin and cos, not thin", "Interval", nothing, enclosed,
            [](const Interval&, const Interval& b) { return sin_cos(b); });
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
