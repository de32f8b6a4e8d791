// proofs/theorem.md, L21: the counts of the bridge's tangents.
#include "extremal.hpp"

#include <algorithm>

#include "catch.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

const Digits80 half_turn_80 = pi<Digits80>() / 2;

// Ratios where something is tight: random, close to 1, and next to critical ratios.
double hard_ratio(Sampler& sampler, double greatest) {
    const double pick = sampler.uniform(0, 1);
    if (pick < 0.6) return random_ratio(sampler, greatest);
    const auto n = static_cast<std::size_t>(sampler.uniform(4, 16));
    const double gap = sampler.log_uniform(1e-12, 1e-3);
    const auto critical = static_cast<double>(critical_ratio(n).above);
    return critical * (sampler.coin() ? 1 + gap : 1 - gap);
}

}  // namespace

TEST_CASE("L21: the two tangent counts are monotone along the bridge, k0 and 1 + k1 at its ends") {
    Sampler sampler(1, 802);
    for (int i = 0; i < scaled(150); ++i) {
        const double ratio = hard_ratio(sampler, 1e3);
        const Digits80 r = 1 / Digits80(ratio);
        const auto [k0, k1] = theorem(Digits80(ratio));
        if (k1 > k0 || k0 > k1 + 1) FAIL(say("q", ratio, "k0", k0, "k1", k1));
        std::vector<Digits80> places{0, half_turn_80};
        for (int k = 0; k < 8; ++k) {
            const double e = sampler.coin() ? sampler.log_uniform(1e-15, 1.5) : sampler.uniform(0, 1.57);
            places.push_back(sampler.coin() ? Digits80(e) : Digits80(half_turn_80 - e));
        }
        std::sort(places.begin(), places.end());
        std::size_t left = k1;
        std::size_t right = 1 + k1;
        for (const Digits80& e : places) {
            const std::size_t l = count_left(e, r);
            const std::size_t f = count_right(e, r);
            const bool at_corner = e == 0;
            const bool at_top = e == half_turn_80;
            const bool ok = l >= left && f <= right && l <= k0 && f >= k0 &&
                            (!at_corner || (l == k1 && f == 1 + k1)) && (!at_top || (l == k0 && f == k0));
            if (!ok) FAIL(say("q", ratio, "e", e, "left", left, l, "right", right, f, "k", k0, k1));
            left = l;
            right = f;
        }
    }
    SUCCEED();
}
