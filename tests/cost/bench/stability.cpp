// How long enclosures of an orbit stay useful: collisions certified and widths after the last of them, for
// five forms of the same computation, at six precisions, on orbits that are hard to enclose; as TSV.
//
// usage: bench_stability [--shortest]; the shortest runs each form once, at two precisions
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>

#include "rooms/flight/hard_orbits.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

/// The least CPU time of some runs, of `enough` in all, in microseconds.
template <class Run>
double microseconds(double enough, Run run) {
    double least = HUGE_VAL;
    double all = 0;
    do {
        timespec start{}, end{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &start);
        run();
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &end);
        const double spent = 1e6 * static_cast<double>(end.tv_sec - start.tv_sec) +
                             1e-3 * static_cast<double>(end.tv_nsec - start.tv_nsec);
        least = std::min(least, spent);
        all += spent;
    } while (all < enough);
    return least;
}

template <class I>
void measure(const HardOrbit& orbit, std::size_t all, int bits, double enough) {
    const PrecisionScope scope(bits);
    const I r(orbit.r);
    for (const bool boxed : {false, true}) {
        const WallState<I> start = boxed ? small_box<I>(orbit, bits) : point<I>(orbit);
        for (const Form form : all_forms) {
            Propagated<I> result;
            const double spent = microseconds(enough, [&] { result = propagate(form, start, r); });
            const std::size_t certified = result.collisions();
            const auto last = [&](I WallState<I>::*side, double unit) {
                return result.boxes.empty() ? "-"
                                            : fmt::format("{:.1e}", width(result.boxes.back().*side) / unit);
            };
            fmt::print("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{:.1f}\t{}\t{}\n", orbit.name, bits,
                       boxed ? "box" : "point", name_of(form), certified, all,
                       result.finished() ? "finished" : "lost",
                       spent / static_cast<double>(std::max<std::size_t>(1, certified)),
                       last(&WallState<I>::x, 1), last(&WallState<I>::kappa, orbit.r));
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    const bool shortest = argc == 2 && std::strcmp(argv[1], "--shortest") == 0;
    if (argc > 1 && !shortest) {
        fmt::print(stderr, "usage: bench_stability [--shortest]\n");
        return 2;
    }
    const double enough = shortest ? 0 : 2e4;
    fmt::print("orbit\tbits\tstart\tform\tcollisions\tof\tend\tus/collision\tx last\tslope last\n");
    for (const HardOrbit& orbit : hard_orbits()) {
        const std::size_t all = length(orbit);
        measure<Interval>(orbit, all, 53, enough);
        for (int bits = 64; bits <= (shortest ? 64 : 1024); bits *= 2) {
            measure<BigInterval>(orbit, all, bits, enough);
        }
    }
    return 0;
}
