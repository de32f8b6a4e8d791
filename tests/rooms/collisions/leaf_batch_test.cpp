
#include "catch.hpp"
#include "collisions/leaf_judges.hpp"
#include "rooms/number/random.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;

namespace {

/// Boxes of all sizes, as a cover meets them.
std::vector<Box> some_boxes(Random& random, Chart chart, int n) {
    std::vector<Box> boxes;
    for (int i = 0; i < n; ++i) {
        const int q = 2 + random.below(60);
        Box box = root_box(chart, q, q + Rational(random.below(3), 4));
        for (int cuts = random.below(24); cuts > 0; --cuts) {
            const Axis axis = random.below(8) == 0 ? Axis::ratio
                              : random.coin()      ? Axis::slope
                                                   : Axis::position;
            const auto [lower, upper] = halves(box, axis);
            box = random.below(4) == 0 ? upper : lower;
        }
        boxes.push_back(box);
    }
    return boxes;
}

}  // namespace

TEST_CASE("Boxes judged together: closed and open ones are so for Interval too, and unsure ones are few") {
    Random random(501);
    int closed = 0;
    int open = 0;
    int unsure = 0;
    for (const Chart chart : {Chart::bridge, Chart::light}) {
        for (const long upper : {2L, 4L, 7L, 12L}) {
            const auto boxes = some_boxes(random, chart, 1'500);
            std::vector<std::optional<Leaf>> results(boxes.size());
            const auto verdicts = judge_turning_together(chart, boxes, upper, results, never);
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                const auto alone = judge_turning<Interval>(chart, boxes[i], upper, never);
                REQUIRE(results[i].has_value() == (verdicts[i] == BoxJudgement::closed));
                if (verdicts[i] == BoxJudgement::unsure) {
                    ++unsure;
                    continue;
                }
                REQUIRE(alone.has_value() == results[i].has_value());
                (results[i] ? closed : open) += 1;
                if (results[i]) {
                    CHECK(alone->reason == results[i]->reason);
                    CHECK(1 + results[i]->forward + results[i]->backward <= upper);
                    CHECK(results[i]->forward >= alone->forward);
                }
            }
        }
    }
    CHECK(closed > 1'000);
    CHECK(open > 1'000);
    WARN("unsure: " << unsure << " of " << closed + open + unsure);
}
