// Counting by plain interval evaluation (lemma L16) bounds what the simulated dumbbell does from the states
// of a box.
#include "flight/plain.hpp"

#include "catch.hpp"
#include "departures.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

namespace {

template <class I>
I ratios(const DepartureBox& box) {
    return I(box.r.lo, box.r.hi);
}

template <class I>
PlainDeparture<I> departures(const DepartureBox& box) {
    const auto all = departure(position(I(box.e.lo, box.e.hi)), I(box.eta.lo, box.eta.hi));
    return {all.x, all.sin_x, flight::detail::in_play(all.kappa)};
}

struct PlainTally {
    long boxes = 0;
    long decided = 0;
    long met = 0;  // the bound is attained by the sampled state
};

template <class I>
void check_plain_box(Random& random, const DepartureBox& box, PlainTally& tally) {
    const long most =
        plain_later_collisions(departures<I>(box), Body<I>::massless(ratios<I>(box)), plain_cap);
    ++tally.boxes;
    tally.decided += most <= plain_cap ? 1 : 0;
    tally.met += sampled_within(random, box, most) == most ? 1 : 0;
}

template <class I>
PlainTally check_plain_boxes(std::uint64_t seed, long boxes, double least_r, double widest) {
    Random random(seed);
    PlainTally tally;
    for (long i = 0; i < boxes; ++i) {
        check_plain_box<I>(random, random_departure_box(random, least_r, widest), tally);
    }
    return tally;
}

}  // namespace

TEST_CASE("From narrow boxes no simulated state collides more often than plain evaluation bounds") {
    const PlainTally tally = check_plain_boxes<Interval>(221, scaled(2'000), 1e-2, 1e-6);
    CHECK(tally.decided > tally.boxes * 15 / 16);
    CHECK(tally.met > tally.boxes * 13 / 16);
}

TEST_CASE("From boxes of up to double size plain evaluation bounds, or says that it cannot") {
    const PlainTally tally = check_plain_boxes<Interval>(222, scaled(2'000), 1e-2, 1);
    CHECK(tally.decided > tally.boxes / 2);
}

TEST_CASE("From boxes that nearly touch the bridge or the wall ahead plain evaluation bounds") {
    Random random(229);
    PlainTally tally;
    for (int i = 0; i < scaled(5'000); ++i) {
        const Kind kind = tangent_kinds[random.below(3)];
        check_plain_box<Interval>(random, random_departure_box(random, kind, 1e-2, 0.5), tally);
    }
    CHECK(tally.decided > tally.boxes / 2);
}

TEST_CASE("In multiple precision plain evaluation bounds, and mostly exactly at points") {
    const PrecisionScope scope(200);
    const PlainTally tally = check_plain_boxes<BigInterval>(223, 400, 1e-2, 1e-15);
    CHECK(tally.decided > 390);
    CHECK(tally.met > 350);
}

TEST_CASE("With 6 to 40 bits, where rounding to the wrong side shows, plain evaluation bounds") {
    Random random(224);
    PlainTally tally;
    for (int i = 0; i < 3000; ++i) {
        const PrecisionScope scope(6 + random.below(35));
        check_plain_box<BigInterval>(random, random_departure_box(random, 1e-2, 1e-2), tally);
    }
    CHECK(tally.met > 500);
}

TEST_CASE("The place of the first contact with the bridge is enclosed") {
    Random random(228);
    const long boxes = scaled(1'500);
    int contacts = 0;
    for (int i = 0; i < boxes; ++i) {
        const DepartureBox box = random_departure_box(random, 1e-3, random.coin() ? 1e-9 : 0.1);
        const auto from = departures<Interval>(box);
        const auto r = ratios<Interval>(box);
        const auto state = sample(random, box);
        const auto contact = simulated(state).bridge_contact;
        if (!contact || !(std::cos(state.e) > state.eta - 1)) {
            continue;
        }
        ++contacts;
        const BridgeApproach<Interval> over{max(Interval(0), from.sin_x + from.kappa * from.x), from.kappa};
        const Interval latest =
            latest_bridge_contact(BridgeApproach<Interval>{high_end(over.height), high_end(over.kappa)},
                                  low_end(from.kappa), RatioRange<Interval>{low_end(r), high_end(r)});
        const Interval t = flight::detail::bridge_contacts(over, latest, r);
        const double tolerance = 1e-9 * *contact;  // grazing contacts in long double
        if (!(t.lo() <= *contact + tolerance && *contact - tolerance <= t.hi())) {
            FAIL(say("contact at", *contact, "not in", t, "from", state, "of", box));
        }
    }
    CHECK(contacts > boxes / 4);
}

TEMPLATE_TEST_CASE("NaN never gives a small plain count", "", Interval, BigInterval) {
    using I = TestType;
    const I bad(not_a_number);
    const auto body = Body<I>::massless(I(0.1)), unknown = Body<I>::massless(bad);
    const PlainDeparture<I> good{I(0.5), I(0.479, 0.48), I(0.01)};
    CHECK(plain_later_collisions(PlainDeparture<I>{good.x, good.sin_x, bad}, body, 9) > 9);
    CHECK(plain_later_collisions(good, unknown, 9) > 9);
    CHECK(plain_count(dumbbell::flight::PlainRay<I>{bad, I(0.01)}, body, 9) > 9);
    CHECK(plain_count(dumbbell::flight::PlainRay<I>{I(0.01), bad}, body, 9) > 9);
    CHECK(plain_count(dumbbell::flight::PlainRay<I>{I(0.01), I(0.01)}, unknown, 9) > 9);
}
