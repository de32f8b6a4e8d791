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
    for (const char* count : {"count 0 1", "count 1 0", "count 1 2", "count 2 1", "count 2 0", "outside"})
        CHECK(said_of_tangents(mutated(half, "count 1 1", count)) != "verified");
    for (const char* elsewhere :
         {"meets", "meets-reversed", "equal-masses", "symmetric", "count 2", "split eta"})
        CHECK(said_of_tangents(mutated(half, "count 1 1", elsewhere)) != "verified");
    CHECK(said_of_tangents(mutated(longer, "count 4 0\noutside", "outside\noutside")) == "outside");
    CHECK(said_of_tangents(mutated(half, "rho 1/2 1/2", "rho 1/2 501/1000")) == "count");
    CHECK(said_of_tangents(mutated(half, "chart tangent", "chart contact")) == "syntax");
    CHECK(said_of_tangents(mutated(half, "section tangents", "section full")) != "verified");
    for (const char* witness :
         {"bridge 87555b-16 1b-22 2 3", "bridge 87555b-16 1b-22 1 4", "bridge 87556b-16 1b-22 1 3",
          "bridge 87555b-16 0b0 1 3", "corner 0b0 0b0 4 0", "wedge 0b0 0b0 1 3"})
        CHECK(said_of_tangents(mutated(half, "bridge 87555b-16 1b-22 1 3", witness)) != "verified");
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

TEST_CASE("section tangents: what holds in few bits is true") {
    const mpq_class rho(7, 25);
    int held = 0;
    for (int i = 1; i < 200; i += 10) {
        const mpq_class e(i, 128), q(i, 2);
        for (int n = 0; n < 5; ++n)
            for (const unsigned bits : {6U, 12U}) {
                const auto sound = [&](const auto&... leaf) {
                    const bool holds_so = holds(leaf..., bits);
                    held += holds_so ? 1 : 0;
                    return !holds_so || holds(leaf..., 200);
                };
                CHECK(sound(rho, 100, 1, e, n, 3, 99));                         // f
                CHECK(sound(rho, 100, e, 2, 9, n, 99));                         // b
                CHECK(sound(rho, q, 0, 2, 9, n, 99));                           // J
                CHECK(sound(mpq_class(1, 10), q / 9, 0, 2, 9, 0, 2 * n + 21));  // T
            }
    }
    CAPTURE(held);
    CHECK((held > 200 && held < 700));
}
