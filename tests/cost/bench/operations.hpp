#pragma once

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

#include "rooms/number/random.hpp"

/// One operation of an arithmetic. Each benchmark is called "operation/OPERATION/ARITHMETIC"; its counter
/// `operations` is the number of them in one iteration. Operands are a few doubles wide, or thin for sine and
/// cosine as the collision step has them. `enter` makes what the arithmetic wants around it.
namespace dumbbell_bench {

constexpr std::size_t samples = 256;

template <class N>
struct Operands {
    std::vector<N> a, b;
};

inline Operands<double> points(double lo, double hi) {
    dumbbell_test::Random random(1);
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

/// `pass` is one go through all operands.
template <class Enter, class Make, class Pass>
void add_benchmark(const std::string& operation, const std::string& arithmetic, Enter enter, Make make,
                   Pass pass) {
    benchmark::RegisterBenchmark(("operation/" + operation + "/" + arithmetic).c_str(),
                                 [=](benchmark::State& state) {
                                     [[maybe_unused]] const auto scope = enter();
                                     const auto operands = make();
                                     for (auto _ : state) {
                                         pass(operands);
                                     }
                                     state.counters["operations"] = static_cast<double>(samples);
                                 });
}

/// Operations that do not wait for each other.
template <class Enter, class Make, class Operation>
void measure(const std::string& operation, const std::string& arithmetic, Enter enter, Make make,
             Operation apply) {
    add_benchmark(operation, arithmetic, enter, make, [=](const auto& operands) {
        for (std::size_t i = 0; i < samples; ++i) {
            auto result = apply(operands.a[i], operands.b[i]);
            benchmark::DoNotOptimize(result);
        }
    });
}

/// Each operation waits for the one before.
template <class Enter, class Make, class Operation>
void measure_chain(const std::string& operation, const std::string& arithmetic, Enter enter, Make make,
                   Operation apply) {
    add_benchmark(operation + ", chain", arithmetic, enter, make, [=](const auto& operands) {
        auto result = operands.a[0];
        for (std::size_t i = 0; i < samples; ++i) {
            result = apply(result, operands.b[i]);
        }
        benchmark::DoNotOptimize(result);
    });
}

constexpr double least_operand = 0x1p-4;
constexpr double most_operand = 1.5;

/// Everything that is written the same in all arithmetics; `make(lo, hi)` the operands.
template <class Enter, class Make>
void measure_arithmetic(const std::string& arithmetic, Enter enter, Make make) {
    using std::sqrt;
    const auto positive = [=] { return make(least_operand, most_operand); };
    const auto any = [=] { return make(-most_operand, most_operand); };
    const auto plus = [](const auto& a, const auto& b) { return a + b; };
    const auto times = [](const auto& a, const auto& b) { return a * b; };
    const auto over = [](const auto& a, const auto& b) { return a / b; };
    measure("+", arithmetic, enter, positive, plus);
    measure("-", arithmetic, enter, positive, [](const auto& a, const auto& b) { return a - b; });
    measure("*", arithmetic, enter, positive, times);
    measure("*, any signs", arithmetic, enter, any, times);
    measure("/", arithmetic, enter, positive, over);
    measure("/, any signs", arithmetic, enter, any, over);
    measure("sqrt", arithmetic, enter, positive, [](const auto& a, const auto&) { return sqrt(a); });
    measure_chain("+", arithmetic, enter, positive, plus);
    measure_chain("*", arithmetic, enter, positive, times);
    measure_chain("/", arithmetic, enter, positive, over);
}

/// CGAL's Interval_nt, with the rounding mode switched once around all of it.
void measure_cgal();

}  // namespace dumbbell_bench
