// What `subdivide` finds and writes is what dumbbell-verify certifies.
#include "catch.hpp"
#include "rooms/wings/starts/written_file.hpp"
#include "starts/air/box_state.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;
using dumbbell_trace_test::refusal;
using dumbbell_trace_test::written;

namespace {

/// LO:HI of phi, phidot, y, ydot and q, as fractions.
Box box_of(const std::array<std::array<const char*, 2>, axis_count>& sides) {
    Box box;
    for (std::size_t i = 0; i < axis_count; ++i) {
        box.lo[i] = parse_signed_rational(sides[i][0]);
        box.hi[i] = parse_signed_rational(sides[i][1]);
    }
    return box;
}

void check_verified(const Box& box, const SubdivideOptions& options) {
    REQUIRE_NOTHROW(require_in_play(box));
    const Subdivision parts = subdivide(box, options);
    dumbbell_verify::Verified proof;
    REQUIRE(refusal(written(box, parts), &proof) == "");
    const auto& claim = dynamic_cast<const dumbbell_verify::starts::Claim&>(*proof.other);
    CHECK(claim.least == static_cast<std::uint64_t>(parts.most ? parts.least : 0));
    CHECK(claim.most.has_value() == parts.most.has_value());
    if (parts.most) {
        CHECK(*claim.most == static_cast<std::uint64_t>(*parts.most));
    }
    CHECK(dumbbell_verify::to_string(claim.decided) == to_fraction(Rational(1) - parts.undecided.share));
}

}  // namespace

TEST_CASE("Subdivisions of falling boxes are verified") {
    for (const char* q : {"1", "1.5", "3", "10", "100", "10000", "1e6"}) {
        INFO("q = " << q);
        check_verified(box_of({{{"0", "3"}, {"-1/2", "1/2"}, {"3/2", "3/2"}, {"-1", "-1"}, {q, q}}}),
                       {.max_boxes = 400, .jobs = 2});
        check_verified(
            box_of({{{"4", "5"}, {"-1/100", "1/100"}, {"3", "3"}, {"-1/1000", "-1/1000"}, {q, q}}}),
            {.max_boxes = 200, .jobs = 2});
    }
}

TEST_CASE("Subdivisions of boxes of ratios, and of all five quantities, are verified") {
    check_verified(box_of({{{"0.3", "0.5"}, {"-1/20", "1/20"}, {"3/2", "3/2"}, {"-1", "-1"}, {"2", "20"}}}),
                   {.max_boxes = 500, .jobs = 2});
    check_verified(box_of({{{"0.3", "0.5"}, {"1", "1"}, {"3/2", "3/2"}, {"-1", "-1"}, {"1", "1.5"}}}),
                   {.max_boxes = 500, .jobs = 2});
    check_verified(box_of({{{"-3", "3"}, {"-2", "2"}, {"1", "3"}, {"-2", "-1"}, {"10", "100"}}}),
                   {.max_boxes = 500, .jobs = 2});
}

TEST_CASE("Subdivisions of starts that rise, or nearly rest, are verified") {
    for (const char* phidot : {"1", "-1", "3/2"}) {
        check_verified(box_of({{{"0", "1"}, {phidot, phidot}, {"4/5", "9/10"}, {"0", "1/10"}, {"10", "10"}}}),
                       {.max_boxes = 400, .jobs = 2});
        check_verified(
            box_of({{{"0", "1"}, {phidot, phidot}, {"4/5", "9/10"}, {"-1/10", "1/10"}, {"10", "10"}}}),
            {.max_boxes = 400, .jobs = 2});
    }
    check_verified(box_of({{{"0", "1"}, {"-1", "1"}, {"1", "1"}, {"1/10", "2"}, {"10", "10"}}}),
                   {.max_boxes = 400, .jobs = 2});
}

TEST_CASE("A single leaf and an interrupted subdivision are verified") {
    const auto leaving = box_of({{{"1/2", "6/10"}, {"9/10", "1"}, {"2", "3"}, {"1", "2"}, {"10", "11"}}});
    check_verified(leaving, {});
    const auto falling = box_of({{{"0", "3"}, {"-1/2", "1/2"}, {"3/2", "3/2"}, {"-1", "-1"}, {"10", "10"}}});
    check_verified(falling, {.jobs = 2, .interrupted = [] { return true; }});
    // Too many collisions to count: a leaf `open`.
    check_verified(box_of({{{"4", "5"}, {"-1/2", "1/2"}, {"3", "3"}, {"-1", "-1"}, {"1e14", "1e14"}}}),
                   {.max_boxes = 2, .jobs = 2});
}

TEST_CASE("More bits decide what double cannot, and are verified") {
    const auto near_corner =
        box_of({{{"1e-30", "2e-30"}, {"0", "0"}, {"3", "3"}, {"-1", "-1"}, {"10", "10"}}});
    CHECK(subdivide(near_corner, {.max_boxes = 1}).undecided.share == 1);
    for (const int bits : {300, 900, 4096}) {
        const SubdivideOptions options{.max_boxes = 1, .bits = bits};
        CHECK(subdivide(near_corner, options).undecided.share == 0);
        check_verified(near_corner, options);
    }
    // Across the corner itself all but two tiny boxes.
    const auto across = box_of({{{"-1e-30", "2e-30"}, {"0", "0"}, {"3", "3"}, {"-1", "-1"}, {"10", "10"}}});
    check_verified(across, {.max_boxes = 60, .bits = 1000});
}
