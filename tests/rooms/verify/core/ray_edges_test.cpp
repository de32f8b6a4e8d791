// Single steps of the verifier at the edge of their conditions: what is refused there, what is just granted,
// and that its work is counted.
#include <cmath>

#include "catch.hpp"
#include "leaf_rows.hpp"
#include "verify/functions/exact_value.hpp"
#include "verify/sections/flights.hpp"
#include "verify/wings/starts/reflection.hpp"

using namespace dumbbell_verify;
using dumbbell_verify::starts::Departures;
using dumbbell_verify::starts::FirstReflection;
using dumbbell_verify::starts::Flight;

namespace {

using DoublePair = Interval<double>;

/// The bridge of a box, with its parts in reach.
struct OpenBridge : Bridge<double> {
    using Base = Bridge<double>;
    using Base::certainly_above, Base::contacts, Base::half_turn, Base::trig;
    explicit OpenBridge(const Leaf& leaf) : Base(leaf, full(), nullptr) {}
};
/// Flights of a box, of which two enclosures may be made to exclude each other.
struct OpenFlights : Flights<double> {
    using Base = Flights<double>;
    using Base::rebound, Base::slope_behind, Base::wall;
    using Wall = Base::Wall;
    explicit OpenFlights(const Leaf& leaf) : Base(leaf, plain(), nullptr) {}
};
struct OpenStart : Departures<double> {
    using Departures<double>::Departures, Departures<double>::contacts;
};
template <class N>
struct Excluding {
    Excluding(const Leaf&, Log*) {}
    const char* verdict() {
        return meet(Interval<N>(N(0), N(1)), Interval<N>(N(2), N(3))).lo > N(0) ? nullptr : "";
    }
};
Leaf at_ratio(int q) {
    Leaf leaf;
    leaf.chart = departure;
    leaf.box = {{0, 0, q}, {1, 1, q}};
    return leaf;
}
Flight<double> flight(const mpq_class& w_lo, const mpq_class& w_hi, const mpq_class& v, const mpq_class& q) {
    starts::Box box;
    box.lo = {0, w_lo, 1, v, q};
    box.hi = {0, w_hi, 1, v, q};
    return Flight<double>(box);
}
std::string said_of_leaf(const std::string& words) { return leaf_rows::judged(leaf_rows::parsed(words)); }

}  // namespace

TEST_CASE("a ray that misses by little misses for certain with little more bits than tell it") {
    for (const int bits : {64, 160, 288, 1056}) {
        Big::precision = bits;
        CAPTURE(bits);
        const Big half = bound(down, mpq_class(1, 2), Big()), third = div(down, pi<Big>().lo, 3);
        const Big tangent = (sin_cos(third).sin - Interval<Big>(third) / Interval<Big>(2)).hi;
        const Big little = bound(down, mpq_class(mpq_class(1) >> (bits - 6)), Big());
        CHECK(Rays<Big>(nullptr).misses({add(down, tangent, little), half, half}));
        CHECK_FALSE(Rays<Big>(nullptr).misses({sub(down, tangent, little), half, half}));
    }
    Big::precision = 53;
}

TEST_CASE("step edges: from a point where the wall is too flat, the contact is bounded from the corner") {
    const Rays<double> rays(nullptr);
    // cos 1.5 < 0.2; and 1.5708 is beyond the peak. L12 (a) at z = 0: x >= c / (1 - kappa) = 0.625.
    for (const double z : {1.5, 1.5708}) {
        const auto at = rays.earliest({0.5, 0.2, 0.1}, z);
        CHECK(at.x == Approx(0.625));
        CHECK(at.x <= 0.625);
        CHECK((at.cosine >= std::cos(0.625) && at.cosine <= 1));
        CHECK((at.sine <= std::sin(0.625) && at.sine >= 0.4));
    }
}

TEST_CASE("step edges: a contact's sine and cosine are bounded however far the guess is off") {
    const Rays<double> rays(nullptr);
    int contacts = 0;
    for (const double z : {0.25, 0.75, 1.25, 1.375, 1.5})
        for (const double d : {-0.25, -0.125, -0.0625, 0.03125, 0.0625, 0.125, 0.25}) {
            const double kappa = std::cos(z) / 4, p = std::cos(z) - kappa;
            const double c = std::sin(z) - kappa * z + p * d;  // the tangent at z meets the ray at z + d
            CAPTURE(z, d);
            const auto low = rays.earliest({c, kappa, 0.1}, z);
            CHECK(low.x == Approx(z + d));
            CHECK(low.sine <= std::sin(low.x));
            CHECK(low.cosine >= std::cos(low.x));
            if (const auto high = rays.latest({c, kappa, 0.1}, z)) {
                ++contacts;
                CHECK(high->sine >= std::sin(high->x));
                CHECK(high->cosine <= std::cos(high->x));
            }
        }
    CHECK(contacts > 5);
}

