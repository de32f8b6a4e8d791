// starts::Claim conditions at the edge of what their rules grant: a start on the floor, starts that do not
// rise, rays next to a tangency, last collisions that no count decides.
#include <cmath>

#include "catch.hpp"
#include "rooms/verify/core/leaf_rows.hpp"
#include "verify/functions/exact_value.hpp"
#include "verify/wings/starts/reflection.hpp"

using namespace dumbbell_verify;
using dumbbell_verify::starts::Departures;
using dumbbell_verify::starts::FirstReflection;
using dumbbell_verify::starts::Flight;

namespace {

using EdgePair = Interval<double>;

bool later(bool light, const EdgePair& height, const EdgePair& slope, std::uint64_t least,
           std::uint64_t most) {
    return Departures<double>(EdgePair(0.1), nullptr).certify({light, height, slope}, least, most);
}
std::string initial_row(const std::string& words) { return leaf_rows::judged(leaf_rows::parsed(words)); }

}  // namespace

TEST_CASE("initial edges: a mass that touches the floor is not above it") {
    const auto check = [](const mpq_class& q) {
        CAPTURE(q.get_str());
        starts::Box box;
        const auto above = [&](int phi, const mpq_class& y) {  // a right angle is in [phi, phi + 1]
            box.lo = {phi, 1, y, -1, q};
            box.hi = {phi + 1, 1, y, -1, q};
            return starts::starts_in_the_air(box, 53);
        };
        const mpq_class heavy(1 / (q + 1)), light(q / (q + 1)), more(1, 1'000'000'000);  // y where it touches
        CHECK_FALSE(above(1, heavy));
        CHECK(above(1, heavy + more));
        CHECK_FALSE(above(4, light));
        CHECK(above(4, light + more));
    };
    for (int q = 1; q < 60; ++q) check(q);
    check(mpq_class(32, 13));  // whose 1/(q + 1) is far below the next binary number
}

TEST_CASE("initial edges: each mass is above the floor at the ratio where it is lowest") {
    const auto above = [](int phi, const mpq_class& y) {  // q in [1, 10]
        starts::Box box;
        box.lo = {phi, 1, y, -1, 1};
        box.hi = {phi + 1, 1, y, -1, 10};
        return starts::starts_in_the_air(box, 53);
    };
    CHECK_FALSE(above(4, mpq_class(9, 10)));  // the light mass needs y > q/(1 + q)
    CHECK(above(4, mpq_class(10, 11) + mpq_class(1, 1000)));
    CHECK_FALSE(above(1, mpq_class(1, 2)));  // the heavy one y > 1/(1 + q)
    CHECK(above(1, mpq_class(1, 2) + mpq_class(1, 1000)));
}

TEST_CASE("initial edges: who leaves the floor steeply needs no height, but all states must") {
    const auto none = [](const std::string& phidot, const std::string& y, const std::string& ydot) {
        return initial_row("initial 0 0 0 anywhere 0 0 1 1 " + phidot + " " + y + " " + y + " " + ydot +
                           " 1 1") == "certified";
    };
    const std::string floor = "42073549240394825333/100000000000000000000";  // sin(1)/2 and next to nothing
    CHECK(none("1/4 1/4", floor, "1/4 1/4"));
    CHECK(none("-1/4 -1/4", floor, "1/4 1/4"));
    CHECK(none("-1/2 1/2", floor, "1/4 1/4"));
    CHECK_FALSE(none("1 1", floor, "1/4 1"));
    CHECK_FALSE(none("-1/8 1", floor, "1/4 1/4"));
    CHECK_FALSE(none("-1 1/8", floor, "1/4 1/4"));
}

TEST_CASE("initial edges: a dumbbell that may neither rise nor turn has no rule for no collision") {
    CHECK(initial_row("initial 0 0 0 anywhere 0 0 1 2 0 0 1/2 1/2 0 1 10 10") == "no collision at all");
    CHECK(initial_row("initial 0 0 0 anywhere 0 0 1 2 0 0 1/2 1/2 1/9 1 10 10") == "certified");
}

TEST_CASE("initial edges: who may just reach the peak of a wall is not above all walls") {
    // Height 1 at r = 1, turning on the spot: the lower mass comes down to 0.
    starts::Box box;
    box.lo = box.hi = {0, 1, mpq_class(1, 2), 0, 1};
    const Flight<double> touching(box);
    CHECK_FALSE(touching.is_closed(std::nullopt, 10));
    CHECK_FALSE(touching.never_collides());
    box.lo[2] = box.hi[2] = mpq_class(500'001, 1'000'000);
    const Flight<double> above(box);
    CHECK(above.is_closed(std::nullopt, 10));
    CHECK(above.never_collides());
}

TEST_CASE("initial edges: no angle belongs to times in which no mass comes down") {
    starts::Box box;
    box.lo = box.hi = {0, mpq_class(1, 100), 2, -1, 10};
    const Flight<double> falling(box);  // the heavy mass is down at about 2
    for (const bool heavy : {false, true}) {
        CHECK(falling.contact_angle(heavy, EdgePair(1.75, 2.25)));
        CHECK_FALSE(falling.contact_angle(heavy, EdgePair(1, 1.75)));
        CHECK_FALSE(falling.contact_angle(heavy, EdgePair(2.25, 3)));
    }
}

TEST_CASE("initial edges: a fall from rest begins with no speed, and is followed") {
    const std::string start = "initial 0 1 1 light 1/2 7/10 0 0 -1 -1 1/2 1/2 ";
    CHECK(initial_row(start + "0 0 10 10") == "certified");
    CHECK(initial_row(start + "-1/100 1/100 10 10") == "certified");  // some rise
}

TEST_CASE("initial edges: a mass ratio that doubles cannot hold is judged in MPFR") {
    const std::string huge = "1" + std::string(400, '0');
    for (const std::string bits : {"0", "53"})
        CHECK(initial_row("initial " + bits + " 0 0 anywhere 0 0 0 0 1 1 2 2 5 5 1 " + huge) == "certified");
}

TEST_CASE("initial edges: no trajectories are known to have at most one collision") {
    for (const double r : {0.3, 1.0}) {
        Departures<double> rays{EdgePair(r), nullptr};
        CHECK_FALSE(rays.trajectories_at_most(0));
        CHECK_FALSE(rays.trajectories_at_most(1));
        CHECK(rays.trajectories_at_most(2) == (r == 1));
        CHECK(rays.trajectories_at_most(9));
    }
}

TEST_CASE("initial edges: rising states of which some may not turn have no certain direction") {
    for (const int w : {-1, 0}) {
        starts::Box box;
        box.lo = {0, w, 1, 1, 2};
        box.hi = {0, w + 1, 1, 1, 2};
        FirstReflection<double> reflection(Flight<double>(box), nullptr);
        bool none = true;
        CHECK_FALSE(reflection.behind_first(true, EdgePair(1), none));
        CHECK(std::string(reflection.failed()) == "falling, or turning in one direction");
    }
}

TEST_CASE("initial edges: the bridge is not certainly met by a ray just above one of its tangents") {
    Departures<double> rays(EdgePair(1), nullptr);
    int looked_at = 0;
    for (int i = 1; i < 200; ++i) {
        const double slope = 0.005 * i;
        const long double top = std::acos(static_cast<long double>(slope)),
                          tangent = std::sin(top) - slope * top;
        double height = static_cast<double>(tangent);
        while (!(height > tangent + 4e-18L)) height = std::nextafter(height, 2);
        const double lower = height - 0x1p-10, flatter = slope - 0x1p-10;
        for (int more = 0; more < 4; ++more, height = std::nextafter(height, 2)) {
            CAPTURE(slope, more);
            CHECK_FALSE(rays.off_bridge({true, EdgePair(lower, height), EdgePair(slope)}));
            CHECK_FALSE(rays.off_bridge({true, EdgePair(height), EdgePair(flatter, slope)}));
        }
        looked_at += rays.off_bridge({true, EdgePair(lower), EdgePair(slope)}).has_value();
    }
    CHECK(looked_at > 100);
}

TEST_CASE("initial edges: no wall is certainly met where the highest rays pass over it") {
    for (const double lowest : {1e-300, 1e-9, 0.5})
        for (const double slope : {-0.01, 0.0, 0.1, 0.5}) {
            Departures<double> rays(EdgePair(0.1), nullptr);
            bool last = false;
            CAPTURE(lowest, slope);
            CHECK_FALSE(rays.off_light_wall({false, EdgePair(lowest, 2), EdgePair(slope)}, last));
            CHECK_FALSE(last);
            // Right behind rays that meet the bridge.
            const auto low = rays.off_bridge({true, EdgePair(0.05), EdgePair(slope / 10)});
            const auto all = rays.off_bridge({true, EdgePair(lowest, 2), EdgePair(slope / 10)});
            CHECK(low.has_value() == (slope < 0.5));
            CHECK_FALSE(all);
        }
}

TEST_CASE("initial edges: a last collision is one collision, also where no count is at hand") {
    // Dives with slope < -r, which no G bounds, onto the wall near its peak.
    const EdgePair height(1.44), slope(-0.3);
    for (int least = 0; least <= 4; ++least)
        for (int most = least; most <= 4; ++most) {
            CAPTURE(least, most);
            CHECK(later(false, height, slope, least, most) == (least <= 1 && 1 <= most));
        }
}

TEST_CASE("initial edges: a ray into the bridge has a collision, though none comes after that") {
    Departures<double> rays(EdgePair(0.9), nullptr);
    CHECK_FALSE(rays.certify({true, EdgePair(0.01), EdgePair(0.5)}, 0, 0));
    CHECK(rays.certify({true, EdgePair(0.01), EdgePair(0.5)}, 1, 1));
    // What is known of some rays says nothing of the next ones.
    CHECK(rays.certify({false, EdgePair(2), EdgePair(0)}, 0, 0));
    CHECK_FALSE(rays.certify({true, EdgePair(0.01), EdgePair(0.5)}, 0, 0));
}

TEST_CASE("initial edges: collisions that are certain stay so while the rays are followed") {
    // By G two of them are; one step later, as r is an interval, only one of those would be.
    Departures<double> rays(EdgePair(0.015625, 0.078125), nullptr);
    CHECK_FALSE(rays.certify({false, EdgePair(0.03125), EdgePair(0)}, 2, 2));
    CHECK(rays.has_enough());
    CHECK_FALSE(rays.certify({false, EdgePair(0.03125), EdgePair(0)}, 3, 3));
    CHECK_FALSE(rays.has_enough());
    Departures<double> others(EdgePair(0.01953125, 0.083984375), nullptr);
    CHECK_FALSE(others.certify({false, EdgePair(0.015625), EdgePair(0.01953125)}, 2, 2));
    CHECK(others.has_enough());
}

TEST_CASE("initial edges: who leaves steeply after the first contact has one collision, not more") {
    const std::string start = " light 1/2 7/10 -79/50 -39/25 1/100 1/100 3/2 3/2 -1 -1 10 10";
    CHECK(initial_row("initial 0 1 1" + start) == "certified");
    CHECK(initial_row("initial 0 2 9" + start) == "no later collision, as said");
    CHECK(initial_row("initial 0 2 2" + start) == "no later collision, as said");
}

TEST_CASE("initial edges: beyond 2^43 nothing is counted, not of a part of the box either") {
    const auto upto = [](const char* q) {
        return initial_row("initial 0 0 999999999 anywhere 0 0 0 0 1 1 2 2 -1 -1 4398046511104 " +
                           std::string(q));
    };
    CHECK(upto("8796093022208") == "certified");
    CHECK(upto("8796093022209") == "a mass ratio beyond 2^43");
    // By one part of 2^63; by an even number; and nothing is counted where one collision is claimed.
    const std::string anywhere = " anywhere 0 0 0 0 1 1 2 2 -1 -1 1 ";
    CHECK(initial_row("initial 100 0 999999999" + anywhere + "9223372036854775809/1048576") ==
          "a mass ratio beyond 2^43");
    CHECK(initial_row("initial 0 0 1000000000" + anywhere + "8796093022209") == "a mass ratio beyond 2^43");
    CHECK(initial_row("initial 0 0 1" + anywhere + "8796093022209") == "M <= most");
}

TEST_CASE("initial edges: rays from the bridge that cannot be followed have at most U collisions") {
    const EdgePair height(0.1, 2), slope(-0.5, 0.5);
    CHECK(later(false, height, slope, 0, 20));
    CHECK_FALSE(later(false, height, slope, 0, 1));
    CHECK_FALSE(later(false, height, slope, 1, 20));
    CHECK_FALSE(later(true, height, slope, 0, 20));
    CHECK(later(false, EdgePair(2), EdgePair(-0.1), 0, 0));  // k0 = -r, over everything
    // Steeply down to the light wall, whence some go on down: what U said before still holds.
    CHECK(later(false, EdgePair(0.3, 0.9), EdgePair(-1.2, -0.4), 1, 20));
}

TEST_CASE("initial edges: steep rays have no collision, not one either") {
    CHECK(later(true, EdgePair(0.5), EdgePair(1, 2), 0, 0));
    CHECK(later(true, EdgePair(0.5), EdgePair(1, 2), 0, 5));
    CHECK_FALSE(later(true, EdgePair(0.5), EdgePair(1, 2), 1, 5));
}

TEST_CASE("initial edges: dives below every slope -r of the box are not counted by G") {
    // At r = 0.047, the least, two more; at greater ones three.
    Departures<double> rays(EdgePair(0.046875, 0.2451171875), nullptr);
    CHECK_FALSE(rays.certify({false, EdgePair(0.75), EdgePair(-0.185546875)}, 0, 2));
}

TEST_CASE("initial edges: what is counted behind a step is counted without the step's collision") {
    CHECK(Departures<double>(EdgePair(0.3125), nullptr)
              .certify({false, EdgePair(0.25, 0.375), EdgePair(-0.59375)}, 2, 7));
    // At most two by U, at least two not before a step, behind which no count says at most one.
    CHECK(Departures<double>(EdgePair(0.125), nullptr)
              .certify({false, EdgePair(0.1640625), EdgePair(-0.30078125)}, 2, 2));
}

TEST_CASE("initial edges: rays that dive for hundreds of collisions are followed") {
    // Such steps are not those of which a verifier may give up after 64.
    CHECK(Departures<double>(EdgePair(0x1p-20, 0x3p-20), nullptr)
              .certify({true, EdgePair(0.3), EdgePair(-0.0005)}, 304, 664));
    CHECK(Departures<double>(EdgePair(0x1p-26, 0x5p-20), nullptr)
              .certify({true, EdgePair(0.0625), EdgePair(-0x5p-20)}, 0, 100'000));
}

TEST_CASE("initial edges: all collisions are bounded at the least ratio r of the box") {
    for (std::uint64_t most = 2; most < 60; ++most) {
        CAPTURE(most);
        const auto bounded = [&](double r_hi) {
            return Departures<double>(EdgePair(0.01, r_hi), nullptr).trajectories_at_most(most);
        };
        CHECK(bounded(0.5) == bounded(0.01));
        CHECK(bounded(0.5) == (most >= 10));
    }
}

TEST_CASE("initial edges: what passes the bridge is over all of it, at all ratios of the box") {
    const auto passes = [](const EdgePair& r, double height, const EdgePair& slope) {
        return Departures<double>(r, nullptr).passes_bridge({true, EdgePair(height), slope});
    };
    CHECK(passes(EdgePair(0.25), 1e-20, EdgePair(0.25)));  // steeper than it at its corner
    CHECK_FALSE(passes(EdgePair(0.125), 0.01, EdgePair(0, 0.5)));
    CHECK_FALSE(passes(EdgePair(0.125, 0.5), 0.01, EdgePair(0.25)));
    CHECK_FALSE(passes(EdgePair(0.25), 1.2, EdgePair(-0.5)));  // below the corner beyond it
    CHECK(passes(EdgePair(0.25), 1.6, EdgePair(-0.5)));
    for (int i = -19; i < 20; ++i) {
        const double steepness = 0.05 * i, top = std::acos(steepness),
                     tangent = 0.25 * (std::sin(top) - steepness * top);
        CAPTURE(steepness);
        CHECK(passes(EdgePair(0.25), tangent + 1e-12, EdgePair(0.25 * steepness)));
        CHECK_FALSE(passes(EdgePair(0.25), tangent - 1e-12, EdgePair(0.25 * steepness)));
    }
}

TEST_CASE("initial edges: rays of which one may go straight up have no certain direction") {
    // Turning on the spot; the least r - c^2 of the angles is 0, exactly.
    Big::precision = 8;
    for (const int w : {-1, 1}) {
        const auto bounds = [&](int from, int to) {
            return Interval<Big>(bound(down, mpq_class(from, 8), Big(0)),
                                 bound(up, mpq_class(to, 8), Big(0)));
        };
        const Interval<Big> at = w < 0 ? bounds(-12, -9) : bounds(-17, -13),
                            quarter = pi<Big>() / Interval<Big>(2);
        starts::Box box;
        box.lo = box.hi = {0, w, 1, 0, 1 / exact_value(square(sin_cos_on(at, quarter).cos).hi)};
        FirstReflection<Big> reflection(Flight<Big>(box), nullptr);
        bool none = false;
        CHECK_FALSE(reflection.behind_first(false, at, none));
        CHECK_FALSE(none);
        CHECK(std::string(reflection.failed()) == "a certain direction");
    }
}

TEST_CASE("initial edges: an angle of 2^28 half turns is out of reach") {
    starts::Box box;
    box.lo = box.hi = {0, 4, 2, mpq_class(-10, 11), 10};
    for (const double angle : {1e9, -1e9}) {
        FirstReflection<double> reflection(Flight<double>(box), nullptr);
        bool none = false;
        CHECK_FALSE(reflection.behind_first(true, EdgePair(angle), none));
        CHECK(std::string(reflection.failed()) == "an angle within reach");
    }
}

TEST_CASE("initial edges: a box of rays holds its lowest and its highest ray, to the last bit") {
    // Behind the top of the bridge, where Newton's iteration does not come to the last bit of each precision.
    const auto next = [](long precision, const mpq_class& lo, const mpq_class& hi) {
        Big::precision = precision;
        const auto number = [](const mpq_class& x) { return bound(down, x, Big(0)); };
        const Interval<Big> r(number(mpq_class(1, 16))), height(number(mpq_class(115, 1024)));
        return Departures<Big>(r, nullptr).off_bridge({true, height, {number(lo), number(hi)}});
    };
    const mpq_class steep(-3, 32), flat(-1, 32);
    for (long precision = 60; precision < 400; precision += 20) {
        CAPTURE(precision);
        const auto all = next(precision, steep, flat), lowest = next(500, steep, steep),
                   highest = next(500, flat, flat);
        REQUIRE((all && lowest && highest));
        CHECK(all->slope.hi >= lowest->slope.lo);
        CHECK(all->slope.lo <= highest->slope.hi);
        // And at that end, where a tangent bounds the contact, not much more.
        CHECK(to_double(up, sub(up, all->slope.hi, lowest->slope.lo)) < std::exp2(8 - precision));
    }
    // Also next to a tangency behind the top.
    const double tangent = std::sin(std::acos(-0.25)) + 0.25 * std::acos(-0.25);
    CHECK(Departures<double>(EdgePair(0.0625), nullptr)
              .off_bridge({true, EdgePair((tangent - 1e-6) / 16), EdgePair(-0.09375, -0.015625)}));
}

TEST_CASE("initial edges: the bridge sends back who comes steeply") {
    const auto next =
        Departures<double>(EdgePair(0.5), nullptr).off_bridge({true, EdgePair(0.01), EdgePair(-0.5)});
    REQUIRE(next);
    CHECK_FALSE(next->light);
    CHECK(next->slope.hi - next->slope.lo < 1e-12);
    CHECK(next->slope.lo > 2.49);
    CHECK(next->slope.hi < 2.51);
}

TEST_CASE("initial edges: in few bits the middle of a box may be worse than the box") {
    // For rounding: what all states do is certified, of their middle it is not, and no angle is claimed.
    CHECK(initial_row("initial 5 2 9 heavy 19/16 2 27/8 15/4 -21/16 -21/16 5/4 5/4 -17/32 -17/32 1 1") ==
          "an angle of the first contact");
}

TEST_CASE("initial edges: a claim is written to the letter") {
    starts::Claim claim;
    claim.box.lo = {-1, mpq_class(1, 2), 2, -3, 4};
    claim.box.hi = {1, 2, 3, mpq_class(-1, 3), 5};
    claim.least = 1;
    claim.most = 7;
    claim.decided = mpq_class(2, 3);
    CHECK(claim.text() ==
          "claim=initial-conditions phi=-1/1:1/1 phidot=1/2:2/1 y=2/1:3/1 ydot=-3/1:-1/3 ratio=4/1:5/1 "
          "collisions=1:7 decided=0.666666666666");
    CHECK(claim.json() ==
          R"({"kind":"initial-conditions","box":{"phi":{"lo":"-1/1","hi":"1/1"},)"
          R"("phidot":{"lo":"1/2","hi":"2/1"},"y":{"lo":"2/1","hi":"3/1"},"ydot":{"lo":"-3/1","hi":"-1/3"},)"
          R"("ratio":{"lo":"4/1","hi":"5/1"}},"least":1,"most":7,"decided":"2/3"})");
    claim.incoming = true;
    claim.most.reset();
    claim.decided = 1;
    CHECK(claim.text() == "claim=incoming ratio=4/1:5/1 collisions=1:none decided=1");
    CHECK(claim.json() == R"({"kind":"incoming","ratio":{"lo":"4/1","hi":"5/1"},)"
                          R"("least":1,"most":null,"decided":"1/1"})");
}

TEST_CASE("initial edges: a demand is proved, or what is missing is told") {
    starts::Claim claim;
    claim.box.lo[4] = 4;
    claim.box.hi[4] = 5;
    claim.asked = {1, 7, 0};
    const auto at = [&](const mpq_class& lo, const mpq_class& hi) {
        Collisions demand;
        demand.ratios.emplace(lo, hi);
        claim.asked_box = demanded_box(claim.box, {}, demand.ratios);
        return missing(claim, demand, {});
    };
    for (const int end : {3, 6, 7}) CHECK_FALSE(at(std::min(end, 4), std::max(end, 5)).empty());
    CHECK(at(1, 2) == "nothing is said of all ratio in 1/1:2/1, only of 4/1:5/1");
    CHECK(at(4, 5).empty());
    Collisions most, least;
    most.most = 7;
    least.least = 1;
    CHECK(missing(claim, most, {}).empty());
    CHECK(missing(claim, least, {}).empty());
    most.most = 6;
    least.least = 2;
    CHECK(missing(claim, most, {}) == "not proved: at most 6 collisions from the box");
    CHECK(missing(claim, least, {}) == "not proved: at least 2 collisions from the box");
    claim.asked.most.reset();
    most.most = 1000;
    CHECK(missing(claim, most, {}) == "not proved: at most 1000 collisions from the box");
}

TEST_CASE("initial edges: shares are written to the letter") {
    starts::Claim claim;
    claim.shares.emplace();
    claim.shares->add(1, 1, mpq_class(1, 2));
    claim.shares->add(2, 4, mpq_class(1, 4));
    claim.shares->open = mpq_class(1, 4);
    CHECK(claim.json().ends_with(R"(,"shares":[{"least":0,"most":0,"lo":"0/1","hi":"1/4"},)"
                                 R"({"least":1,"most":1,"lo":"1/2","hi":"3/4"},)"
                                 R"({"least":2,"most":4,"lo":"0/1","hi":"1/2"},)"
                                 R"({"least":5,"most":null,"lo":"0/1","hi":"1/4"}]})"));
    CHECK(claim.paragraph() ==
          "  No bound is proved that holds for every start in the box.\n"
          "  collisions  share of the box with exactly that many: proved bounds\n"
          "           0  0.000000000000 to 0.250000000000\n"
          "           1  0.500000000000 to 0.750000000000\n"
          "         2-4  0.000000000000 to 0.500000000000\n"
          "          5-  0.000000000000 to 0.250000000000\n");
    // Numbers that fill their column, and a share that no decimals end.
    claim.incoming = true;
    claim.box.lo.back() = claim.box.hi.back() = 10;
    claim.shares.emplace();
    claim.shares->add(10'000, 99'999, mpq_class(1, 3));
    claim.shares->add(100'000, 100'000, mpq_class(1, 3));
    claim.shares->add(100'001, 999'999, mpq_class(1, 3));
    CHECK(claim.paragraph() ==
          "  No bound is proved that holds for every trajectory that comes in.\n"
          "  The mean number of collisions is 70000.333333 to 399999.333334 by the leaves, and 1.670648 to "
          "1.670649 by Theorem 6.\n"
          "  The heavy mass hits the floor with probability 0.512274 to 0.512275.\n"
          "  collisions  share of the trajectories with exactly that many: proved bounds\n"
          "      0-9999  0.000000000000 to 0.000000000000\n"
          " 10000-99999  0.000000000000 to 0.333333333334\n"
          "      100000  0.333333333333 to 0.333333333334\n"
          "100001-999999  0.000000000000 to 0.333333333334\n");
}
