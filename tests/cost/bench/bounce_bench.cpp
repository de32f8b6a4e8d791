// Google Benchmark: the bounce, for the same rays (bounce_rays.hpp) in plain double, in Interval and
// BigInterval, and with the intervals of other libraries (peers.hpp). Each benchmark is called
// "bounce/RATIO/METHOD"; its counter `operations` is the number of bounces of one iteration, `agreeing` the
// share of the rays whose counts are those of Interval. "orbits/RATIO/METHOD": one mass ratio's own orbits.

#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <numbers>
#include <string>

#include "bounce_rays.hpp"
#include "flight/count.hpp"
#include "peers.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_bench;

namespace {

using Rays = std::vector<Ray<double>>;
using Counts = std::vector<long>;
/// Appends the counts of all rays: the upper ones, then the lower ones.
using Job = std::function<void(const Rays&, Counts&)>;

/// Enough rays that no branch predictor learns them all by heart; fewer by this factor for what is slow.
constexpr std::size_t slow = 400;
struct Setting {
    std::string name;
    double q;
    std::size_t rays;
};

Ray<Interval> enclosed(const Ray<double>& ray) {
    return {Interval(ray.c), Interval(ray.kappa), Interval(ray.r)};
}
Ray<BigInterval> enclosed_big(const Ray<double>& ray) {
    return {BigInterval(ray.c), BigInterval(ray.kappa), BigInterval(ray.r)};
}
long own_at_most(const Ray<double>& ray, long most) { return count_at_most(enclosed(ray), most); }
long own_at_least(const Ray<double>& ray, long most) { return count_at_least(enclosed(ray), most); }

enum Sides { upper = 1, lower = 2, both = 3 };

template <class AtMost, class AtLeast>
Job one_by_one(AtMost at_most, AtLeast at_least, Sides sides) {
    return [=](const Rays& rays, Counts& counts) {
        if ((sides & upper) != 0) {
            for (const Ray<double>& ray : rays) {
                counts.push_back(at_most(ray, cap));
            }
        }
        if ((sides & lower) != 0) {
            for (const Ray<double>& ray : rays) {
                counts.push_back(at_least(ray, cap));
            }
        }
    };
}

double agreeing(const Counts& counts, const Counts& expected) {
    std::size_t same = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        same += counts[i] == expected[i] ? 1 : 0;
    }
    return static_cast<double>(same) / static_cast<double>(counts.size());
}

void measure(const Setting& setting, const std::string& method, Sides sides, const Job& job) {
    benchmark::RegisterBenchmark(("bounce/" + setting.name + "/" + method).c_str(),
                                 [=](benchmark::State& state) {
                                     const Rays rays = bridge_rays(setting.q, setting.rays);
                                     Counts expected;
                                     one_by_one(own_at_most, own_at_least, sides)(rays, expected);
                                     long bounces = 0;
                                     for (const Ray<double>& ray : rays) {
                                         bounces += plain_count(ray) + 1;
                                     }
                                     Counts counts;
                                     counts.reserve(2 * rays.size());
                                     for (auto _ : state) {
                                         counts.clear();
                                         job(rays, counts);
                                         benchmark::DoNotOptimize(counts.data());
                                     }
                                     state.counters["operations"] = static_cast<double>(bounces);
                                     state.counters["agreeing"] = agreeing(counts, expected);
                                 });
}

void measure_peer(const Setting& setting, const Peer& peer) {
    const Setting few{setting.name, setting.q, setting.rays / slow};
    const std::string name = peer.name;
    measure(few, name + ", one-sided", upper, one_by_one(peer.at_most, peer.at_least, upper));
    measure(few, name + ", two-sided", both, one_by_one(peer.at_most, peer.at_least, both));
}

/// With its own refinement of the guess to the working precision.
void measure_big(const Setting& setting, int bits) {
    const Setting few{setting.name, setting.q, setting.rays / slow};
    const auto at_most = [bits](const Ray<double>& ray, long most) -> long {
        const PrecisionScope scope(bits);
        return as_long(count_at_most(enclosed_big(ray), most));
    };
    const auto at_least = [bits](const Ray<double>& ray, long most) -> long {
        const PrecisionScope scope(bits);
        return as_long(count_at_least(enclosed_big(ray), most));
    };
    measure(few, "BigInterval " + std::to_string(bits) + " bits, two-sided", both,
            one_by_one(at_most, at_least, both));
}

void measure_all(const Setting& setting) {
    const auto plain = [](const Ray<double>& ray, long) { return plain_count(ray); };
    measure(setting, "plain double, libm", upper, one_by_one(plain, plain, upper));
    const auto warm = [](const Ray<double>& ray, long) { return warm_count(ray); };
    measure(setting, "plain double, warm", upper, one_by_one(warm, warm, upper));
    measure(setting, "Interval, one-sided", upper, one_by_one(own_at_most, own_at_least, upper));
    measure(setting, "Interval, two-sided", both, one_by_one(own_at_most, own_at_least, both));
    for (const Peer& peer : {cgal_with_own_sine, cgal_with_mpfr_sine, arb}) {
        measure_peer(setting, peer);
    }
    for (const int bits : {64, 128, 256, 512, 1024}) {
        measure_big(setting, bits);
    }
}

/// Both extremal orbits of one mass ratio (L21), bounce after bounce: what the growth of `certify` is
/// compared with in docs/7-speed.md.
void measure_orbits(double q) {
    benchmark::RegisterBenchmark(
        fmt::format("orbits/q={:g}/plain double, warm", q).c_str(), [=](benchmark::State& state) {
            const double r = 1 / q;
            long bounces = 0;
            for (auto _ : state) {
                bounces = warm_count({r, 0, r}) + warm_count({r * std::numbers::pi, r, r});
                benchmark::DoNotOptimize(bounces);
            }
            state.counters["operations"] = static_cast<double>(bounces);
        });
}

}  // namespace

int main(int argc, char** argv) {
    for (const Setting& setting :
         {Setting{"q=100", 100, 40000}, Setting{"q=1e4", 1e4, 8000}, Setting{"q=1e6", 1e6, 1600}}) {
        measure_all(setting);
    }
    for (const double q : {1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e14}) {
        measure_orbits(q);
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
