// The section's checks: true covers and witnesses are accepted, false ones are not.
#include <map>

#include "catch.hpp"
#include "make_certificate.hpp"
#include "scale.hpp"
#include "verify/core/section.hpp"
#include "verify/program/verify.hpp"

using namespace dumbbell_verify;
using make::closed;
using make::File;
using make::mutated;

namespace {

std::string outcome_at_bits(const std::string& text, unsigned precision = 0) {
    const Failure why = make::failure(text, make::asking("", precision));
    return why.code + (why.code == "verified" ? "" : ": " + why.text);
}

bool rejected(const std::string& text, const std::string& code) {
    return outcome_at_bits(text).starts_with(code + ": ");
}

/// A witness of `lower` collisions on [a, b], found by trying a grid.
std::string find_witness(const mpq_class& a, const mpq_class& b, std::uint64_t lower) {
    Leaf leaf;
    leaf.claimed = lower;
    leaf.opcode = witness;
    for (int i = 1; i < 100; i += 2)
        for (int j = 1; j < 64; j += 2)
            for (leaf.a = 0; leaf.a < lower; ++leaf.a) {
                leaf.b = lower - 1 - leaf.a;
                leaf.box = {{mpq_class(i, 64), mpq_class(j, 64), a}, {mpq_class(i, 64), mpq_class(j, 64), b}};
                if (turning().check(leaf, nullptr) == nullptr)
                    return "bridge " + std::to_string(i) + "b-6 " + std::to_string(j) + "b-6 " +
                           leaf.a.get_str() + " " + leaf.b.get_str();
            }
    return "";
}

std::string single(const mpq_class& q, std::uint64_t upper, std::uint64_t lower, const std::string& witness,
                   unsigned bits = 53) {
    return closed(make::header(make::fraction(q), make::fraction(q), 1) +
                  make::piece(q, q, upper, lower, witness, bits));
}

}  // namespace

TEST_CASE("q = 1: equal masses") {
    const std::string piece = "piece 1/1 1/1\nbits 53\nupper 2\nequal-masses\nlower 0\n";
    const std::string text = closed(make::header("1/1", "1/1", 1) + piece);
    CHECK(outcome_at_bits(text) == "verified");
    CHECK(rejected(mutated(text, "upper 2", "upper 1"), "equal-masses"));
    CHECK(rejected(mutated(mutated(text, "piece 1/1 1/1", "piece 1/1 2/1"), "ratio 1/1 1/1", "ratio 1/1 2/1"),
                   "equal-masses"));
    CHECK(rejected(mutated(mutated(text, "piece 1/1 1/1", "piece 2/1 2/1"), "ratio 1/1 1/1", "ratio 2/1 2/1"),
                   "equal-masses"));
    const std::string witness = find_witness(1, 1, 2);
    REQUIRE_FALSE(witness.empty());
    CHECK(outcome_at_bits(mutated(text, "lower 0\n", "lower 2\nwitness " + witness + "\n")) == "verified");
    CHECK(find_witness(1, 1, 3).empty());
}

TEST_CASE("q = 10: one leaf in each chart, and a witness of 4") {
    const std::string witness = find_witness(10, 10, 4);
    REQUIRE_FALSE(witness.empty());
    const std::string text = single(10, 4, 4, witness);
    CHECK(text.find("total split 0\ntotal count 2\n") != std::string::npos);
    CHECK(outcome_at_bits(text) == "verified");
    CHECK(outcome_at_bits(text, 53) == "verified");  // the other back-end
    CHECK(outcome_at_bits(text, 113) == "verified");
    CHECK(outcome_at_bits(mutated(text, "bits 53", "bits 77")) == "verified");
}

TEST_CASE("what double precision certifies costs no more with more bits, up to 2 * 10^13 collisions") {
    const std::string text = single(10, 4, 0, "");
    const auto work = [&](const std::string& bits, const std::string& upper) {
        const File file(mutated(mutated(text, "bits 53", "bits " + bits), "upper 4", "upper " + upper));
        return verify(file.path(), {}).work;
    };
    CHECK(work("77", "4") == work("53", "4"));
    CHECK(work("77", "20000000000000") == work("53", "20000000000000"));
    CHECK(work("77", "20000000000001") > work("53", "20000000000001"));
    CHECK(work("54", "20000000000001") > work("53", "20000000000001"));
    CHECK(work("53", "20000000000001") == work("53", "20000000000000"));
}

TEST_CASE("q = 11.3: a tree") {
    const mpq_class q(113, 10);
    const std::string text = single(q, 4, 0, "");
    CHECK(outcome_at_bits(text) == "verified");
    CHECK(outcome_at_bits(text, 90) == "verified");
    CHECK(text.find("total split 0\n") == std::string::npos);
}

