// ns per bounce (flight and reflection at a light wall, the last flight of a ray included), for the same
// rays: in plain double, in Interval as the general count has it, and by the batch kernel with each backend
// of this machine. The counter `ratio` is against plain double in the same run (its median so far).

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <string>
#include <vector>

#include "batch/count.hpp"
#include "model/count.hpp"
#include "random.hpp"

using namespace dumbbell;
using dumbbell_test::Random;

namespace {

constexpr long cap = 1'000'000;

/// Outgoing rays of contacts with the bridge at ratios near q (L8): what a cover and a witness follow.
std::vector<batch::Query> bridge_rays(double q, int n) {
    Random random(1);
    std::vector<batch::Query> rays;
    while (static_cast<int>(rays.size()) < n) {
        const double r = 1 / (q * random.uniform(0.5, 1));
        const double e = random.uniform(0, std::numbers::pi / 2);
        const double eta = random.coin() ? random.uniform(0, 10) : random.scaled(1e-3, 0.3) / r;
        const double kappa = r * (std::cos(e) + eta);
        if (kappa < 1) {
            rays.push_back({{r * std::sin(e) + kappa * (std::numbers::pi - e), kappa, r}, cap});
        }
    }
    return rays;
}

/// What nobody would prove anything with: Newton's iteration and the reflection as in src/model, libm's sine
/// and cosine.
long plain_count(const Ray<double>& ray) {
    double c = ray.c;
    double kappa = ray.kappa;
    for (long count = 0;; ++count) {
        if (kappa >= 1) {
            return count;
        }
        double x = c / (1 - kappa);
        double sine = 0;
        double cosine = 0;
        for (int step = 0;; ++step) {
            if (!(x <= std::numbers::pi / 2) || step == 60) {
                return count;
            }
            sine = std::sin(x);
            cosine = std::cos(x);
            if (!(cosine > kappa)) {
                return count;
            }
            const double next = x - (sine - kappa * x - c) / (cosine - kappa);
            const bool done = !(std::abs(next - x) > 0x1p-50 * x);
            x = next;
            if (done) {
                break;
            }
        }
        const double denominator = cosine * cosine - 2 * kappa * cosine - ray.r;
        if (denominator <= 0) {
            return count + 1;
        }
        kappa = (kappa * cosine * cosine + ray.r * (2 * cosine - kappa)) / denominator;
        c = sine + kappa * (x + std::numbers::pi);
    }
}

Ray<Interval> enclosed(const Ray<double>& ray) {
    return {Interval(ray.c), Interval(ray.kappa), Interval(ray.r)};
}

/// ns per bounce of a job over all rays, kept for the medians at the end.
struct Series {
    std::string name;
    double q;
    std::vector<double> ns;
};
std::vector<Series>& all_series() {
    static std::vector<Series> series;
    return series;
}
double median(std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    return values[values.size() / 2];
}

template <class Job>
void measure(const std::string& name, double q, Job job) {
    const std::size_t index = all_series().size();
    all_series().push_back({name, q, {}});
    benchmark::RegisterBenchmark(
        (name + "/q=" + std::to_string(static_cast<long>(q))).c_str(),
        [=](benchmark::State& state) {
            const auto rays = bridge_rays(q, 2000);
            long bounces = 0;
            for (const auto& one : rays) {
                bounces += plain_count(one.ray) + 1;
            }
            for (auto _ : state) {
                const std::clock_t begin = std::clock();  // of this process alone
                benchmark::DoNotOptimize(job(rays));
                const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
                state.SetIterationTime(seconds);
                all_series()[index].ns.push_back(1e9 * seconds / static_cast<double>(bounces));
            }
            const double ns = median(all_series()[index].ns);
            const auto plain = std::ranges::find_if(all_series(), [&](const Series& s) { return s.q == q; });
            state.counters["ns/bounce"] = ns;
            state.counters["ratio"] = ns / median(plain->ns);
        })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
}

template <class Count>
auto one_by_one(Count count) {
    return [=](const std::vector<batch::Query>& rays) {
        long sum = 0;
        for (const auto& one : rays) {
            sum += count(one.ray);
        }
        return sum;
    };
}

auto batched(batch::Backend backend, bool most, bool least) {
    return [=](const std::vector<batch::Query>& rays) {
        std::vector<batch::Answer> answers(rays.size());
        if (most) {
            batch::count_at_most(rays, answers, backend);
        }
        if (least) {
            batch::count_at_least(rays, answers, backend);
        }
        return answers.front().count;
    };
}

void measure_all(double q) {
    measure("plain double, libm", q, one_by_one(plain_count));
    const auto at_most = [](const Ray<double>& ray) { return count_at_most(enclosed(ray), cap); };
    const auto at_least = [](const Ray<double>& ray) { return count_at_least(enclosed(ray), cap); };
    measure("Interval, one-sided", q, one_by_one(at_most));
    measure("Interval, two-sided", q,
            one_by_one([=](const Ray<double>& ray) { return at_most(ray) + at_least(ray); }));
    for (const batch::Backend backend : batch::backends()) {
        const std::string name = "batch " + std::string(batch::name(backend));
        measure(name + ", at most", q, batched(backend, true, false));
        measure(name + ", at least", q, batched(backend, false, true));
        measure(name + ", two-sided", q, batched(backend, true, true));
    }
}

}  // namespace

int main(int argc, char** argv) {
    for (const double q : {100.0, 1e4, 1e6}) {
        measure_all(q);
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