TEST_CASE("step edges: of a certain contact a positive cosine is known") {
    const Rays<double> rays(nullptr);
    // The higher ray meets the wall below pi/2, too, but cos x >= -0.04 is all that the guess tells.
    for (int i = 0; i < 100; ++i) {
        const double z = 0.9 + i / 2000.0;
        double known = std::sin(z) + 0.15, unknown = std::sin(z) + 0.19;
        CAPTURE(z);
        for (int k = 0; k < 60; ++k) {
            const double c = (known + unknown) / 2;
            (rays.latest({c, 0, 0.1}, z) ? known : unknown) = c;
        }
        CHECK_FALSE(rays.latest({std::sin(z) + 0.19, 0, 0.1}, z));
        const auto at = rays.latest({known, 0, 0.1}, z);
        REQUIRE(at);
        CHECK(at->cosine > 0);
    }
}

TEST_CASE("step edges: a ray with D = 0 does not return") {
    Rays<Big> rays(nullptr);
    const auto exact = [](double x) { return bound(down, mpq_class(x), Big()); };
    for (const Round d : {down, up}) {
        Rays<Big>::Ray ray{exact(0.5), Big(0), exact(0.25)}, lower = ray;
        CHECK_FALSE(rays.reflect(d, ray, {exact(0.5), exact(0.5), exact(0.5)}));  // D = 1/4 - r
        CHECK(rays.reflect(d, lower, {exact(0.5), exact(0.5), exact(0.625)}));
    }
}

TEST_CASE("step edges: a ray through the corner has no certain contact") {
    const Rays<double> rays(nullptr);
    CHECK_FALSE(rays.latest({0, 0.5, 0.1}, 0));
    CHECK(rays.latest({0x1p-40, 0.5, 0.1}, 0));
    CHECK_FALSE(Rays<double>(nullptr).at_least("", {0, 0.5, 0.1}, 1));
}

TEST_CASE("step edges: of a contact that just is certain, L12 (b) holds exactly") {
    const Rays<double> rays(nullptr);
    for (int k = 0; k < 64; ++k) {
        // At z = 0, where g = -c and p = 1 - kappa: up to c = p^2 / 2.
        const double kappa = k / 64.0, p = 1 - kappa;
        double certain = p * p / 4, uncertain = p * p;
        for (int i = 0; i < 60; ++i) {
            const double c = (certain + uncertain) / 2;
            (rays.latest({c, kappa, 0.1}, 0) ? certain : uncertain) = c;
        }
        const auto at = rays.latest({certain, kappa, 0.1}, 0);
        REQUIRE(at);
        const mpq_class x = at->x;
        CAPTURE(k);
        CHECK((mpq_class(certain) + x * x / 2 < mpq_class(p) * x));
    }
}

TEST_CASE("step edges: L12 (b) is certified with its sum rounded up") {
    // At z = 0 with p next to 1/sqrt 2 and c below 1/4 by a last bit, both sides of it agree in all bits but
    // a few.
    int contacts = 0;
    for (int bits = 53; bits <= 400; ++bits) {
        Big::precision = bits;
        const Big p = guess_square_root(bound(down, mpq_class(1, 2), Big())), kappa = sub(down, Big(1), p);
        for (int less = 1; less <= 9; ++less) {
            const mpq_class c = (1 - (mpq_class(less) >> bits)) / 4;
            const auto at = Rays<Big>(nullptr).latest({bound(down, c, p), kappa, p}, Big(0));
            if (!at) continue;
            ++contacts;
            const mpq_class x = exact_value(at->x);
            CAPTURE(bits, less);
            CHECK((c + x * x / 2 < exact_value(p) * x));
        }
    }
    CHECK(contacts > 100);
    Big::precision = 53;
}

