// The section perpendicular of the scene body: true covers and witnesses are accepted, and nothing that is
// one less or more in any line.
#include "catch.hpp"
#include "rooms/verify/core/make_certificate.hpp"
#include "verify/program/verify.hpp"

using namespace dumbbell_verify;
using make::mutated;

namespace {

std::string said_of(const std::string& text) { return make::outcome(text, make::asking("body")); }

std::string text_of(const std::string& q, const std::string& rho, int upper, const std::string& orbits,
                    int lower = 0, const std::string& witness = "") {
    return make::closed(
        "dumbbell-certificate 1\ngenerator test 1.0\nlemmas body\nscene body\nsection perpendicular\n"
        "claim collisions\nratio " +
        q + "\nrho " + rho + "\npieces 1\npiece " + q + "\nbits 53\nupper " + std::to_string(upper) +
        "\norbits " + orbits + "\nlower " + std::to_string(lower) + "\n" +
        (lower > 0 ? "witness " + witness + "\n" : ""));
}

/// Q = 9, rho = 1/2: 5.
const std::string half = text_of("9/1 9/1", "1/2 1/2", 5, "2", 5, "bridge 87555b-16 1b-22 1 3");
/// The corner's ray above the bridge does not exist, and the even motion has the most: 8.
const std::string even = text_of("31097847/1000000 31097847/1000000", "88487/125000 88487/125000", 8,
                                 "4 3 1b-3", 8, "corner 0b0 0b0 7 0");
/// Q = 100, rho = 7/25: 9.
const std::string longer =
    text_of("100/1 100/1", "7/25 7/25", 9, "4 1 1b-2 2 1b-3 3 5b-7", 9, "bridge 401b-8 1b-14 4 4");

}  // namespace

TEST_CASE("section perpendicular: true covers and witnesses are accepted") {
    for (const std::string& text : {half, even, longer}) CHECK(said_of(text) == "verified");
    CHECK(said_of(mutated(even, "ratio 31097847/1000000 ", "ratio 20/1 ")) != "verified");
    CHECK(said_of(text_of("5/2 5/1", "1/2 1/2", 3, "1 1 5b-5", 3, "corner 0b0 0b0 2 0")) == "orbits");
    CHECK(said_of(text_of("5/2 5/1", "1/2 1/2", 3, "2 1 5b-5", 3, "corner 0b0 0b0 2 0")) == "verified");
    CHECK(said_of(text_of("8/1 9/1", "1/2 9/16", 5, "2")) == "verified");
    for (const auto& [q, n] : {std::pair(1, 2), {3, 3}, {4, 4}}) {  // rho = 1: f = 0
        const std::string ratio = std::to_string(q) + "/1 " + std::to_string(q) + "/1",
                          end = std::to_string((n + 1) / 2);
        CHECK(said_of(text_of(ratio, "1/1 1/1", n, end)) == "verified");
        CHECK(said_of(text_of(ratio, "1/1 1/1", n - 1, end)) == "orbits");
    }
}

TEST_CASE("section perpendicular: one less or more in any line is refused") {
    for (const auto& [text, upper] : {std::pair(&half, 5), {&even, 8}, {&longer, 9}}) {
        const std::string less = std::to_string(upper - 1), more = std::to_string(upper + 1);
        CHECK(said_of(mutated(*text, "upper " + std::to_string(upper), "upper " + less)) == "orbits");
        CHECK(said_of(mutated(*text, "lower " + std::to_string(upper), "lower " + more)) != "verified");
    }
    for (const char* orbits : {"3 1 1b-2 2 1b-3 3 5b-7", "5 1 1b-2 2 1b-3 3 5b-7", "4 1 1b-2 2 1b-3",
                               "4 1 1b-1 2 1b-3 3 5b-7", "4 2 1b-3 1 1b-2 3 5b-7"})
        CHECK(said_of(mutated(longer, "orbits 4 1 1b-2 2 1b-3 3 5b-7", std::string("orbits ") + orbits)) ==
              "orbits");
    for (const char* orbits : {"orbits", "orbits 4 1", "orbits 2 2 1b-4 3"})
        CHECK(said_of(mutated(half, "orbits 2", orbits)) == "syntax");
    for (const char* line : {"chart contact", "count 2", "symmetric", "equal-masses"})
        CHECK(said_of(mutated(half, "orbits 2", line)) == "opcode");
    CHECK(said_of(mutated(half, "section perpendicular", "section full")) != "verified");
}

TEST_CASE("section perpendicular: a corner with more than 10,000 collisions is bounded by the wedge's ray") {
    for (const auto& [rho, upper, orbits] :
         {std::tuple("9/10 9/10", 14882, "7441 6624 1903b-14 7425 9b-12"), {"1/1 1/1", 15708, "7854"}}) {
        const auto of = [body = std::string(rho)](int most, const std::string& line) {
            return said_of(text_of("100000000/1 100000000/1", body, most, line));
        };
        const std::string end(orbits, 4), others(orbits + 4), less = std::to_string(std::stoi(end) - 1);
        CHECK(of(upper, orbits) == "verified");
        CHECK(of(upper - 1, orbits) == "orbits");
        CHECK(of(upper, less + others) == "orbits");
    }
}

TEST_CASE("N of bodies may leap over a number: a gap is from N to N + 2, and more is open") {
    const std::string text = text_of("4/1 9/1", "1/2 1/2", 5, "2", 3, "corner 0b0 0b0 2 0");
    for (const auto& [upper, gaps] : {std::pair("5", 1U), {"6", 0U}}) {
        const make::File file(mutated(text, "upper 5", std::string("upper ") + upper));
        const auto claim = dumbbell_verify::verify(file.path(), make::asking("body")).claim;
        CHECK((claim.gaps == gaps && claim.open == 1 - gaps));
    }
    dumbbell_verify::Request asked = make::asking("body");
    asked.demand.gap = mpq_class(5, 4);
    CHECK(make::outcome(text, asked) == "verified");
    CHECK(make::outcome(mutated(text, "upper 5", "upper 6"), asked) == "claim-not-proved");
    asked.demand.gap = 1;
    CHECK(make::outcome(text, asked) == "claim-not-proved");
}

TEST_CASE("section perpendicular: an odd bound needs that the even motion is not reached") {
    const auto of = [](const char* q, const char* rho, int most, const char* orbits) {
        return said_of(text_of(std::string(q) + " " + q, std::string(rho) + " " + rho, most, orbits));
    };
    // T = k1 = 1 at the edge, where N(10) = 4 by the even motion, and just above it, where there are 5.
    CHECK(of("10/1", "1/10", 4, "1") == "verified");
    CHECK(of("10/1", "1/10", 3, "1") == "orbits");
    CHECK(of("1001/100", "1/10", 4, "1") == "orbits");
    // At ties of the corner: J and n* are those of whole numbers.
    CHECK(of("12/1", "3/10", 5, "2") == "verified");
    CHECK(of("9/1", "2/3", 4, "2 1 27b-6") == "verified");
    CHECK(of("9/1", "2/3", 3, "2 1 27b-6") == "orbits");
    CHECK(of("901/100", "2/3", 4, "2 1 27b-6") == "orbits");
}