TEST_CASE("N - 1 has no cover, and its claim is refused with every pair of hints") {
    CHECK_THROWS_AS(make::cover(turning(), 10, 10, 3), std::runtime_error);
    CHECK_THROWS_AS(make::cover(turning(), 100, 100, 9), std::runtime_error);
    const std::string text = single(10, 4, 0, "");
    for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) {
            const std::string hints = "count " + std::to_string(a) + " " + std::to_string(b);
            std::string body = mutated(mutated(text, "upper 4", "upper 3"), "chart bridge\ncount 1 2",
                                       "chart bridge\n" + hints);
            CHECK(rejected(mutated(body, "chart light\ncount 1 2", "chart light\n" + hints), "count"));
        }
    CHECK(rejected(mutated(text, "count 1 2", "count 0 3"), "count"));
    CHECK(rejected(mutated(text, "count 1 2", "count 2 2"), "count"));  // more than U
    CHECK(rejected(mutated(text, "count 1 2", "count 0 999999999999999999"), "count"));
    CHECK(rejected(mutated(text, "count 1 2", "outside"), "outside"));
}

TEST_CASE("each reason of the chart light holds where it should and not beyond") {
    Leaf leaf;
    leaf.chart = 1;
    leaf.claimed = 1;
    const auto holds = [&](std::size_t opcode, const mpq_class& e0, const mpq_class& e1, const mpq_class& y0,
                           const mpq_class& y1) {
        leaf.opcode = opcode;
        leaf.box = {{e0, y0, 10}, {e1, y1, 10}};
        return turning().check(leaf, nullptr) == nullptr;
    };
    CHECK(holds(outside, mpq_class(8, 5), 2, 0, 16));  // e > pi/2
    CHECK_FALSE(holds(outside, mpq_class(3, 2), 2, 0, 16));
    CHECK(holds(outside, 0, 2, 10, 16));  // r lambda >= 1, exactly
    CHECK_FALSE(holds(outside, 0, 2, mpq_class(9999999, 1000000), 16));
    CHECK(holds(outside, 0, mpq_class(1, 2), 5, 16));  // sigma X descends
    CHECK_FALSE(holds(outside, 0, mpq_class(1, 2), 2, 16));
    CHECK_FALSE(holds(outside, 0, 1, 5, 16));                        // at e = 0 it does, at e = 1 it does not
    CHECK(holds(meets, 0, mpq_class(1, 100), 0, mpq_class(1, 10)));  // X meets the bridge
    CHECK_FALSE(holds(meets, 0, mpq_class(1, 5), 0, mpq_class(1, 10)));
    CHECK_FALSE(holds(meets, 0, mpq_class(1, 100), 0, 1));
    CHECK(holds(meets_reversed, 0, mpq_class(1, 100), 2, 16));  // sigma X meets it: mu < 0 or small
    CHECK_FALSE(holds(meets_reversed, 0, mpq_class(1, 100), 0, 16));
    CHECK_FALSE(holds(meets_reversed, 0, mpq_class(3, 2), 2, 16));
}

TEST_CASE("a light chart may be covered by all reasons together") {
    std::string trees = "chart light\n";
    for (int i = 0; i < 8; ++i) trees += "split e\n";
    for (int i = 0; i < 7; ++i) trees += "split lambda\n";
    trees += "meets\n";  // e in [0, 1/128], lambda in [0, 1/8]
    for (int i = 0; i < 4; ++i) trees += "count 1 2\n";
    for (int i = 0; i < 3; ++i) trees += "meets-reversed\n";  // from 2 on
    for (int i = 0; i < 8; ++i) trees += "count 1 2\n";
    const std::string text = mutated(single(10, 4, 0, ""), "chart light\ncount 1 2\n", trees);
    constexpr double meet = 0x1p-15, turned = 7 * 0x1p-11;
    const std::map<std::string_view, std::pair<std::uint64_t, double>> lines_and_share = {
        {"split", {15, 0}},
        {"count", {13, 2 - meet - turned}},
        {"meets", {1, meet}},
        {"meets-reversed", {3, turned}}};
    const File file(text);
    for (const Tally& tally : verify(file.path(), {}).tallies) {
        CAPTURE(tally.name);
        const auto expected = lines_and_share.find(tally.name);
        CHECK(tally.lines == (expected == lines_and_share.end() ? 0 : expected->second.first));
        CHECK(tally.covered == (expected == lines_and_share.end() ? 0 : expected->second.second));
    }
    CHECK(rejected(mutated(text, "meets\n", "meets 1\n"), "syntax"));
    CHECK(rejected(mutated(text, "meets-reversed\n", "meets-reversed 1\n"), "syntax"));
    CHECK(rejected(mutated(text, "meets\n", "meets-reversed\n"), "meets-reversed"));
}

TEST_CASE("each chart has a line of its own") {
    const std::string text = single(10, 4, 0, "");
    for (const std::string other :
         {"charts light", "chart bridge", "light", "chart light light", "count light"})
        CHECK(rejected(mutated(text, "chart light", other), "syntax"));
}

