#pragma once

#include <cmath>
#include <map>

#include "attacks/oracle/simulate.hpp"
#include "catch.hpp"
#include "starts/answer/shares.hpp"

namespace dumbbell_trace_test {

/// How often random starts had each number of collisions, and how many of them are too close to a corner or a
/// tangency to tell.
struct Histogram {
    std::map<long, int> found;
    int trials = 0, doubtful = 0;

    template <class Run>
    void add(const Run& run) {
        ++found[static_cast<long>(run.collisions.size())];
        ++trials;
        doubtful += run.care.doubtful() ? 1 : 0;
    }

    /// They had them as often as is proved, within their own error.
    void check(const std::vector<dumbbell::starts::ShareBounds>& bounds) const {
        int seen = 0;
        for (const auto& b : bounds) {
            REQUIRE(b.most);
            const auto lo = b.lo.convert_to<double>(), hi = b.hi.convert_to<double>();
            for (long count = b.least; count <= *b.most; ++count) {
                const int hits = found.contains(count) ? found.at(count) : 0;
                seen += hits;
                // Six standard deviations of a binomial distribution, and what its smallest numbers scatter.
                const auto error = [&](double p) { return 6 * std::sqrt(trials * p * (1 - p)) + 12; };
                INFO(count << " collisions " << hits << " times, proved " << lo << " to " << hi);
                CHECK(hits + doubtful >= lo * trials - error(lo));
                CHECK(hits - doubtful <= hi * trials + (hi == 0 ? 0 : error(hi)));
            }
        }
        CHECK(seen + doubtful >= trials);  // no start has a number that is said to have the share 0
        CHECK(doubtful < trials / 50);
    }
};

}  // namespace dumbbell_trace_test