TEST_CASE("step edges: a flight below the corner is not above the bridge, however steep") {
    const Leaf leaf = at_ratio(2);
    OpenBridge bridge(leaf);
    CHECK(bridge.certainly_above(0, 0.5));
    CHECK(bridge.certainly_above(0.001, 0.5));
    CHECK_FALSE(bridge.certainly_above(-0.001, 0.5));
    CHECK_FALSE(bridge.certainly_above(-0.001, 3));
    CHECK_FALSE(bridge.certainly_above(0, 0.499));
}

TEST_CASE("step edges: all meet the bridge that are below it at one point, be it next to a tangency") {
    const Leaf leaf = at_ratio(2);
    OpenBridge bridge(leaf);
    // A tangent of sin t / 2, less a little: it is below the bridge between two contacts, near 2^-24 at last.
    for (const double t : {0.5, 1.125, 1.375}) {
        const double kappa = 0.5 * std::cos(t), h = 0.5 * (std::sin(t) - t * std::cos(t));
        for (const double gap : {0x1p-6, 0x1p-20, 0x1p-40, 0x1p-48, 0x1p-49, 0x1p-50}) {
            CAPTURE(t, gap);
            CHECK(bridge.contacts(kappa, h - gap, kappa).all);
            CHECK_FALSE(bridge.contacts(kappa, h + gap, kappa).all);
        }
    }
}

TEST_CASE("step edges: who touches a tangent of the bridge does not pass above it") {
    // Slope and r are such that the tangent at the guess is above the corner beyond the bridge.
    constexpr double r = 161.0 / 256, slope = -2575.0 / 4096;
    Departures<double> rays(DoublePair(r), nullptr);
    const double z = guess_slope(slope / r, rays.half_turn.lo, rays.quarter.lo);
    const auto [s, w] = sin_cos_on(DoublePair(z), rays.quarter);
    const double height = (DoublePair(r) * (s - DoublePair(z) * w)).hi;
    CHECK_FALSE(rays.passes_bridge({true, DoublePair(height), DoublePair(slope)}));
    CHECK(rays.passes_bridge({true, DoublePair(std::nextafter(height, 4)), DoublePair(slope)}));
}

TEST_CASE("step edges: rays of which one may go through a corner have no certain contact") {
    const auto from = [](double height) {
        return Departures<double>(DoublePair(0.5), nullptr)
            .off_bridge({true, DoublePair(height, 0.1), DoublePair(0.1)})
            .has_value();
    };
    CHECK_FALSE(from(0));
    CHECK(from(0.09));
}

TEST_CASE("step edges: r below 2^-43 is a resource limit") {
    CHECK_THROWS_AS(Departures<double>(DoublePair(0x1p-44), nullptr).all_at_most(5), std::length_error);
    CHECK_FALSE(Departures<double>(DoublePair(0x1p-43), nullptr).all_at_most(5));
}

TEST_CASE("step edges: rising states that may not turn have no certain direction") {
    FirstReflection<double> reflection(flight(-1, 1, 1, 2), nullptr);
    bool none = true;
    CHECK_FALSE(reflection.behind_first(true, DoublePair(1), none));
    CHECK(std::string(reflection.failed()) == "falling, or turning in one direction");
}

TEST_CASE("step edges: a rising start that turns backwards leaves steeply") {
    // The light mass, struck at phi = -5/8, is thrown up at slope 4.7.
    FirstReflection<double> reflection(flight(mpq_class(-5, 4), mpq_class(-5, 4), mpq_class(1, 4), 10),
                                       nullptr);
    bool none = false;
    CHECK_FALSE(reflection.behind_first(false, DoublePair(-0.625), none));
    CHECK(none);
}

TEST_CASE("step edges: the steps of a flight are counted as work") {
    // Two flights over the bridge, and two steps of the rays after it.
    Meter::begin();
    const std::uint64_t before = Meter::done();
    CHECK(leaf_rows::judged(leaf_rows::parsed("1 dumbbell full departure count 0 5 0 6 3/2 3/2 0 0 20 20")) ==
          "certified");
    CHECK(Meter::done() - before == 4 * 4096);
}

TEST_CASE("step edges: a ratio beyond the range of doubles is judged in MPFR") {
    const std::string q = std::string(mpz_class(mpz_class(1) << 900).get_str());
    for (const std::string lemmas : {"1", "minimal"}) {
        const auto of = [&](const std::string& bits) {
            return leaf_rows::judged(leaf_rows::parsed(lemmas + " dumbbell full departure outside " + bits +
                                                       " 0 0 2 0 0 3 3 " + q + " " + q));
        };
        CHECK(of("0") == "certified");
        CHECK(of("53") == "certified");
    }
}

