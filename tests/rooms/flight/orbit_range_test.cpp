// enclose_orbit over a range of mass ratios and of contacts: the orbits at single points of it are inside.
#include "catch.hpp"
#include "flight/orbit.hpp"
#include "orbit_reference.hpp"
#include "rooms/number/random.hpp"
#include "rooms/number/show.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

namespace {

struct Box {
    double e, eta, r_lo, r_hi;
};

std::string show(const Box& b) { return say("e", b.e, "eta", b.eta, "r from", b.r_lo, "to", b.r_hi); }

/// Fails if an orbit at a sampled ratio leaves the enclosure; returns whether there was one.
template <class I>
bool check_box(Random& random, const Box& box, long most_forward, long most_backward) {
    const auto sides_at = [&](const Real& r) {
        return orbit_through(Real(box.e), Real(box.eta), r, static_cast<std::size_t>(most_forward),
                             static_cast<std::size_t>(most_backward));
    };
    // The numbers at the greatest r are the certain ones (L8 with L5).
    const auto fewest = sides_at(Real(box.r_hi));
    const auto turning = std::find_if(fewest.begin(), fewest.end(), [](const Event& e) { return e.heavy; });
    const long backward = turning - fewest.begin();
    const long forward = fewest.end() - turning - 1;
    const auto orbit = enclose_orbit(BridgeContact<I>{I(box.e), I(box.eta), forward, backward},
                                     RatioRange<I>{I(box.r_lo), I(box.r_hi)});
    if (!orbit) {
        return false;
    }
    for (int i = 0; i < 4; ++i) {
        const Real r = i < 2 ? Real(i == 0 ? box.r_lo : box.r_hi)
                             : Real(box.r_lo) + (Real(box.r_hi) - box.r_lo) * random.uniform(0, 1);
        const auto exact = orbit_through(Real(box.e), Real(box.eta), r, static_cast<std::size_t>(forward),
                                         static_cast<std::size_t>(backward));
        REQUIRE(exact.size() == orbit->size());
        for (std::size_t k = 0; k < exact.size(); ++k) {
            const std::string names = escaped((*orbit)[k], exact[k]);
            if (!names.empty()) {
                FAIL(say(box, "at r", r, "collision", k, names));
            }
        }
    }
    return true;
}

Box random_box(Random& random) {
    const double r = random.scaled(0.005, 0.6);
    return {random.uniform(0.05, 1.5), random.scaled(1e-3, 2), r * (1 - random.scaled(1e-15, 0.1)), r};
}

}  // namespace

TEST_CASE("Over a range of ratios the orbits after the turning collision, and before it, are enclosed") {
    Random random(191);
    for (const auto& [forward, backward] : {std::pair(4, 0), {0, 4}}) {
        int enclosed = 0;
        for (int i = 0; i < scaled(100); ++i) {
            enclosed += check_box<Interval>(random, random_box(random), forward, backward) ? 1 : 0;
        }
        CHECK(enclosed > scaled(25));
    }
}

TEST_CASE(
    "A descending flight into the turning collision is enclosed for all mass ratios from 10 to 10.0001") {
    Random random(193);
    const Box box{1.0, 0.45, 1 / 10.0001, 1 / 10.0};
    const bool in_double = check_box<Interval>(random, box, 0, 1);
    CHECK(in_double);
    const PrecisionScope scope(128);
    const bool in_multiple_precision = check_box<BigInterval>(random, box, 0, 1);
    CHECK(in_multiple_precision);
}
