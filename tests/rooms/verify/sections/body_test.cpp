// The scene body: true certificates of a coin and of rods are accepted, false ones are not; and what is
// demanded.
#include "catch.hpp"
#include "rooms/verify/core/make_certificate.hpp"
#include "rooms/verify/program/run_program.hpp"
#include "scale.hpp"
#include "verify/program/verify.hpp"

using namespace dumbbell_verify;
using make::closed;
using make::File;
using make::mutated;
using make::run;

namespace {

std::string said_of_bodies(const std::string& text, unsigned precision = 0) {
    return make::outcome(text, make::asking("body", precision));
}

std::string body_text(const std::string& ratios, const std::string& rho, int upper, const std::string& cover,
                      int lower, const std::string& witness) {
    return closed(
        "dumbbell-certificate 1\ngenerator test 1.0\nlemmas body\nscene body\nsection full\nclaim "
        "collisions\n"
        "ratio " +
        ratios + "\nrho " + rho + "\npieces 1\npiece " + ratios + "\nbits 53\nupper " +
        std::to_string(upper) + "\n" + cover + "lower " + std::to_string(lower) + "\n" +
        (lower > 0 ? "witness " + witness + "\n" : ""));
}
const std::string coin = body_text("4/1 4/1", "1/1 1/1", 4, "symmetric\n", 4, "corner 0b0 0b0 3 0"),
                  uniform_rod = body_text("3/1 3/1", "1/1 1/1", 3, "symmetric\n", 3, "corner 0b0 0b0 2 0");

/// At rho = 1/2.
std::string cover_of_half(const mpq_class& q, std::uint64_t upper) {
    return make::cover(body(), q, q, upper, 53, Range(mpq_class(1, 2), mpq_class(1, 2)));
}
/// Of a single body.
const std::string& lopsided() {
    static const std::string text =
        body_text("3/1 3/1", "1/2 1/2", 3, cover_of_half(3, 3), 3, "bridge 17b-6 3b-5 0 2");
    return text;
}

Leaf leaf_of(std::size_t chart, const mpq_class& q, const mpq_class& rho) {
    Leaf leaf;
    leaf.chart = chart;
    leaf.box = body().root(chart, q, q);
    leaf.box.lo[3] = leaf.box.hi[3] = rho;
    return leaf;
}

}  // namespace

TEST_CASE("scene body: a coin has 4 collisions, and the uniform rod, a tie, has 3") {
    for (const std::string& text : {coin, uniform_rod}) {
        CHECK(said_of_bodies(text) == "verified");
        CHECK(said_of_bodies(mutated(text, "symmetric\n", "symmetric 1\n")) == "syntax");
    }
    CHECK(said_of_bodies(body_text("2/1 3/1", "1/1 1/1", 3, "symmetric\n", 3, "corner 0b0 0b0 2 0")) ==
          "verified");
}

TEST_CASE("scene body: the witness in the corner is exact, at the least rho and Q") {
    const auto said = [](const std::string& witness) {
        return said_of_bodies(mutated(coin, "corner 0b0 0b0 3 0", witness));
    };
    for (const char* wrong : {"corner 0b0 0b0 4 0", "corner 0b0 0b0 2 0", "corner 0b0 0b0 2 1",
                              "corner 1b0 0b0 3 0", "corner 0b0 1b0 3 0"})
        CHECK(said(wrong) == "witness");
    CHECK(said("corner 0b0 0b0 3") == "syntax");
    const auto at_least = [](const std::string& ratios, const std::string& rho, int n) {
        const std::string text =
            body_text(ratios, rho, 9, "symmetric\n", n, "corner 0b0 0b0 " + std::to_string(n - 1) + " 0");
        return said_of_bodies(mutated(text, "upper 9\nsymmetric\n", "upper none\n"));
    };
    CHECK(at_least("4/1 9/1", "1/2 1/1", 3) == "verified");
    CHECK(at_least("9/1 9/1", "1/2 1/1", 4) == "verified");
    CHECK(at_least("400000000/1 400000000/1", "1/1 1/1", 10001) == "verified");
    CHECK(at_least("400000000/1 400000000/1", "1/1 1/1", 10003) == "limit");
}

