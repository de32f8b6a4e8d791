#include "flight/orbit.hpp"

#include "catch.hpp"
#include "orbit_reference.hpp"
#include "rooms/number/random.hpp"
#include "rooms/number/show.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

namespace {

struct Case {
    Rational q;
    double e, eta;
};

Real value(const Rational& q) { return Real(numerator(q).str()) / Real(denominator(q).str()); }
std::string show(const Case& c) { return say("q", to_fraction(c.q), "e", c.e, "eta", c.eta); }

template <class I>
RatioRange<I> range_at(const Rational& q) {
    const I r = enclose<I>(1 / q);
    return {r, r};
}

/// A state of the chart bridge from which several collisions follow on both sides.
Case random_case(Random& random) {
    static const char* const ratios[] = {"4.7", "10", "12", "25", "100", "1000", "1.5", "1", "37/3"};
    const Rational q = parse_rational(ratios[random.below(9)]);
    return {q, random.coin() ? random.uniform(0.01, 1.5) : random.scaled(1e-4, 1),
            random.coin() ? random.uniform(0.001, 2) : random.scaled(1e-6, 1)};
}

template <class I>
bool overlap(const I& x, const I& y) {
    return !certainly_less(x, y) && !certainly_less(y, x);
}

/// The paper's law (4), for the mass whose contact is at angle phi: after = law(before).
template <class I>
struct Law {
    I ydot, phidot;
};

template <class I>
Law<I> law_of_the_paper(const Collision<I>& b, I beta1, I beta2) {
    I cosine = sin_cos(b.phi).cos;
    if (b.heavy) {
        std::swap(beta1, beta2);
        cosine = -cosine;
    }
    const I two(2);
    const I below = beta1 + beta2 * sqr(cosine);
    const I turned = two * beta2 * sqr(cosine) / below;
    return {b.ydot_before * (turned - I(1)) - b.phidot_before * (two * beta1 * beta2 * cosine / below),
            b.phidot_before * (I(1) - turned) - b.ydot_before * (two * cosine / below)};
}

/// What every collision satisfies, whatever the orbit.
template <class I>
void check_physics(const Case& at, const std::vector<Collision<I>>& orbit) {
    const I q = enclose<I>(at.q);
    const I beta1 = enclose<I>(1 / (1 + at.q));
    const I beta2 = enclose<I>(at.q / (1 + at.q));
    for (const auto& b : orbit) {
        const auto angle = sin_cos(b.phi);
        const I mass_height = b.heavy ? b.y - beta1 * angle.sin : b.y + beta2 * angle.sin;
        const I other_height = b.heavy ? b.y + beta2 * angle.sin : b.y - beta1 * angle.sin;
        const I lever = b.heavy ? -beta1 * angle.cos : beta2 * angle.cos;
        const I energy_before = sqr(b.phidot_before) + q * sqr(b.ydot_before / beta2);
        const I energy_after = sqr(b.phidot_after) + q * sqr(b.ydot_after / beta2);
        const Law<I> law = law_of_the_paper(b, beta1, beta2);
        CAPTURE(say(at, b.phi, b.y));
        CHECK(encloses(mass_height, Real(0)));                                  // it touches the floor,
        CHECK(certainly_positive(other_height));                                // the other mass does not,
        CHECK(certainly_positive(-(b.ydot_before + b.phidot_before * lever)));  // it comes down
        CHECK(certainly_positive(b.ydot_after + b.phidot_after * lever));       // and goes up
        CHECK(encloses(energy_before, Real(1)));
        CHECK(encloses(energy_after, Real(1)));
        CHECK(overlap(law.ydot, b.ydot_after));
        CHECK(overlap(law.phidot, b.phidot_after));
        CHECK(certainly_positive(b.grazing_sine));
    }
}

/// Light contacts change sides; time goes forward from 0.
template <class I>
void check_order(const Case& at, const std::vector<Collision<I>>& orbit) {
    CAPTURE(show(at), orbit.size());
    CHECK((orbit[0].time.lo() <= 0 && orbit[0].time.hi() >= 0 && width(orbit[0].time) < 1e-12));
    int last_side = 0;
    for (std::size_t i = 0; i < orbit.size(); ++i) {
        if (i > 0) {
            CHECK(certainly_less(orbit[i - 1].time, orbit[i].time));
        }
        if (!orbit[i].heavy) {
            const int side = approximate(orbit[i].phi) > 0x1.921fb54442d18p+0 ? 1 : -1;
            CHECK(side != last_side);
            last_side = side;
        }
    }
}

/// How many collisions the reference finds on either side.
struct Sides {
    long forward = 0, backward = 0;
};
Sides sides(const std::vector<Event>& events) {
    const auto turning = std::find_if(events.begin(), events.end(), [](const Event& e) { return e.heavy; });
    return {events.end() - turning - 1, turning - events.begin()};
}

template <class I>
std::size_t check_orbit(const Case& at, std::size_t most, bool narrow = true) {
    const auto exact = orbit_through(Real(at.e), Real(at.eta), 1 / value(at.q), most, most);
    const Sides found = sides(exact);
    const auto orbit =
        enclose_orbit(BridgeContact<I>{I(at.e), I(at.eta), found.forward, found.backward}, range_at<I>(at.q));
    if (!orbit) {
        return 0;  // too close to grazing for this precision
    }
    REQUIRE(orbit->size() == exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const std::string names = escaped((*orbit)[i], exact[i]);
        if (!names.empty()) {
            FAIL(say(at, "collision", i, names));
        }
    }
    if (narrow) {
        check_order(at, *orbit);
        check_physics(at, *orbit);
    }
    return orbit->size();
}

}  // namespace