TEST_CASE("step edges: where D may be 0 it is not decided whether a departure returns") {
    // After few bits D holds numbers of both signs: a state of the box may return, and hit once more.
    for (const std::string leaf :
         {"5 4 0 5 13/64 13/64 73/64 75/64 31/16 31/16", "6 5 0 6 193/512 321/512 1 1 1641/1024 1641/1024"})
        CHECK(said_of_leaf("1 dumbbell full departure count " + leaf) == "D > 0 or D <= 0 is decided");
    // From the corner with slope 1/8, at the ratio for which D is 0 or a little more.
    Big::precision = 53;
    Rays<Big> rays(nullptr);
    const Big slope = div(down, Big(1), 8), c = (Interval<Big>(slope) * rays.half_turn).lo;
    Big z = 0;
    REQUIRE(dumbbell_verify::guess_root(c, slope, z));
    const Interval<Big> w = rays.earliest({c, slope, div(down, Big(1), 2)}, z).cosine,
                        r = w * w - Interval<Big>(2) * slope * w;
    REQUIRE(r.lo < r.hi);
    const std::string q = mpq_class(1 / exact_value(r.lo)).get_str();
    CHECK(said_of_leaf("1 dumbbell full departure count 53 5 0 6 0 0 9/8 15/8 " + q + " " + q) ==
          "D > 0 or D <= 0 is decided");
}

TEST_CASE("step edges: what does not return from its last wall has no later collision") {
    for (const std::string leaf :
         {"4 1 0 2 3/4 97/128 7/8 7/8 3149/512 3149/512", "0 2 0 3 153/128 153/128 761/2048 769/2048 3 7/2"})
        CHECK(said_of_leaf("1 dumbbell full departure count " + leaf) == "certified");
    // Nor has what misses the wall, above the bridge, be there hints to spare.
    for (const std::string hints : {"0 0 1 ", "1 0 2 "})
        CHECK(said_of_leaf("1 dumbbell full departure count 0 " + hints + "3/2 3/2 75/1024 75/1024 48 48") ==
              "certified");
}

TEST_CASE("step edges: the highest flight is followed from above") {
    for (const std::string leaf : {
             "0 4 0 5 15/16 15/16 7/16 7/16 3393/128 3521/128",    // falls from the wall: kappa < 0
             "0 3 0 4 343/512 471/512 7/16 7/16 787/64 1575/128",  // likewise
             "5 5 0 6 99/128 99/128 17/32 17/32 103/4 103/4",      // just above the bridge, by rounding
             "53 2 0 3 0 2 0 0 11/2 23/4",                         // from the end of the chart
         })
        CHECK(said_of_leaf(std::string("1 dumbbell full departure count ") + leaf) ==
              "n + 1 + G <= a for the tangent ray");
    // It may just touch the wall's top, and then is nowhere.
    CHECK(said_of_leaf("1 dumbbell full departure count 53 2 0 3 1/2 2 0 0 2 513/256") == "certified");
}

TEST_CASE("step edges: slope 1 exactly is steep") {
    // r (eta - 1) = 1 at the end of the bridge, from height 0.
    CHECK(said_of_leaf("minimal dumbbell full contact count 0 0 0 1 3 4 3 3 2 2") == "certified");
    CHECK(said_of_leaf("minimal dumbbell full contact count 0 0 0 1 3 4 2 3 2 2") ==
          "n + 1 <= a at the wall");
}

TEST_CASE("step edges: steep slopes are cut to 1 before the numerator is asked for") {
    CHECK(said_of_leaf("minimal dumbbell full contact count 0 1 0 2 3 4 11/4 11 5 5") == "certified");
    CHECK(said_of_leaf("minimal dumbbell full departure count 0 1 0 2 0 5/4 25/16 29/16 27/16 27/16") ==
          "certified");
}

TEST_CASE("step edges: after the bridge both directions are counted, up to slope 1") {
    // Rays to the left have too many collisions, those to the right do not.
    CHECK(
        said_of_leaf("minimal dumbbell full departure count 0 1 0 2 1 1 43/256 9827/16384 257/256 257/256") ==
        "n + 1 <= a at the wall");
    CHECK(said_of_leaf("minimal dumbbell full departure count 0 2 0 3 1/4 17/16 0 1/8 3/2 5/2") ==
          "0 < numerator, where D may be 0");
    // From the corner, at E = 0 exactly.
    CHECK(said_of_leaf("minimal dumbbell full departure count 0 1 0 2 0 0 1 513/512 1 1") == "certified");
}