TEST_CASE("scene body: true covers and witnesses of a lopsided rod are accepted, false ones are not") {
    const std::string& text = lopsided();
    CHECK(said_of_bodies(text) == "verified");
    CHECK(said_of_bodies(mutated(text, "upper 3", "upper 2")) == "count");
    CHECK(said_of_bodies(mutated(text, "count 2", "count 0")) == "count");
    CHECK(said_of_bodies(mutated(text, "count 2", "count 3")) == "count");
    CHECK(said_of_bodies(mutated(text, "count 2", "outside")) == "outside");
    for (const char* elsewhere : {"once", "meets", "meets-reversed", "symmetric"})
        CHECK(said_of_bodies(mutated(text, "count 2\n", std::string(elsewhere) + "\n")) == "opcode");
    CHECK(said_of_bodies(mutated(text, "chart departure", "chart again")) == "syntax");
    CHECK(said_of_bodies(mutated(text, "rho 1/2 1/2", "rho 1/2 2/3")) == "count");
    const auto said = [&](const std::string& witness) {
        return said_of_bodies(mutated(text, "bridge 17b-6 3b-5 0 2", witness));
    };
    CHECK(said("corner 0b0 0b0 2 0") == "verified");
    if (scaled(1) >= 20) CHECK_THROWS_AS(cover_of_half(3, 2), std::runtime_error);
}

TEST_CASE("scene body: a cover may halve the range of rho, and no single rho") {
    const mpq_class lo(1, 2), hi(2501, 5000);
    std::string cover;
    for (const std::size_t chart : {0U, 1U}) {
        Leaf leaf = leaf_of(chart, 3, lo);
        leaf.claimed = 3;
        leaf.box.hi[3] = hi;
        const std::string tree = make::tree(body(), leaf);  // of both halves, too
        cover += "chart " + std::string(body().charts[chart].name) + "\nsplit rho\n" + tree + tree;
    }
    const auto text_of = [](const std::string& rho, const std::string& trees) {
        return body_text("3/1 3/1", rho, 3, trees, 3, "corner 0b0 0b0 2 0");
    };
    const std::string text = text_of("1/2 2501/5000", cover);
    CHECK(said_of_bodies(text) == "verified");
    CHECK(said_of_bodies(mutated(text, "rho 1/2 2501/5000", "rho 1/2 3/4")) == "count");
    CHECK(said_of_bodies(mutated(text, "rho 1/2 2501/5000", "rho 1/2 1/2")) == "split");
    CHECK(said_of_bodies(mutated(text, "split rho", "split r")) == "syntax");
    const std::size_t departures = cover.find("chart departure\n");
    CHECK(said_of_bodies(text_of("1/2 2501/5000", cover.substr(0, departures) +
                                                      "chart departure\nsplit rho\noutside\n" +
                                                      cover.substr(departures + 26))) == "outside");
    std::string deep = "chart contact\n";
    for (int i = 0; i < 401; ++i) deep += "split rho\n";
    CHECK(said_of_bodies(text_of("1/2 2501/5000", deep)) == "depth");
    const std::string& single = lopsided();
    CHECK(said_of_bodies(mutated(single, "chart contact\n", "chart contact\nsplit rho\n")) == "split");
}

TEST_CASE("scene body: a rod that hits with its heavy end before and after a collision with the light end") {
    const auto said = [](const std::string& counts, const std::string& ratios = "9/1 9/1",
                         const std::string& rho = "2/15 2/15", unsigned precision = 0) {
        const std::string text = body_text(ratios, rho, 9, "", 5, "bridge 15b-5 3b-6 " + counts);
        return said_of_bodies(mutated(text, "upper 9\n", "upper none\n"), precision);
    };
    for (const unsigned bits : {0U, 100U}) CHECK(said("1 3", "9/1 9/1", "2/15 2/15", bits) == "verified");
    CHECK(said("1 3", "9/1 901/100", "133/1000 134/1000") == "number");
    CHECK(said("1 3", "9/1 901/100", "133/1000 67/500") == "verified");
    CHECK(said("1 3", "9/1 20/1") == "witness");
}

TEST_CASE(
    "scene body: without mass of the rod the heavy end hits once, and the cover is that of the dumbbell") {
    const auto closes = [](const mpq_class& q, std::uint64_t upper) {
        try {
            return !cover_of_half(q, upper).empty();
        } catch (const std::runtime_error&) {
            return false;
        }
    };
    CHECK(closes(2, 3));
    CHECK_FALSE(closes(2, 2));
}

