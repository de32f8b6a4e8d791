// Speed against error, as lines of docs/pictures/work-precision.tsv: hard orbits followed by two rays in each
// arithmetic, cost as a ratio to plain double; and how many of their collisions other forms certify.
//
// usage: bench_orbits [--shortest]; the shortest runs each once, at two precisions
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <functional>
#include <optional>

#include "peers.hpp"
#include "plain_orbit.hpp"

using namespace dumbbell;
using namespace dumbbell_bench;
using namespace dumbbell_test;

namespace {

/// CPU seconds of so many runs.
double seconds(long runs, const std::function<void()>& run) {
    timespec start{}, end{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &start);
    for (long i = 0; i < runs; ++i) {
        run();
    }
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &end);
    return static_cast<double>(end.tv_sec - start.tv_sec) +
           1e-9 * static_cast<double>(end.tv_nsec - start.tv_nsec);
}

struct Method {
    std::string name;
    int bits;
    std::string result;
    std::function<void()> run;
    long runs = 1;                ///< of one round: a millisecond of them, at least
    std::vector<double> costs{};  ///< of one run, in each round
};

Method plain(const HardOrbit& orbit) {
    const PrecisionScope scope(256);
    const double error =
        approximate(BigInterval(plain_orbit(orbit).x) - last_departure<BigInterval>(orbit).x);
    return {"double", double_bits, fmt::format("{:.1e}", std::abs(error)), [orbit] {
                volatile long collisions = plain_orbit(orbit).collisions;
                static_cast<void>(collisions);
            }};
}

Method enclosed(const HardOrbit& orbit, const Arithmetic& arithmetic, int bits, long all) {
    const PrecisionScope scope(bits);
    const long cap = 2 * all;  // too few for macro steps, which not all of them have
    const Bounds found = arithmetic.count(orbit, cap);
    const bool decided = found.least == all && found.most == all;
    return {arithmetic.name, bits, decided ? fmt::format("{:.1e}", arithmetic.width(orbit)) : "lost", [=] {
                const PrecisionScope inner(bits);
                arithmetic.count(orbit, cap);
            }};
}

std::vector<Method> methods(const HardOrbit& orbit, const std::vector<int>& precisions) {
    const auto all = static_cast<long>(length(orbit));
    std::vector<Method> result{plain(orbit),
                               enclosed(orbit, arithmetic<Interval, NoScope>("Interval"), double_bits, all)};
    for (const Arithmetic& peer : cgal_and_boost()) {
        result.push_back(enclosed(orbit, peer, double_bits, all));
    }
    for (const Arithmetic& peer : {mpfi(), arb(), arithmetic<BigInterval, NoScope>("BigInterval")}) {
        for (const int bits : precisions) {
            result.push_back(enclosed(orbit, peer, bits, all));
        }
    }
    return result;
}

/// Each round runs all methods, so that what else the machine does hits all of them alike.
void measure(const HardOrbit& orbit, const std::vector<int>& precisions, int rounds) {
    std::vector<Method> all = methods(orbit, precisions);
    for (Method& method : all) {
        while (rounds > 1 && seconds(method.runs, method.run) < 1e-3) {
            method.runs *= 2;
        }
    }
    for (int round = 0; round < rounds; ++round) {
        for (Method& method : all) {
            method.costs.push_back(seconds(method.runs, method.run) / static_cast<double>(method.runs));
        }
    }
    for (Method& method : all) {
        std::vector<double> ratios;
        for (std::size_t i = 0; i < method.costs.size(); ++i) {
            ratios.push_back(method.costs[i] / all[0].costs[i]);
        }
        std::sort(ratios.begin(), ratios.end());
        const double ratio = ratios[ratios.size() / 2];
        fmt::print("orbit\t{}\t{}\t{}\t{}\t{}\n", orbit.name, method.name, method.bits,
                   ratio < 100 ? fmt::format("{:.3g}", ratio) : fmt::format("{:.0f}", ratio), method.result);
    }
}

/// How many collisions are certified from a box; what that takes is not told.
template <class I>
void certify_forms(const HardOrbit& orbit, int bits, const std::vector<Form>& forms) {
    const PrecisionScope scope(bits);
    for (const Form form : forms) {
        const auto result = propagate(form, small_box<I>(orbit, bits), I(orbit.r));
        fmt::print("form\t{}\t{}\t{}\t-\t{} of {}\n", orbit.name, name_of(form), bits, result.collisions(),
                   length(orbit));
    }
}

}  // namespace

int main(int argc, char** argv) {
    const bool shortest = argc == 2 && std::strcmp(argv[1], "--shortest") == 0;
    if (argc > 1 && !shortest) {
        fmt::print(stderr, "usage: bench_orbits [--shortest]\n");
        return 2;
    }
    const std::vector<int> precisions =
        shortest ? std::vector{53, 64} : std::vector{53, 64, 128, 256, 512, 1024};
    for (const HardOrbit& orbit : hard_orbits()) {
        if (orbit.kappa >= -orbit.r) {  // what the counts are for
            measure(orbit, precisions, shortest ? 1 : 7);
        }
        certify_forms<Interval>(orbit, double_bits, {std::begin(all_forms), std::end(all_forms)});
        for (const int bits : precisions) {
            if (bits > double_bits) {
                certify_forms<BigInterval>(orbit, bits, {Form::natural, Form::correlated});
            }
        }
    }
    return 0;
}
