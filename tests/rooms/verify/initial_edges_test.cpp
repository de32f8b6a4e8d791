// Initial conditions at the edge of what their rules grant: a start on the floor, starts that do not rise,
// rays next to a tangency, last collisions that no count decides.
#include <catch2/catch.hpp>
#include <cmath>

#include "leaf_rows.hpp"
#include "verify/starts/reflection.hpp"

using namespace dumbbell_verify;

namespace {

using EdgePair = Interval<double>;

bool later(bool light, const EdgePair& height, const EdgePair& slope, std::uint64_t least,
           std::uint64_t most) {
    return Departures<double>(EdgePair(0.1), nullptr).certify({light, height, slope}, least, most);
}
std::string initial_row(const std::string& words) { return leaf_rows::judged(leaf_rows::parsed(words)); }

}  // namespace

TEST_CASE("initial edges: a mass that touches the floor is not above it") {
    for (int q = 1; q < 60; ++q) {
        CAPTURE(q);
        InitialBox box;
        const auto above = [&](int phi, const mpq_class& y) {  // a right angle is in [phi, phi + 1]
            box.lo = {phi, 1, y, -1, q};
            box.hi = {phi + 1, 1, y, -1, q};
            return starts_in_the_air(box, 53);
        };
        const mpq_class heavy(1, q + 1), light(q, q + 1), more(1, 1'000'000'000);  // y where it touches
        CHECK_FALSE(above(1, heavy));
        CHECK(above(1, heavy + more));
        CHECK_FALSE(above(4, light));
        CHECK(above(4, light + more));
    }
}

TEST_CASE("initial edges: a dumbbell that may neither rise nor turn has no rule for no collision") {
    CHECK(initial_row("initial 0 0 0 anywhere 0 0 1 2 0 0 1/2 1/2 0 1 10 10") == "no collision at all");
    CHECK(initial_row("initial 0 0 0 anywhere 0 0 1 2 0 0 1/2 1/2 1/9 1 10 10") == "certified");
}

TEST_CASE("initial edges: who may just reach the peak of a wall is not above all walls") {
    // Height 1 at r = 1, turning on the spot: the lower mass comes down to 0.
    InitialBox box;
    box.lo = box.hi = {0, 1, mpq_class(1, 2), 0, 1};
    const Flight<double> touching(box);
    CHECK_FALSE(touching.is_closed(std::nullopt, 10));
    CHECK_FALSE(touching.never_collides());
    box.lo[2] = box.hi[2] = mpq_class(500'001, 1'000'000);
    const Flight<double> above(box);
    CHECK(above.is_closed(std::nullopt, 10));
    CHECK(above.never_collides());
}

TEST_CASE("initial edges: rising states of which some may not turn have no certain direction") {
    for (const int w : {-1, 0}) {
        InitialBox box;
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

TEST_CASE("initial edges: in few bits the middle of a box may be worse than the box") {
    // For rounding: what all states do is certified, of their middle it is not, and no angle is claimed.
    CHECK(initial_row("initial 5 2 9 heavy 19/16 2 27/8 15/4 -21/16 -21/16 5/4 5/4 -17/32 -17/32 1 1") ==
          "an angle of the first contact");
}

TEST_CASE("initial edges: a claim is written to the letter") {
    Initial claim;
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
    Initial claim;
    claim.box.lo[4] = 4;
    claim.box.hi[4] = 5;
    claim.least = 1;
    claim.most = 7;
    const auto at = [&](const mpq_class& lo, const mpq_class& hi) {
        Collisions demand;
        demand.ratios.emplace(lo, hi);
        return claim.missing(demand);
    };
    CHECK(at(4, 5).empty());
    CHECK(at(3, 5) == "of the mass ratios 3/1:5/1 the file covers only 4/1:5/1");
    CHECK(at(4, 6) == "of the mass ratios 4/1:6/1 the file covers only 4/1:5/1");
    CHECK(at(6, 7) == "the file says nothing of the mass ratios 6/1:7/1, it is about 4/1:5/1");
    CHECK(at(3, 4) == "of the mass ratios 3/1:4/1 the file covers only 4/1:4/1");
    CHECK(at(5, 6) == "of the mass ratios 5/1:6/1 the file covers only 5/1:5/1");
    CHECK(at(1, 2) == "the file says nothing of the mass ratios 1/1:2/1, it is about 4/1:5/1");
    Collisions most, least;
    most.most = 7;
    least.least = 1;
    CHECK(claim.missing(most).empty());
    CHECK(claim.missing(least).empty());
    most.most = 6;
    least.least = 2;
    CHECK(claim.missing(most) == "not proved: at most 6 collisions from the box");
    CHECK(claim.missing(least) == "not proved: at least 2 collisions from the box");
    claim.most.reset();
    most.most = 1000;
    CHECK(claim.missing(most) == "not proved: at most 1000 collisions from the box");
}

TEST_CASE("initial edges: shares are written to the letter") {
    Initial claim;
    claim.shares.emplace();
    claim.shares->add(1, 1, mpq_class(1, 2));
    claim.shares->add(2, 4, mpq_class(1, 4));
    claim.shares->open = mpq_class(1, 4);
    CHECK(claim.json().ends_with(R"(,"shares":[{"least":0,"most":0,"lo":"0/1","hi":"1/4"},)"
                                 R"({"least":1,"most":1,"lo":"1/2","hi":"3/4"},)"
                                 R"({"least":2,"most":4,"lo":"0/1","hi":"1/2"},)"
                                 R"({"least":5,"most":null,"lo":"0/1","hi":"1/4"}]})"));
    CHECK(claim.paragraph() ==
          "  collisions  share of the box with exactly that many: proved bounds\n"
          "           0  0.000000000000 to 0.250000000000\n"
          "           1  0.500000000000 to 0.750000000000\n"
          "         2-4  0.000000000000 to 0.500000000000\n"
          "          5-  0.000000000000 to 0.250000000000\n");
    // Numbers that fill their column, and a share that no decimals end.
    claim.incoming = true;
    claim.shares.emplace();
    claim.shares->add(10'000, 99'999, mpq_class(1, 3));
    claim.shares->add(100'000, 100'000, mpq_class(1, 3));
    claim.shares->add(100'001, 999'999, mpq_class(1, 3));
    CHECK(claim.paragraph() ==
          "  collisions  share of the trajectories with exactly that many: proved bounds\n"
          "      0-9999  0.000000000000 to 0.000000000000\n"
          " 10000-99999  0.000000000000 to 0.333333333334\n"
          "      100000  0.333333333333 to 0.333333333334\n"
          "100001-999999  0.000000000000 to 0.333333333334\n");
}