TEST_CASE("scene body: with any mass of the rod the heavy end may hit again") {
    const auto most = [](const mpq_class& q, int count, const mpq_class& more_rho = 0,
                         const mpq_class& more_q = 0) {
        Leaf leaf = leaf_of(0, q, mpq_class(1, 2));
        leaf.box.hi[3] += more_rho;
        leaf.box.hi[2] += more_q;
        leaf.box.lo[0] = leaf.box.hi[0] = 3;
        leaf.box.lo[1] = leaf.box.hi[1] = mpq_class(1, 100);
        leaf.a = count;
        leaf.claimed = count + 1;
        return body().check(leaf, nullptr) == nullptr;
    };
    CHECK(most(2, 1));
    CHECK_FALSE(most(2, 0));
    CHECK_FALSE(most(2, 1, mpq_class(1, 20)));  // only one of these has no mass there
    CHECK_FALSE(most(2, 1, 0, mpq_class(1, 20)));
    CHECK(most(mpq_class(11, 5), 2));
    CHECK_FALSE(most(mpq_class(11, 5), 1));
}

TEST_CASE("scene body: the line rho has two ratios, at most 1, of bodies that there are") {
    for (const char* wrong : {"rho 1/5 1/1", "rho 1/1 1/2", "rho 1/1 5/4", "rho 0/1 1/1"})
        CHECK(said_of_bodies(mutated(coin, "rho 1/1 1/1", wrong)) == "number");
    CHECK(said_of_bodies(mutated(coin, "rho 1/1 1/1", "rho 1/1")) == "syntax");
    CHECK(said_of_bodies(mutated(coin, "lemmas body", "lemmas 1")) == "unsupported");
    CHECK(said_of_bodies(mutated(coin, "section full", "section turning")) == "unsupported");
    CHECK(said_of_bodies(make::replaced(coin, "total symmetric 1", "total symmetric 0")) == "total");
    CHECK(said_of_bodies(make::replaced(coin, "total symmetric 1", "total once 0")) == "total");
}

TEST_CASE("scene body: a bound is demanded of a body, and repeated") {
    const File file(coin);
    const auto asked = [&](const std::string& options) { return run(options + " " + file.path()); };
    const std::string verdict =
        "s VERIFIED scene=body ratio=4/1:4/1 rho=1/1:1/1 upper=4 lower=4 gaps=0 open=0 sha256=";
    CHECK(asked("").last().starts_with(verdict));
    const auto exactly = asked("--inertia 4 --rho 1 --exactly 4");
    CHECK(asked("--coin --exactly 4").out == exactly.out);
    CHECK(asked("--ratio 1 --rod-mass 0.5 --exactly 4").code == 1);
    CHECK(exactly.code == 0);
    CHECK(exactly.last().starts_with(verdict));
    CHECK(exactly.last().ends_with(
        " demanded-inertia=4/1:4/1 demanded-rho=1/1:1/1 exactly=4 demanded-scene=body"));
    CHECK(make::has(exactly,
                    "Proved: at Q 4, at rho 1, no motion of the body in a plane, without a corner, hits the "
                    "floor more than 4 times, and some motion hits it 4 times.\n"));
    CHECK(
        asked("--rho 1 --inertia 4 --max 3").last().ends_with("at most 3 collisions for every Q in 4/1:4/1"));
    CHECK(asked("--ratio 4 --max 4").code == 1);
    for (const char* of_a_dumbbell : {"--gap 0", "--gaps 0", "--heavy-at-most 1"})
        CHECK(
            asked(of_a_dumbbell).last().ends_with("the scene is body, and dumbbell was demanded (--scene)"));
    for (const char* wrong :
         {"--scene body --max 4", "--rho 1 --max 4", "--inertia 4 --max 4", "--inertia 4 --rho 2 --max 4",
          "--inertia 4 --rho 1:0.5 --max 4", "--rho 0", "--coin --rho 1", "--coin=1", "--coin --rod-mass 1",
          "--rod-mass 1", "--ratio 1:2 --rod-mass 1", "--coin --scene dumbbell", "--coin --claim incoming"})
        CHECK(asked(wrong).code == 2);
    for (const char* ratio : {"--rho 1 ", "--inertia 4 ", "--coin ", "--scene body "})
        for (const char* value : {"4", "1/4"})
            CHECK(asked(ratio + std::string("--ratio ") + value).err ==
                  "dumbbell-verify: bodies have no --ratio: their Q is --inertia\n");
    CHECK(asked("--rho 1 --inertia 1/4").code == 1);  // a number of its own, where mass ratios are inverted
    CHECK(make::has(asked("--json --rho 1"),
                    R"("ratio":{"lo":"4/1","hi":"4/1"},"rho":{"lo":"1/1","hi":"1/1"},)"));
    CHECK(make::has(asked("--explain 1:cover"), "ceil(pi/corner) <= U: holds"));
    const File list(file.path() + "\t--coin --exactly 4\n");
    CHECK(run("--claims " + list.path()).code == 0);
    const File short_list(file.path() + "\t--inertia 4 --exactly 4\n");
    CHECK(run("--claims " + short_list.path()).code == 2);
}
