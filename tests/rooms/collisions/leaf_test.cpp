#include "collisions/leaf.hpp"

#include <array>
#include <map>

#include "base/error.hpp"
#include "catch.hpp"
#include "reference.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;

namespace {

std::optional<Leaf> judged(Chart chart, const Box& box, long upper) {
    return judge<Interval>(chart, box, upper);
}

Reason reason_of(Chart chart, const Box& box, long upper) {
    const auto leaf = judged(chart, box, upper);
    REQUIRE(leaf.has_value());
    return leaf->reason;
}

const Rational ratio_ten = 10;

}  // namespace

TEST_CASE("a box beyond the peak, or of rays too steep to come back, is outside in both charts") {
    for (const Chart chart : {Chart::bridge, Chart::light}) {
        CHECK(reason_of(chart, {at("1.6"), 2, 0, 1, ratio_ten, ratio_ten}, 1) == Reason::outside);
        CHECK(reason_of(chart, {0, 1, at("10.001"), 12, ratio_ten, ratio_ten}, 1) == Reason::outside);
        CHECK(reason_of(chart, {0, 1, at("12.001"), 14, 10, 12}, 1) == Reason::outside);
    }
}

TEST_CASE("a box that only touches the section from outside is not called outside") {
    for (const Chart chart : {Chart::bridge, Chart::light}) {
        const auto below_peak = judged(chart, {at("1.5707963"), 2, 0, at("0.001"), ratio_ten, ratio_ten}, 1);
        CHECK((!below_peak || below_peak->reason != Reason::outside));
        const auto slow = judged(chart, {at("1.5"), at("1.55"), at("9.999"), 10, ratio_ten, ratio_ten}, 1);
        CHECK((!slow || slow->reason != Reason::outside));
        // The greatest ratio of the box decides: slope 10/12 at q = 12.
        const auto some_slow = judged(chart, {at("1.5"), at("1.55"), 11, 12, 10, 12}, 1);
        CHECK((!some_slow || some_slow->reason != Reason::outside));
    }
}

TEST_CASE("a contact with a light wall that the ray leaves too steeply to have come down is outside") {
    const Box box{0, at("0.1"), 3, 4, ratio_ten, ratio_ten};
    CHECK(reason_of(Chart::light, box, 1) == Reason::outside);
}

TEST_CASE("low and flat rays from a light wall meet the bridge, forwards or backwards") {
    CHECK(reason_of(Chart::light, {0, at("0.01"), 0, at("0.01"), ratio_ten, ratio_ten}, 1) == Reason::meets);
    CHECK(reason_of(Chart::light, {0, at("0.01"), at("1.99"), 2, ratio_ten, ratio_ten}, 1) ==
          Reason::meets_reversed);
}

TEST_CASE("the whole section of q = 10 closes with counts for 4 collisions and not for 3") {
    const Box root = root_box(Chart::light, ratio_ten, ratio_ten);
    const auto bridge = judged(Chart::bridge, root, 4);
    REQUIRE(bridge.has_value());
    CHECK(bridge->reason == Reason::count);
    CHECK(1 + bridge->forward + bridge->backward <= 4);
    CHECK(reason_of(Chart::light, root, 4) == Reason::count);
    CHECK_FALSE(judged(Chart::bridge, root, 3).has_value());
}

TEST_CASE("a wider box, or a wider range of ratios, never closes with smaller counts") {
    Random choices(11);
    int compared = 0;
    for (int i = 0; i < 300; ++i) {
        const Rational q = exact(choices.log_uniform(1.01, 100));
        const Rational e = exact(choices.log_uniform(1e-3, 1));
        const Rational eta = exact(choices.log_uniform(1e-3, 1));
        const Box small{e, e * 11 / 10, eta, eta * 11 / 10, q, q};
        const Box large{e * 9 / 10, e * 12 / 10, eta * 9 / 10, eta * 12 / 10, q, q * 11 / 10};
        for (const Chart chart : {Chart::bridge, Chart::light}) {
            const auto wide = judged(chart, large, 40);
            const auto narrow = judged(chart, small, 40);
            if (wide && narrow && wide->reason == Reason::count && narrow->reason == Reason::count) {
                ++compared;
                CAPTURE(q, e, eta);
                REQUIRE(wide->forward >= narrow->forward);
                REQUIRE(wide->backward >= narrow->backward);
            }
        }
    }
    CHECK(compared > 300);
}
