// The sections full and plain: true certificates are accepted, false ones are not.
#include "catch.hpp"
#include "rooms/verify/core/leaf_rows.hpp"
#include "rooms/verify/program/run_program.hpp"

using namespace dumbbell_verify;
using make::closed;
using make::cover;
using make::File;
using make::mutated;
using make::run;

namespace {

std::string outcome_in_scene(const std::string& text, const std::string& scene = "dumbbell",
                             unsigned precision = 0) {
    return make::outcome(text, make::asking(scene, precision));
}

std::string header(const std::string& lemmas, const std::string& scene, const std::string& section,
                   const std::string& lo, const std::string& hi, int pieces = 1) {
    return "dumbbell-certificate 1\ngenerator test 1.0\nlemmas " + lemmas + "\nscene " + scene +
           "\nsection " + section + "\nclaim collisions\nratio " + lo + " " + hi + "\npieces " +
           std::to_string(pieces) + "\n";
}

std::string full_text(const Section& section, const std::string& q, std::uint64_t upper) {
    return closed(header(std::string(section.lemmas), "dumbbell", "full", q, q) + "piece " + q + " " + q +
                  "\nbits 53\nupper " + std::to_string(upper) + "\n" +
                  cover(section, mpq_class(q), mpq_class(q), upper) + "lower 0\n");
}

}  // namespace

TEST_CASE("sections full and plain: true covers are accepted, false ones are not") {
    for (const Section* section : {&full(), &plain()}) {
        const bool is_plain = section == &plain();
        const std::string q = is_plain ? "2/1" : "10/1";  // plain evaluation needs many more boxes
        const int n = is_plain ? 3 : 4;
        const std::string text = full_text(*section, q, static_cast<std::uint64_t>(n));
        const std::string most = "count " + std::to_string(n - 1);
        const auto with = [&](const std::string& from, const std::string& to) {
            return outcome_in_scene(mutated(text, from, to));
        };
        CHECK(outcome_in_scene(text) == "verified");
        if (!is_plain) CHECK(outcome_in_scene(text, "dumbbell", 80) == "verified");
        CHECK(with("upper " + std::to_string(n), "upper " + std::to_string(n - 1)) == "count");
        CHECK(with("chart departure", "chart light") == "syntax");
        CHECK(with("split eta", "split lambda") == "syntax");
        CHECK(with(most, most + " 0") == "syntax");
        CHECK(with(most, "count 0") == "count");
        CHECK(with(most, "count " + std::to_string(n)) == "count");
        CHECK(with(most, "outside") == "outside");
        CHECK(with(most, "meets") == "opcode");
        CHECK(with(most, "once") == "opcode");
        CHECK(with("once", "outside") == "outside");
        CHECK(with("once", most) == "opcode");
        CHECK(with("chart again\nonce\n", "") == "syntax");
        CHECK(with("section full", "section turning") != "verified");
    }
    CHECK_THROWS_AS(cover(full(), 10, 10, 3), std::runtime_error);
    CHECK_THROWS_AS(cover(plain(), 2, 2, 2), std::runtime_error);
}

TEST_CASE("sections full, plain and body: the root boxes are those of the format") {
    for (const Section* section : {&full(), &plain(), &body()})
        for (std::size_t chart = 0; chart < section->charts.size(); ++chart) {
            const Box root = section->root(chart, 2, 3), wide = section->root(chart, 2, mpq_class(13, 4));
            const bool departs = section->charts[chart].name == "departure";
            CHECK((root.lo == wide.lo && root.lo == std::array<mpq_class, 4>{0, 0, 2}));
            CHECK((root.hi == std::array<mpq_class, 4>{departs ? 2 : 4, departs ? 2 : 4, 3}));
            CHECK((wide.hi == std::array<mpq_class, 4>{departs ? 2 : 4, departs ? 2 : 8, mpq_class(13, 4)}));
        }
}

