// The section tangents of the scene body: true covers and witnesses are accepted, and nothing that is one
// less in any line, or beyond what the theorem speaks of.
#include "catch.hpp"
#include "rooms/verify/core/make_certificate.hpp"
#include "verify/program/verify.hpp"

using namespace dumbbell_verify;
using make::mutated;

namespace {

std::string said_of_tangents(const std::string& text) { return make::outcome(text, make::asking("body")); }

std::string tangents_text(const std::string& q, const std::string& rho, int upper, const std::string& tree,
                          int lower = 0, const std::string& witness = "") {
    return make::closed(
        "dumbbell-certificate 1\ngenerator test 1.0\nlemmas body\nscene body\nsection tangents\n"
        "claim collisions\nratio " +
        q + "\nrho " + rho + "\npieces 1\npiece " + q + "\nbits 53\nupper " + std::to_string(upper) +
        "\nchart tangent\n" + tree + "lower " + std::to_string(lower) + "\n" +
        (lower > 0 ? "witness " + witness + "\n" : ""));
}

/// Q = 9, rho = 1/2: 5, by f = b = 1.
const std::string half =
    tangents_text("9/1 9/1", "1/2 1/2", 5, "count 1 1\n", 5, "bridge 87555b-16 1b-22 1 3");
/// The corner's ray above the bridge does not exist, and the even motion has the most: 8.
const std::string even = tangents_text(
    "31097847/1000000 31097847/1000000", "88487/125000 88487/125000", 8,
    "split e\ncount 0 3\nsplit e\nsplit e\ncount 0 3\ncount 1 2\ncount 1 1\n", 8, "corner 0b0 0b0 7 0");
/// Q = 100, rho = 7/25: 9; beyond the top nothing is to be shown.
const std::string longer =
    tangents_text("100/1 100/1", "7/25 7/25", 9,
                  "split e\ncount 1 3\nsplit e\nsplit e\ncount 1 2\nsplit e\ncount 2 2\ncount 3 1\nsplit "
                  "e\nsplit e\nsplit e\ncount 3 1\ncount 4 0\noutside\noutside\n",
                  9, "bridge 401b-8 1b-14 4 4");

/// The leaf `count a b` at [e0, e1] of the body (rho, Q), for at most `most`.
bool holds(const mpq_class& rho, const mpq_class& q, const mpq_class& e0, const mpq_class& e1, int a, int b,
           int most, unsigned bits = 0) {
    Leaf leaf;
    leaf.multiple = bits > 0;
    leaf.bits = bits > 0 ? bits : 53;
    leaf.opcode = count_leaf;
    leaf.box = {{e0, 0, q}, {e1, 0, q}};
    leaf.box.lo[3] = leaf.box.hi[3] = rho;
    leaf.a = a;
    leaf.b = b;
    leaf.claimed = most;
    return tangents().check(leaf, nullptr) == nullptr;
}

}  // namespace

TEST_CASE("section tangents: true covers and witnesses are accepted") {
    for (const std::string& text : {half, even, longer}) CHECK(said_of_tangents(text) == "verified");
    CHECK(said_of_tangents(mutated(even, "ratio 31097847/1000000 ", "ratio 20/1 ")) != "verified");
    CHECK(said_of_tangents(
              tangents_text("5/2 5/1", "1/2 1/2", 3,
                            "split e\ncount 0 1\nsplit e\nsplit e\ncount 0 1\ncount 1 0\ncount 1 0\n", 3,
                            "corner 0b0 0b0 2 0")) == "verified");
    for (const auto& [q, n] : {std::pair(1, 2), {3, 3}, {4, 4}}) {  // rho = 1: f = 0
        const std::string ratio = std::to_string(q) + "/1 " + std::to_string(q) + "/1",
                          leaf = "count 0 " + std::to_string((n - 1) / 2) + "\n";
        CHECK(said_of_tangents(tangents_text(ratio, "1/1 1/1", n, leaf)) == "verified");
        CHECK(said_of_tangents(tangents_text(ratio, "1/1 1/1", n - 1, leaf)) == "count");
    }
}

