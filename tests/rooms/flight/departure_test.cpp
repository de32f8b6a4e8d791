// Counting forward from a box of departures (lemma L15) bounds what the simulated dumbbell does from its
// states.
#include "flight/departure.hpp"

#include "catch.hpp"
#include "departures.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

namespace {

constexpr long departure_cap = 400;

template <class I>
Departure<I> lowest_of(const DepartureBox& box) {
    return lowest(departure(position(I(box.e.lo)), I(box.eta.lo)));
}
template <class I>
Departure<I> highest_of(const DepartureBox& box) {
    return highest(departure(position(I(box.e.hi)), I(box.eta.hi)));
}

template <class I>
long bound(const DepartureBox& box) {
    return later_collisions_at_most(lowest_of<I>(box), highest_of<I>(box), ratios_of<I>(box), departure_cap);
}

struct DepartureTally {
    long boxes = 0;
    long tight = 0;      // the bound is attained by a sampled state
    long undecided = 0;  // more than the cap
};

/// Fails if a sampled state has more collisions than the bound.
template <class I>
void check_box(Random& random, const DepartureBox& box, int samples, DepartureTally& tally) {
    const long most = bound<I>(box);
    bool attained = false;
    for (int k = 0; k < samples; ++k) {
        attained = sampled_within(random, box, most) == most || attained;
    }
    ++tally.boxes;
    tally.tight += attained ? 1 : 0;
    tally.undecided += most > departure_cap ? 1 : 0;
}

template <class I>
DepartureTally check_boxes(std::uint64_t seed, long boxes, double least_r, double widest) {
    Random random(seed);
    DepartureTally tally;
    for (long i = 0; i < boxes; ++i) {
        check_box<I>(random, random_departure_box(random, least_r, widest), 2, tally);
    }
    return tally;
}

}  // namespace

TEST_CASE(
    "From narrow boxes no simulated state collides more often than bounded, and the bound is mostly "
    "met") {
    const DepartureTally tally = check_boxes<Interval>(211, scaled(1'200), 1e-3, 1e-6);
    CHECK(tally.tight > tally.boxes * 3 / 4);
    CHECK(tally.undecided < tally.boxes / 100);
}

TEST_CASE("From boxes of up to double size, with ranges of ratios, the bound holds") {
    const DepartureTally tally = check_boxes<Interval>(212, scaled(1'200), 1e-3, 1);
    CHECK(tally.tight > tally.boxes / 2);
}

TEST_CASE(
    "From boxes that nearly touch the bridge or the wall ahead the bound holds at many points of "
    "each") {
    Random random(217);
    DepartureTally tally;
    for (int i = 0; i < scaled(1'500); ++i) {
        const Kind kind = tangent_kinds[random.below(3)];
        check_box<Interval>(random, random_departure_box(random, kind, 1e-2, 0.5), 6, tally);
    }
    CHECK(tally.tight > tally.boxes / 2);
}

TEST_CASE("In multiple precision the bound holds and is met at most points") {
    const PrecisionScope scope(200);
    const DepartureTally tally = check_boxes<BigInterval>(213, 400, 1e-2, 1e-15);
    CHECK(tally.tight > 330);
}

TEST_CASE("With 6 to 40 bits, where rounding to the wrong side shows, the bound from a departure holds") {
    Random random(214);
    DepartureTally tally;
    for (int i = 0; i < 3000; ++i) {
        const PrecisionScope scope(6 + random.below(35));
        check_box<BigInterval>(random, random_departure_box(random, 1e-2, 1e-2), 1, tally);
    }
    CHECK(tally.tight > 1000);
}

TEST_CASE("At mass ratios of 1e4 to 1e6, with up to hundreds of collisions, points are bounded closely") {
    Random random(215);
    int longest = 0;
    for (const double r : {1e-4, 1e-5, 1e-6}) {
        for (int i = 0; i < 12; ++i) {
            const double e = random.uniform(0.2, 1.2);
            const double eta = std::cos(e) + r * random.uniform(-40, 2);
            const DepartureBox box{{e, e}, {eta, eta}, {r, r}};
            const long most = later_collisions_at_most(lowest_of<Interval>(box), highest_of<Interval>(box),
                                                       ratios_of<Interval>(box), 5000);
            const long found = simulated({e, eta, r}).collisions;
            CAPTURE(show(box), found, most);
            CHECK(found <= most);
            CHECK(most <= found + 1);
            longest = std::max(longest, static_cast<int>(found));
        }
    }
    CHECK(longest > 300);
}

TEST_CASE("The latest contact with the bridge is not before any simulated one, and near it for points") {
    Random random(216);
    const long boxes = scaled(2'500);
    int contacts = 0;
    int near = 0;
    for (int i = 0; i < boxes; ++i) {
        const Kind kind = random.coin() ? Kind::bridge_tangent : random_kind(random);
        const DepartureBox box = random_departure_box(random, kind, 1e-3, random.coin() ? 1e-9 : 0.5);
        const auto low = lowest_of<Interval>(box);
        const auto high = highest_of<Interval>(box);
        const auto state = sample(random, box);
        const auto contact = simulated(state).bridge_contact;
        if (!contact || certainly_at_most(Interval(1), low.kappa)) {
            continue;
        }
        ++contacts;
        const BridgeApproach<Interval> over{high_end(high.sin_x + high.kappa * high.x), high.kappa};
        const double latest = latest_bridge_contact(over, low.kappa, ratios_of<Interval>(box)).hi();
        if (latest < *contact) {
            FAIL(say("contact at", *contact, "after", latest, "from", state, "of", box));
        }
        near += latest < *contact * (1 + 1e-3) + 1e-9 ? 1 : 0;
    }
    CHECK(contacts > boxes / 4);
    CHECK(near > contacts / 3);
}

TEST_CASE("A departure is bounded by its cap") {
    const DepartureBox box{{0.5, 0.5}, {std::cos(0.5), std::cos(0.5)}, {1e-4, 1e-4}};
    const long all = bound<Interval>(box);
    REQUIRE(all > 20);
    REQUIRE(all < departure_cap);
    const auto low = lowest_of<Interval>(box);
    const auto high = highest_of<Interval>(box);
    CHECK(later_collisions_at_most(low, high, ratios_of<Interval>(box), all) == all);
    CHECK(later_collisions_at_most(low, high, ratios_of<Interval>(box), all - 1) >= all);
    CHECK(later_collisions_at_most(low, high, ratios_of<Interval>(box), 0) >= 1);
}

TEMPLATE_TEST_CASE("NaN never gives a small count of departures", "", Interval, BigInterval) {
    using I = TestType;
    const I bad(not_a_number);
    const Departure<I> good{I(0.5), I(0.479), I(0.878), I(0.01)};
    const RatioRange<I> range{I(0.1), I(0.1)};
    CHECK(later_collisions_at_most(Departure<I>{bad, good.sin_x, good.cos_x, good.kappa}, good, range, 9) >
          9);
    CHECK(later_collisions_at_most(Departure<I>{good.x, bad, good.cos_x, good.kappa}, good, range, 9) > 9);
    CHECK(later_collisions_at_most(Departure<I>{good.x, good.sin_x, good.cos_x, bad}, good, range, 9) > 9);
    CHECK(later_collisions_at_most(good, good, RatioRange<I>{bad, bad}, 9) > 9);
}
