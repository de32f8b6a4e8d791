// How long enclosures of an orbit stay useful: collisions certified and widths against the number of bounces,
// for five forms of the same computation, at six precisions, on orbits that are hard to enclose.
//
// usage: bench_stability [--tsv] [--shortest]; the shortest runs each form once, at two precisions
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

constexpr std::size_t shown_bounces[] = {1, 10, 100};

/// The widths of x and kappa/r after the bounce with this number, counted from 1.
template <class I>
std::string widths(const Propagated<I>& orbit, std::size_t bounce, double r, char between) {
    if (bounce < 1 || bounce > orbit.boxes.size()) {
        return fmt::format("-{}-", between);
    }
    const auto& box = orbit.boxes[bounce - 1];
    return fmt::format("{:.1e}{}{:.1e}", width(box.x), between, width(box.kappa) / r);
}

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
void measure(const HardOrbit& orbit, std::size_t all, int bits, bool tsv, double enough) {
    const PrecisionScope scope(bits);
    const I r(orbit.r);
    for (const bool boxed : {false, true}) {
        const WallState<I> start = boxed ? small_box<I>(orbit, bits) : point<I>(orbit);
        for (const Form form : all_forms) {
            Propagated<I> result;
            const double spent = microseconds(enough, [&] { result = propagate(form, start, r); });
            std::string line =
                fmt::format(fmt::runtime(tsv ? "{}\t{}\t{}\t{}\t{}\t{}\t{}\t{:.1f}"
                                             : "{:<16} {:>5} {:<6} {:<15} {:>4} of {:>3} {:<9} {:>8.1f}"),
                            orbit.name, bits, boxed ? "box" : "point", name_of(form), result.collisions(),
                            all, result.finished() ? "finished" : "lost",
                            spent / static_cast<double>(std::max<std::size_t>(1, result.collisions())));
            const auto add = [&](std::size_t bounce) {
                line += tsv ? "\t" + widths(result, bounce, orbit.r, '\t')
                            : fmt::format("  {:<15}", widths(result, bounce, orbit.r, ' '));
            };
            for (const std::size_t bounce : shown_bounces) {
                add(bounce);
            }
            add(result.boxes.size());
            fmt::print("{}\n", line);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    bool tsv = false;
    bool shortest = false;
    for (int i = 1; i < argc; ++i) {
        bool* const option = std::strcmp(argv[i], "--tsv") == 0        ? &tsv
                             : std::strcmp(argv[i], "--shortest") == 0 ? &shortest
                                                                       : nullptr;
        if (option == nullptr) {
            fmt::print(stderr, "usage: bench_stability [--tsv] [--shortest]\n");
            return 2;
        }
        *option = true;
    }
    const double enough = shortest ? 0 : 2e4;
    if (tsv) {
        fmt::print(
            "orbit\tbits\tstart\tform\tcollisions\tof\tend\tus/collision\tx 1\tslope 1\tx 10\tslope 10\t"
            "x 100\tslope 100\tx last\tslope last\n");
    } else {
        fmt::print(
            "Certified collisions, time for each of them, and the widths of x and kappa/r after 1, 10, 100 "
            "and the\n"
            "last bounce. A box begins 2^-(bits - 13) wide in both.\n\n");
        fmt::print("{:<16} {:>5} {:<6} {:<15} {:<21} {:>8}  {:<15}  {:<15}  {:<15}  {:<15}\n", "orbit",
                   "bits", "start", "form", "collisions", "us/coll.", "1", "10", "100", "last");
    }
    for (const HardOrbit& orbit : hard_orbits()) {
        const std::size_t all = length(orbit);
        measure<Interval>(orbit, all, 53, tsv, enough);
        for (int bits = 64; bits <= (shortest ? 64 : 1024); bits *= 2) {
            measure<BigInterval>(orbit, all, bits, tsv, enough);
        }
    }
    return 0;
}