TEST_CASE("step edges: the first contact with the bridge is bounded from the left, by rounding too") {
    // The slope over r, rounded upwards, would put it too far to the right.
    CHECK(said_of_leaf("minimal dumbbell full departure count 5 1 0 2 1/4 1/4 25/32 25/32 243/64 37/8") ==
          "n + 1 <= a at the wall");
}

TEST_CASE("step edges: the heavy mass is proved to touch once by lower bounds") {
    const auto once = [](const std::string& leaf) {
        return said_of_leaf("1 dumbbell full again once " + leaf);
    };
    const std::string refused = "0 <= (2 + eta1) f + (z + r_lo) / 2";
    CHECK(once("3 0 0 1 2055/1024 2087/1024 3/4 3/4 3361/1024 3361/1024") == refused);  // f may be 0
    CHECK(once("3 0 0 1 4961/2048 4961/2048 7/16 7/16 21 21") == refused);  // r (cos t + eta) is rounded
    CHECK(once("8 0 0 1 1/2 1/2 25/8 25/8 195/8 195/8") == "certified");    // the quadratic is 0 at z
}

TEST_CASE("step edges: beyond pi nothing is known of the bridge") {
    const Leaf leaf = at_ratio(2);
    const OpenBridge bridge(leaf);
    for (const double t : {bridge.half_turn.hi, 3.25}) {
        const auto [sine, cosine] = bridge.trig(t);
        for (const DoublePair& x : {sine, cosine}) CHECK((x.lo == -1 && x.hi == 1));
    }
    CHECK(bridge.trig(bridge.half_turn.lo).cos.hi < -0.999);
}

TEST_CASE("enclosures of the same thing that exclude each other certify nothing, whatever they are of") {
    using I = DoublePair;
    CHECK(std::string(judged<Excluding>(Leaf(), nullptr)) ==
          "two enclosures of the same thing exclude each other");
    CHECK(meet(I(0, 2), I(1, 3)).lo == 1);
    CHECK(meet(I(0, 1), I(1, 3)).hi == 1);
    const OpenFlights flights(at_ratio(4));
    const RayBound<double> ray{0.5, 0.2, 0.25};
    using Last = Rays<double>::Contact;
    const double z = 0.65;  // near the contact, where sin is 0.63 and cos 0.78
    CHECK(flights.wall(ray, z, std::nullopt, I(0.2)).D.hi > 0);
    CHECK(flights.wall(ray, z, Last{0.7, 0.65, 0.75}, I(0.2)).x.hi == 0.7);
    CHECK_THROWS_AS(flights.wall(ray, z, Last{0.6, 0.65, 0.75}, I(0.2)), Excluded);
    CHECK_THROWS_AS(flights.wall(ray, z, Last{0.7, 0.55, 0.75}, I(0.2)), Excluded);
    CHECK_THROWS_AS(flights.wall(ray, z, Last{0.7, 0.65, 0.85}, I(0.2)), Excluded);
    CHECK_THROWS_AS(flights.wall(ray, z, std::nullopt, I(0.9)),
                    Excluded);  // no contact has a cosine below the slope
    // (2) of L4 at w = 0.8, kappa = 0.1, r = 1/4: D = 0.23, numerator 0.439.
    const auto behind = [&](const I& D, const I& top) {
        return flights.slope_behind(OpenFlights::Wall{I(0.6), I(0.6), I(0.8), D, top}, I(0.1));
    };
    CHECK(behind(I(0.22, 0.24), I(0.43, 0.44)).lo < 0.439 / 0.23);
    CHECK_THROWS_AS(behind(I(0.22, 0.24), I(0.33, 0.34)), Excluded);
    CHECK(behind(I(-1, 0.24), I(0.43, 0.44)).lo > 1.7);  // all steeper than 1: no contradiction
    // The least contact with the bridge of height 0.25 sin t is 0.41.
    CHECK(flights.rebound(I(0.1), I(0), 0.42).t.lo < 0.4116);
    CHECK_THROWS_AS(flights.rebound(I(0.1), I(0), 0.4), Excluded);
    CHECK(OpenStart(I(0.25), nullptr).contacts(I(0.5), I(0.2)).has_value());
    CHECK_THROWS_AS(OpenStart(I(0.25), nullptr).contacts(I(0.5, 0.4), I(0.2)), Excluded);
}