TEST_CASE("the leaves of a cover fill its root boxes, and a witness fills none") {
    const std::string text = single(10, 4, 4, find_witness(10, 10, 4));
    const File file(text);
    const std::uint64_t read = Watched::read, pieces = Watched::pieces;
    const Proof proof = verify(file.path(), {});
    CHECK(proof.section == &dumbbell_verify::turning());
    CHECK(proof.roots == 2);
    for (const Tally& tally : proof.tallies) {
        CAPTURE(tally.name);
        CHECK(tally.lines == (tally.name == "count" ? 2 : tally.name == "witness" ? 1 : 0));
        CHECK(tally.covered == (tally.name == "count" ? 2 : 0));
    }
    CHECK(Watched::read - read == 1);  // for those who watch how far it is
    CHECK(Watched::pieces - pieces == 1);
}

TEST_CASE("witnesses prove what they prove and nothing more") {
    const std::string witness = find_witness(10, 10, 4);
    const std::string text = single(10, 4, 4, witness);
    const auto with = [&](const std::string& other) {
        return mutated(text, "witness " + witness, "witness " + other);
    };
    const std::string state = witness.substr(0, witness.size() - 4);
    CHECK(rejected(mutated(mutated(text, "upper 4", "upper 5"), "lower 4\nwitness " + witness,
                           "lower 5\nwitness " + state + " 2 2"),
                   "witness"));
    CHECK(rejected(with(state + " 0 0"), "witness"));          // 1 + a + b < V
    CHECK(rejected(with("bridge 0b0 1b-3 1 2"), "witness"));   // e = 0: the corner
    CHECK(rejected(with("bridge 7b-2 1b-3 1 2"), "witness"));  // e > pi/2
    CHECK(rejected(with("bridge 1b-1 0b0 1 2"), "witness"));   // eta = 0: a tangent
    CHECK(rejected(with("bridge 1b-1 5b1 1 2"), "witness"));   // r (s + eta) >= 1
    CHECK(find_witness(10, 10, 5).empty());
}

TEST_CASE("a witness that doubles cannot tell from a tangent is judged in MPFR") {
    Leaf leaf;
    leaf.opcode = witness;
    leaf.claimed = 1;
    const mpq_class e(1, 2), eta = mpq_class(1) >> 1000;
    leaf.box = {{e, eta, 10}, {e, eta, 10}};
    CHECK(turning().check(leaf, nullptr) == nullptr);
    leaf.claimed = 2;
    CHECK(turning().check(leaf, nullptr) != nullptr);
}

TEST_CASE("a witness holds for a whole range of ratios or not at all") {
    const std::string witness = find_witness(10, mpq_class(21, 2), 4);
    REQUIRE_FALSE(witness.empty());
    const std::string piece = "piece 10/1 21/2\nbits 53\nupper none\nlower 4\nwitness " + witness + "\n";
    const std::string text = closed(make::header("10/1", "21/2", 1) + piece);
    CHECK(outcome_at_bits(text) == "verified");
    CHECK(rejected(mutated(mutated(text, "piece 10/1", "piece 2/1"), "ratio 10/1", "ratio 2/1"), "witness"));
    CHECK(find_witness(2, mpq_class(21, 2), 4).empty());
}

TEST_CASE("a range is covered with splits of the ratio, and not across a critical ratio") {
    const mpq_class a(10), b(11);
    const std::string text = closed(make::header("10/1", "11/1", 1) + make::piece(a, b, 4, 0, ""));
    CHECK(outcome_at_bits(text) == "verified");
    CHECK_THROWS_AS(make::cover(turning(), 2, 10, 3), std::runtime_error);   // N*(10) = 4
    CHECK_THROWS_AS(make::cover(turning(), 11, 12, 4), std::runtime_error);  // N*(12) = 5
    const std::string below = single(mpq_class(113, 10), 4, 0, "");
    CHECK(rejected(mutated(mutated(below, "ratio 113/10 113/10", "ratio 11/1 12/1"), "piece 113/10 113/10",
                           "piece 11/1 12/1"),
                   "count"));
}

TEST_CASE("large ratios: q = 10^4 and 10^6 in double and in 64 bits, one less fails") {
    CHECK(outcome_at_bits(single(100, 10, 0, "")) == "verified");
    const bool far = scaled(1) >= 20;  // seconds
    const std::string text = far ? single(1'000'000, 887, 0, "") : single(10'000, 90, 0, "");
    CHECK(outcome_at_bits(text) == "verified");
    CHECK(outcome_at_bits(mutated(text, "bits 53", "bits 64")) == "verified");
    if (!far) return;
    CHECK(outcome_at_bits(single(10'000, 90, 0, "")) == "verified");
    CHECK_THROWS_AS(make::cover(turning(), 10'000, 10'000, 89), std::runtime_error);
}

TEST_CASE("a ratio beyond the range of double is judged in MPFR") {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, 400);
    const std::string q = power.get_str() + "/1";
    const std::string text =
        closed(make::header(q, q, 1) + "piece " + q + " " + q +
               "\nbits 53\nupper 4\nchart bridge\ncount 1 2\nchart light\ncount 1 2\nlower 0\n");
    CHECK(outcome_at_bits(text) == "count: not certified: G <= a for X");
}