TEST_CASE("An orbit's enclosure in doubles holds every collision, and each obeys the laws") {
    Random random(181);
    std::size_t longest = 0;
    int enclosed = 0;
    for (int i = 0; i < scaled(150); ++i) {
        const std::size_t size = check_orbit<Interval>(random_case(random), 6);
        enclosed += size > 0 ? 1 : 0;
        longest = std::max(longest, size);
    }
    CHECK(enclosed > scaled(142));
    CHECK(longest >= 8);
}

TEST_CASE("An orbit's enclosure in multiple precision holds every collision of long orbits") {
    const PrecisionScope scope(128);
    Random random(182);
    std::size_t longest = 0;
    for (int i = 0; i < 60; ++i) {
        longest = std::max(longest, check_orbit<BigInterval>(random_case(random), 60));
    }
    CHECK(longest > 25);
    const std::size_t size = check_orbit<BigInterval>({parse_rational("1e4"), 1.0, 0.3}, 400);
    CHECK(size > 80);
}

TEST_CASE(
    "An orbit's enclosure with 20 to 40 bits, where rounding to the wrong side shows, holds every "
    "collision") {
    Random random(183);
    int enclosed = 0;
    for (int i = 0; i < scaled(120); ++i) {
        const PrecisionScope scope(20 + random.below(21));
        enclosed += check_orbit<BigInterval>(random_case(random), 3, false) > 0 ? 1 : 0;
    }
    CHECK(enclosed > scaled(80));
}

TEST_CASE("Collisions that are not certain give no orbit") {
    const Case at{10, 1.0, 0.3};
    const Sides found = sides(orbit_through(Real(at.e), Real(at.eta), 1 / value(at.q), 100, 100));
    const auto ask = [&](long forward, long backward) {
        return enclose_orbit(BridgeContact<Interval>{Interval(at.e), Interval(at.eta), forward, backward},
                             range_at<Interval>(at.q));
    };
    REQUIRE(ask(found.forward, found.backward));
    CHECK(ask(found.forward, found.backward)->size() ==
          static_cast<std::size_t>(1 + found.forward + found.backward));
    CHECK_FALSE(ask(found.forward + 1, found.backward));
    CHECK_FALSE(ask(found.forward, found.backward + 1));
    REQUIRE(ask(0, 0));
    CHECK(ask(0, 0)->size() == 1);
    CHECK(ask(0, 0)->front().heavy);
    CHECK_FALSE(enclose_orbit(BridgeContact<Interval>{Interval(not_a_number), Interval(0.3), 1, 1},
                              range_at<Interval>(10)));
    CHECK_FALSE(enclose_orbit(BridgeContact<Interval>{Interval(1), Interval(not_a_number), 1, 1},
                              range_at<Interval>(10)));
}

TEST_CASE("an orbit that is shown is the one that is kept: the contact, the later ones, the earlier ones") {
    const BridgeContact<Interval> contact{Interval(0.75), Interval(0.375), 3, 4};
    const auto range = range_at<Interval>(1000);
    const auto kept = enclose_orbit(contact, range);
    REQUIRE(kept);
    std::vector<Collision<Interval>> shown;
    REQUIRE(visit_orbit<Interval>(contact, range, [&](const auto& c) { shown.push_back(c); }));
    REQUIRE(shown.size() == kept->size());
    CHECK(shown[0].heavy);
    CHECK(shown[0].time.lo() == 0);
    CHECK(shown[0].y.lo() == (*kept)[4].y.lo());
    CHECK(shown[1].phi.lo() == (*kept)[5].phi.lo());
    CHECK(shown[1].time.lo() > 0);
    CHECK(shown[4].phidot_after.hi() == (*kept)[3].phidot_after.hi());
    CHECK(shown[7].y.hi() == kept->front().y.hi());
    CHECK(shown[7].time.hi() < shown[4].time.lo());
}