TEST_CASE("sections full, plain and body: the leaf outside holds beyond the chart only") {
    for (const Section* section : {&full(), &plain(), &body()}) {
        const auto holds = [&](std::size_t chart, const mpq_class& x, const mpq_class& y) {
            Leaf leaf;
            leaf.chart = chart;
            leaf.opcode = outside;
            leaf.box = {{x, y, 10}, {4, 16, 10}};
            if (section == &body()) leaf.box.lo[3] = leaf.box.hi[3] = mpq_class(1, 4);
            return section->check(leaf, nullptr) == nullptr;
        };
        CHECK(holds(0, mpq_class(22, 7), 0));
        CHECK_FALSE(holds(0, mpq_class(3141, 1000), 0));
        const mpq_class end = section == &body() ? 5 : 11;  // rho (eta - 1) = 1, exactly
        CHECK(holds(0, 0, end));
        CHECK_FALSE(holds(0, 0, end - mpq_class(1, 100)));
        CHECK(holds(1, mpq_class(8, 5), 0));
        CHECK_FALSE(holds(1, mpq_class(3, 2), 1));
        CHECK(holds(1, 0, 2));
        CHECK_FALSE(holds(1, 0, mpq_class(199, 100)));
    }
}

TEST_CASE("section full: the heavy mass is proved to touch at most once, unless a piece is open") {
    const std::string text = full_text(full(), "10/1", 4), trees = cover(full(), 10, 10, 4);
    CHECK(make::has(run(File(text).path()), " heavy-at-most=1 sha256="));
    const make::Run open = run(File(mutated(text, "upper 4\n" + trees, "upper none\n")).path());
    CHECK(open.code == 3);
    CHECK_FALSE(make::has(open, "heavy"));
}

TEST_CASE("section full: the leaf once needs a narrow range of ratios") {
    const auto holds = [](const mpq_class& lo, const mpq_class& hi, unsigned bits) {
        Leaf leaf;
        leaf.chart = 2;
        leaf.opcode = witness + 1;
        leaf.bits = bits;
        leaf.box = full().root(2, lo, hi);
        return full().check(leaf, nullptr) == nullptr;
    };
    for (const unsigned bits : {53U, 128U}) {
        for (const int q : {1, 2, 10, 1000, 1000000}) CHECK(holds(q, q, bits));
        CHECK(holds(10, mpq_class(21, 2), bits));
        CHECK_FALSE(holds(1, 1000000, bits));
    }
}

TEST_CASE("section plain: the enclosure of x ends at pi/2, not before") {
    const auto said = [](const std::string& leaf) {
        return leaf_rows::judged(leaf_rows::parsed("minimal dumbbell full departure count " + leaf));
    };
    const std::string wide = " 1 0 2 3/2 2 19/256 7/32 8/5 8/5",
                      thin = " 1 0 2 3/2 2 19/256 19/256 64/23 64/23";
    for (const std::string& leaf : {wide, thin}) CHECK(said("0" + leaf) == "certified");
    // In 5 or 6 bits slopes may be below 0, and the bounds of pi/2 are far apart: x ends at the upper.
    CHECK(said("5" + wide) == "0 < P, where E may be 0");
    CHECK(said("6" + thin) == "0 < numerator, where D may be 0");
}

TEST_CASE("combinations of words that are not in the table are unsupported") {
    const std::string text = full_text(full(), "10/1", 4);
    for (const auto& [from, to] : {std::pair{"section full", "section tangents"},
                                   {"lemmas 1", "lemmas body"},
                                   {"lemmas 1", "lemmas none"},
                                   {"scene dumbbell", "scene body"},
                                   {"scene dumbbell", "scene wedge"}})
        CHECK(outcome_in_scene(mutated(text, from, to), "") == "unsupported");
    const File file(mutated(text, "section full", "section tangents"));
    CHECK(run(file.path()).code == 3);
}

TEST_CASE("a leaf of the full section is explained in its own words") {
    const File file(full_text(full(), "10/1", 4));
    CHECK(make::has(run("--explain 1:contact " + file.path()), "1 + a <= U: holds"));
}