TEST_CASE("section tangents: one less or more in any line is refused") {
    for (const auto& [text, upper] : {std::pair(&half, 5), {&even, 8}, {&longer, 9}}) {
        const std::string less = std::to_string(upper - 1), more = std::to_string(upper + 1);
        CHECK(said_of_tangents(mutated(*text, "upper " + std::to_string(upper), "upper " + less)) == "count");
        CHECK(said_of_tangents(mutated(*text, "lower " + std::to_string(upper), "lower " + more)) !=
              "verified");
        for (std::size_t at = text->find("\ncount "); at < text->find("\nlower");
             at = text->find("\ncount ", at + 1))
            for (const std::size_t hint : {at + 7, at + 9}) {
                std::string one_less = text->substr(0, text->find("total split"));
                if (one_less[hint]-- > '0') CHECK(said_of_tangents(make::closed(one_less)) == "count");
            }
    }
    CHECK(said_of_tangents(mutated(half, "section tangents", "section full")) != "verified");
}

TEST_CASE("N of bodies may leap over a number: a gap is from N to N + 2, and more is open") {
    const std::string text = tangents_text("4/1 9/1", "1/2 1/2", 5, "count 1 1\n", 3, "corner 0b0 0b0 2 0");
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

TEST_CASE("section tangents: an odd bound needs that the even motion is not reached") {
    // T = k1 = 1 at the edge, where N(10) = 4 by the even motion, and just above it, where there are 5.
    CHECK(holds(mpq_class(1, 10), 10, 0, 2, 1, 0, 4));
    CHECK_FALSE(holds(mpq_class(1, 10), 10, 0, 2, 1, 0, 3));
    CHECK_FALSE(holds(mpq_class(1, 10), mpq_class(1001, 100), 0, 2, 1, 0, 4));
    // At ties of the corner: J and n* are those of whole numbers.
    CHECK(holds(mpq_class(3, 10), 12, 0, 1, 1, 1, 5));
    CHECK(holds(mpq_class(2, 3), 9, 0, mpq_class(1, 16), 0, 1, 4));
    CHECK_FALSE(holds(mpq_class(2, 3), 9, 0, mpq_class(1, 16), 0, 1, 3));
    CHECK_FALSE(holds(mpq_class(2, 3), mpq_class(901, 100), 0, mpq_class(1, 16), 0, 1, 4));
}

TEST_CASE("section tangents: just above a step nothing false holds in any precision") {
    const mpq_class above = 1 + mpq_class(1, 1 << 30);
    const auto refused = [](const auto& holds_at, const mpq_class& q) {
        for (unsigned bits = 4; bits < 28; bits += 3) CHECK_FALSE(holds_at(q, bits));
    };
    // Of the step of a count in Q, which halving finds.
    const auto just_above = [&](const auto& holds_at, mpq_class lo, mpq_class hi) {
        if (!holds_at(lo, 120) || holds_at(hi, 120)) return 0;
        while (hi - lo > lo / (1 << 30)) {
            const mpq_class middle = (lo + hi) / 2;
            (holds_at(middle, 120) ? lo : hi) = middle;
        }
        refused(holds_at, hi);
        return 1;
    };
    int f = 0, b = 0, even = 0;
    for (int i = 0; i < 12; ++i) {
        const mpq_class s = mpq_class(5, 2) + mpq_class(i, 7), tie = (s + 1) / (s * (s - 1)), e(i + 3, 16),
                        later = 1 + mpq_class(i, 24);
        const auto corner = [](const mpq_class& rho, int j) {  // J <= j
            return [=](const mpq_class& q, unsigned bits) { return holds(rho, q, 0, 2, 9, j, 99, bits); };
        };
        refused(corner(tie, 1), s * s * above);  // pi/corner = 4 at s^2
        refused(corner(tie, 0), above / tie);
        for (int n = 0; n < 3; ++n) {
            const mpq_class rho(7, 25), edge(1, 100 + i);
            f += just_above([&](const mpq_class& q,
                                unsigned bits) { return holds(rho, q, 1, later, n + 1, 9, 99, bits); },
                            4, 400);
            b += just_above(
                [&](const mpq_class& q, unsigned bits) { return holds(rho, q, e, 2, 9, n, 99, bits); }, 4,
                400);
            even += just_above([&](const mpq_class& q,
                                   unsigned bits) { return holds(edge, q, 0, 1, n + 1, 0, 2 * n + 3, bits); },
                               2, 100);
        }
    }
    CAPTURE(f, b, even);
    CHECK((f > 5 && b > 5 && even > 5));
}
