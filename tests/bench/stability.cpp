// How long enclosures of an orbit stay useful: collisions certified and widths against the number of bounces,
// for five forms of the same computation, at six precisions, on orbits that are hard to enclose.
//
// usage: stability [--tsv]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>

#include "hard_orbits.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

constexpr std::size_t shown_bounces[] = {1, 10, 100};

/// The widths of x and kappa/r after the bounce with this number, counted from 1.
template <class I>
std::string widths(const Propagated<I>& orbit, std::size_t bounce, double r) {
    if (bounce < 1 || bounce > orbit.boxes.size()) {
        return "-";
    }
    const auto& box = orbit.boxes[bounce - 1];
    return fmt::format("{:.1e} {:.1e}", width(box.x), width(box.kappa) / r);
}

/// The least time of `runs` runs, in microseconds.
template <class Run>
double microseconds(int runs, Run run) {
    double least = HUGE_VAL;
    for (int i = 0; i < runs; ++i) {
        const auto start = std::chrono::steady_clock::now();
        run();
        const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - start;
        least = std::min(least, spent.count());
    }
    return least;
}

template <class I>
void measure(const HardOrbit& orbit, std::size_t all, int bits, bool tsv) {
    const PrecisionScope scope(bits);
    const I r(orbit.r);
    for (const bool boxed : {false, true}) {
        const WallState<I> start = boxed ? small_box<I>(orbit, bits) : point<I>(orbit);
        for (const Form form : all_forms) {
            Propagated<I> result;
            const double spent =
                microseconds(bits == 53 ? 3 : 1, [&] { result = propagate(form, start, r); });
            std::string line =
                fmt::format(fmt::runtime(tsv ? "{}\t{}\t{}\t{}\t{}\t{}\t{}\t{:.1f}"
                                             : "{:<16} {:>5} {:<6} {:<15} {:>4} of {:>3} {:<9} {:>8.1f}"),
                            orbit.name, bits, boxed ? "box" : "point", name_of(form), result.collisions(),
                            all, result.finished() ? "finished" : "lost",
                            spent / static_cast<double>(std::max<std::size_t>(1, result.collisions())));
            const auto add = [&](std::size_t bounce) {
                const std::string text = widths(result, bounce, orbit.r);
                line += tsv ? "\t" + text : fmt::format("  {:<15}", text);
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
    const bool tsv = argc == 2 && std::strcmp(argv[1], "--tsv") == 0;
    if (argc > 1 && !tsv) {
        fmt::print(stderr, "usage: stability [--tsv]\n");
        return 2;
    }
    if (tsv) {
        fmt::print(
            "orbit\tbits\tstart\tform\tcollisions\tof\tend\tus/collision\twidths 1\twidths 10\twidths "
            "100\twidths last\n");
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
        measure<Interval>(orbit, all, 53, tsv);
        for (int bits = 64; bits <= 1024; bits *= 2) {
            measure<BigInterval>(orbit, all, bits, tsv);
        }
    }
    return 0;
}
