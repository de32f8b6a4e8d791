// How likely each number of collisions is: what the leaves prove, against the simulation of random starts
// (tests/attacks/oracle), and against what dumbbell-verify finds in the written file.
#include "starts/answer/shares.hpp"

#include "attacks/oracle/trial.hpp"
#include "catch.hpp"
#include "rooms/wings/starts/box.hpp"
#include "rooms/wings/starts/histogram.hpp"
#include "rooms/wings/starts/sample.hpp"
#include "rooms/wings/starts/written_file.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;
using namespace dumbbell_test;
using dumbbell_trace_test::checked;
using dumbbell_trace_test::Histogram;
using dumbbell_trace_test::uniform;
using dumbbell_trace_test::written;

namespace {

/// phi in [0, 3], phidot in [-1/2, 3], y = 3/2, ydot = -1.
Box falling(const Rational& q) {
    return {{Rational(0), Rational(-1, 2), Rational(3, 2), Rational(-1), q},
            {Rational(3), Rational(3), Rational(3, 2), Rational(-1), q}};
}

Histogram simulated(const Box& box) {
    std::mt19937_64 engine(2026);
    const dumbbell_oracle::Dumbbell<dumbbell_oracle::Real> body(box.lo[4].convert_to<double>());
    Histogram found;
    for (int i = 0; i < scaled(4'000); ++i) {
        const auto side = [&](std::size_t axis) -> dumbbell_oracle::Real {
            return uniform(engine, box.lo[axis].convert_to<double>(), box.hi[axis].convert_to<double>());
        };
        const auto phi = side(0), phidot = side(1), y = side(2), ydot = side(3);
        found.add(simulate(body, dumbbell_oracle::State<dumbbell_oracle::Real>{phi, phidot, y, ydot}));
    }
    return found;
}

}  // namespace

TEST_CASE("shares are the volumes of the leaves that prove a number, and of those that do not exclude it") {
    const auto bounds = share_bounds(sample_initial().tree);  // 1/2 has 2, 1/4 has 1, 1/4 has 1 or 2
    REQUIRE(bounds.size() == 3);
    CHECK(share_lines(bounds) ==
          "           0  0.000000000000 to 0.000000000000\n"
          "           1  0.250000000000 to 0.500000000000\n"
          "           2  0.500000000000 to 0.750000000000\n");
}

TEST_CASE("numbers of the same share stand together, and an open leaf excludes none") {
    const auto bounds = share_bounds(
        {initial_split(Axis::phi), between(2, 5), initial_split(Axis::phi), open_leaf(), exactly(9)});
    CHECK(share_lines(bounds) ==
          "         0-1  0.000000000000 to 0.250000000000\n"
          "         2-5  0.000000000000 to 0.750000000000\n"
          "         6-8  0.000000000000 to 0.250000000000\n"
          "           9  0.250000000000 to 0.500000000000\n"
          "         10-  0.000000000000 to 0.250000000000\n");
    CHECK(share_json(bounds).text().ends_with(R"({"least":10,"most":null,"lo":"0/1","hi":"1/4"}])"));
}

TEST_CASE("decimals of a share are rounded outward, and a whole share is 1") {
    std::vector<Node> tree;
    for (int i = 0; i < 50; ++i) {
        tree.push_back(initial_split(Axis::phi));
        tree.push_back(exactly(1));
    }
    tree.push_back(exactly(0));
    CHECK(share_lines(share_bounds(tree)) ==
          "           0  0.000000000000 to 0.000000000001\n"
          "           1  0.999999999999 to 1.000000000000\n");
    CHECK(share_lines(share_bounds({exactly(1)})) ==
          "           0  0.000000000000 to 0.000000000000\n"
          "           1  1.000000000000 to 1.000000000000\n");
}

TEST_CASE("dumbbell-verify finds the same shares in the file, letter by letter") {
    for (const char* q : {"1", "4.61", "100"}) {
        const Box box = falling(parse_rational(q));
        const Subdivision parts = subdivide(box, {.max_boxes = 600, .jobs = 2});
        const auto proof = checked(written(box, parts));
        const std::string lines = share_lines(share_bounds(parts.tree));
        CHECK(proof.paragraph().ends_with("\n" + lines));
        CHECK(proof.json().find(share_json(share_bounds(parts.tree)).text()) != std::string::npos);
    }
    const auto hand_made = sample_initial();
    Certificate all_open = hand_made;
    all_open.tree = {open_leaf()};
    CHECK(checked(render(all_open).text).paragraph().ends_with(share_lines(share_bounds(all_open.tree))));
}

TEST_CASE("random starts have each number of collisions as often as is proved, within their own error") {
    const auto boxes = static_cast<std::size_t>(std::min(scaled(800), 6000L));
    for (const char* q : {"1", "4.61", "10", "100"}) {
        INFO("q " << q);
        const Box box = falling(parse_rational(q));
        simulated(box).check(share_bounds(subdivide(box, {.max_boxes = boxes, .jobs = 2}).tree));
    }
}
