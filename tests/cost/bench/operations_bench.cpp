// Google Benchmark: one operation of each shipped arithmetic, next to the same in plain double. Each
// benchmark is called "operation/OPERATION/ARITHMETIC"; its counter `operations` is the number of them in one
// iteration. Operands are a few doubles wide, or thin for sine and cosine as the collision step has them.

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

#include "number/big_interval.hpp"
#include "number/interval.hpp"
#include "rooms/number/random.hpp"

using namespace dumbbell;
using dumbbell_test::Random;

namespace {

constexpr std::size_t samples = 256;

template <class N>
struct Operands {
    std::vector<N> a, b;
};

Operands<double> points(double lo, double hi) {
    Random random(1);
    Operands<double> result;
    for (std::size_t i = 0; i < samples; ++i) {
        result.a.push_back(random.uniform(lo, hi));
        result.b.push_back(random.uniform(lo, hi));
    }
    return result;
}

/// `a` are thin, `b` two doubles wide.
template <class I>
Operands<I> enclosures(double lo, double hi) {
    const Operands<double> at = points(lo, hi);
    Operands<I> result;
    for (std::size_t i = 0; i < samples; ++i) {
        result.a.emplace_back(at.a[i]);
        result.b.emplace_back(at.b[i], dumbbell_test::neighbour(at.b[i], 2));
    }
    return result;
}

template <class Make, class Operation>
void measure(const std::string& operation, const std::string& arithmetic, int bits, Make make,
             Operation apply) {
    benchmark::RegisterBenchmark(("operation/" + operation + "/" + arithmetic).c_str(),
                                 [=](benchmark::State& state) {
                                     const PrecisionScope scope(bits);
                                     const auto operands = make();
                                     for (auto _ : state) {
                                         for (std::size_t i = 0; i < samples; ++i) {
                                             auto result = apply(operands.a[i], operands.b[i]);
                                             benchmark::DoNotOptimize(result);
                                         }
                                     }
                                     state.counters["operations"] = static_cast<double>(samples);
                                 });
}

/// Everything that is written the same in all arithmetics.
template <class Make>
void measure_arithmetic(const std::string& arithmetic, int bits, Make make) {
    using std::sqrt;
    measure("+", arithmetic, bits, make, [](const auto& a, const auto& b) { return a + b; });
    measure("-", arithmetic, bits, make, [](const auto& a, const auto& b) { return a - b; });
    measure("*", arithmetic, bits, make, [](const auto& a, const auto& b) { return a * b; });
    measure("/", arithmetic, bits, make, [](const auto& a, const auto& b) { return a / b; });
    measure("sqrt", arithmetic, bits, make, [](const auto& a, const auto&) { return sqrt(a); });
}

constexpr double least_operand = 0x1p-4;
constexpr double most_operand = 1.5;

template <class I>
void measure_enclosures(const std::string& arithmetic, int bits) {
    const auto make = [] { return enclosures<I>(least_operand, most_operand); };
    measure_arithmetic(arithmetic, bits, make);
    measure("sin and cos", arithmetic, bits, make, [](const I& a, const I&) { return sin_cos(a); });
    measure("sin and cos, not thin", arithmetic, bits, make, [](const I&, const I& b) { return sin_cos(b); });
}

}  // namespace

int main(int argc, char** argv) {
    const auto make = [] { return points(least_operand, most_operand); };
    measure_arithmetic("double", 53, make);
    const auto libm = [](double a, double) { return SinCosGuess{std::sin(a), std::cos(a)}; };
    measure("sin and cos", "double", 53, make, libm);
    measure("sin and cos, not thin", "double", 53, make, libm);
    measure_enclosures<Interval>("Interval", 53);
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
