// theory.md section 4 against the simulation: no trajectory has more than N* = 2 + k0 + k1 collisions, and
// the adversarial samples reach N*.
#include <algorithm>

#include "catch.hpp"
#include "ray_count.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

struct Found {
    std::size_t most = 0;
    std::size_t most_heavy = 0;
    int longest_without_bridge = 0;
    std::string excess;
};

// Every family, until about `work` collisions are simulated in each. Long double counts that exceed the bound
// are repeated with 80 digits before they are believed.
Found hunt(double ratio, std::size_t bound, long work, std::uint64_t seed) {
    Found found;
    Sampler sampler(ratio, seed);
    const Dumbbell<Real> body(ratio);
    for (const Family family : all_families) {
        for (std::size_t done = 0; done < static_cast<std::size_t>(work);) {
            const Start start = sampler.next(family);
            const Total<Real> total = total_collisions(body, start);
            done += total.collisions + 1;
            if (total.care.near_corner()) continue;  // long double miscounts; see corner_test
            std::size_t collisions = total.collisions;
            if (collisions > bound || total.heavy > 1) collisions = careful_total(ratio, start);
            if (collisions > bound) found.excess = say(describe(start), "has", collisions);
            found.most = std::max(found.most, collisions);
            found.most_heavy = std::max(found.most_heavy, total.heavy);
            if (collisions == bound && total.heavy == 0 && !total.care.doubtful())
                ++found.longest_without_bridge;
        }
    }
    return found;
}

}  // namespace

TEST_CASE("theorem: no simulated total exceeds 2 + k0 + k1, and the maximum is found") {
    for (const double ratio : {4.7, 10.0, 12.0, 25.0, 100.0, 1000.0}) {
        const std::size_t bound = theorem<Real>(ratio).maximum();
        const Found found = hunt(ratio, bound, scaled(3'000), 602);
        INFO("q " << ratio << " bound " << bound << " found " << found.most << ' ' << found.excess);
        CHECK(found.excess.empty());
        CHECK(found.most == bound);
        CHECK(found.most_heavy == 1);
        // "every longest trajectory hits the floor with the heavy mass exactly once"
        CHECK(found.longest_without_bridge == 0);
    }
}

TEST_CASE("theorem: never exceeded next to critical ratios, near 1 and far out") {
    Sampler seeds(1, 603);
    const Real tan_root = 4.49340945790906417530788092728L;  // first positive root of tan x = x
    const double critical4 = static_cast<double>(std::sqrt(1 + tan_root * tan_root));
    std::vector<double> ratios = {1 + 1e-12, 1.0000001, 1.1, 4.6, 4.61, 1e4, 1e6};
    for (const double gap : {1e-4, 1e-6, 1e-9}) {
        ratios.push_back(critical4 * (1 - gap));
        ratios.push_back(critical4 * (1 + gap));
        CHECK(theorem<Real>(critical4 * (1 - gap)).maximum() == 3);
        CHECK(theorem<Real>(critical4 * (1 + gap)).maximum() == 4);
    }
    for (int i = 0; i < 15; ++i) ratios.push_back(seeds.log_uniform(1, 1000));
    for (const double ratio : ratios) {
        const std::size_t bound = theorem<Digits80>(ratio).maximum();
        const Found found = hunt(ratio, bound, scaled(800), 604);
        INFO("q " << ratio << " bound " << bound << " found " << found.most << ' ' << found.excess);
        CHECK(found.excess.empty());
        CHECK(found.most_heavy == 1);
        CHECK(found.longest_without_bridge == 0);
        if (ratio < 1e4) CHECK(found.most + 1 >= bound);
    }
}
