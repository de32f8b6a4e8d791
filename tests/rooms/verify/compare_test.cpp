// Two claims compared piece by piece (format-sections.md, section 4).
#include "verify/program/compare.hpp"

#include <catch2/catch.hpp>
#include <vector>

using namespace dumbbell_verify;

namespace {

Collisions claim(const std::vector<Collisions::Part>& parts) {
    Collisions result;
    result.keep = true;
    result.lo = parts.front().lo;
    result.hi = parts.back().hi;
    for (const auto& p : parts) result.add(p.lo, p.hi, p.upper, p.lower);
    return result;
}
Comparison compared(const char* lemma, const std::vector<Collisions::Part>& a,
                    const std::vector<Collisions::Part>& b) {
    return compare(*find_lemma(lemma), claim(a), claim(b));
}

}  // namespace

TEST_CASE("the lemmas that can be compared") {
    CHECK(find_lemma("4.1")->slack == 0);
    CHECK(find_lemma("4.2")->slack == 1);
    CHECK(find_lemma("4.3") == nullptr);
    CHECK(find_lemma("") == nullptr);
}

TEST_CASE("overlapping pieces are compared, in words and as an object") {
    const Comparison found = compared("4.1", {{1, 3, 4, 4}, {3, 5, 5, 5}}, {{2, 3, 6, 5}, {3, 9, 6, 5}});
    CHECK(found.holds);
    CHECK(found.text == "lemma=4.1 ratio=2/1:5/1 excess=0 least-excess=-1 gaps=0");
    CHECK(found.json ==
          R"({"ratio":{"lo":"2/1","hi":"5/1"},"excess":0,"least_excess":-1,"gaps":0,"reason":null})");
}

TEST_CASE("what is not proved is named") {
    const Comparison excess = compared("4.1", {{1, 3, 4, 4}, {3, 5, 6, 6}}, {{2, 9, 5, 5}});
    CHECK_FALSE(excess.holds);
    CHECK(excess.text == "lemma=4.1 not proved on 3/1:5/1: upper=6 of the first file, lower=5 of the second");
    CHECK(excess.json == R"({"ratio":null,"excess":null,"least_excess":null,"gaps":null,"reason":)"
                         R"("not proved on 3/1:5/1: upper=6 of the first file, lower=5 of the second"})");
    CHECK(compared("4.2", {{1, 3, 4, 4}, {3, 5, 6, 6}}, {{2, 9, 5, 5}}).holds);
    CHECK(compared("4.2", {{1, 3, {}, 4}}, {{1, 3, 5, 5}}).text ==
          "lemma=4.2 not proved on 1/1:3/1: upper=none of the first file, lower=5 of the second");
    CHECK(compared("4.1", {{1, 2, 4, 4}}, {{3, 4, 4, 4}}).text ==
          "lemma=4.1 the files have no mass ratio in common");
}

TEST_CASE("a piece is compared with all that it overlaps: at its beginning, within, and at its end") {
    const std::vector<Collisions::Part> whole{{2, 6, 6, 6}};
    CHECK(compared("4.1", whole, {{1, 3, 6, 6}, {3, 5, 6, 6}, {5, 7, 6, 6}}).holds);
    CHECK_FALSE(compared("4.1", whole, {{1, 3, 4, 4}, {3, 5, 6, 6}, {5, 7, 6, 6}}).holds);
    CHECK_FALSE(compared("4.1", whole, {{1, 3, 6, 6}, {3, 5, 4, 4}, {5, 7, 6, 6}}).holds);
    CHECK_FALSE(compared("4.1", whole, {{1, 3, 6, 6}, {3, 5, 6, 6}, {5, 7, 4, 4}}).holds);
}

TEST_CASE("a gap's excess of one is counted, and nothing but gaps proves nothing") {
    const Comparison found = compared("4.1", {{1, 3, 4, 4}, {3, 4, 5, 4}, {4, 6, 5, 5}},
                                      {{1, 3, 4, 4}, {3, 4, 5, 4}, {4, 6, 5, 5}});
    CHECK(found.holds);
    CHECK(found.text == "lemma=4.1 ratio=1/1:6/1 excess=0 least-excess=0 gaps=1");
    CHECK(compared("4.1", {{3, 4, 5, 4}}, {{3, 4, 5, 4}}).text == "lemma=4.1 not proved at 3/1");
    CHECK_FALSE(compared("4.1", {{1, 3, 4, 4}, {3, 4, 6, 5}}, {{1, 4, 4, 4}}).holds);
}

TEST_CASE("a piece without an upper bound is no gap, and has no excess that a gap could explain") {
    const std::vector<Collisions::Part> gap{{1, 3, 5, 4}, {3, 5, 5, 5}},
        unbounded{{1, 3, {}, 4}, {3, 5, 5, 5}};
    CHECK(compared("4.1", gap, gap).holds);
    CHECK_FALSE(compared("4.1", unbounded, gap).holds);
    CHECK(compared("4.1", gap, unbounded).holds);
    CHECK_FALSE(compared("4.1", {{1, 5, 5, 5}}, unbounded).holds);
    Collisions taken_back = claim({{1, 3, 0, -1}, {3, 5, 0, 0}});
    taken_back.parts.front().upper.reset();
    CHECK_FALSE(compare(*find_lemma("4.1"), claim({{1, 5, 0, 0}}), taken_back).holds);
}

TEST_CASE("a file that goes farther than the other is compared up to where that ends") {
    CHECK(compared("4.1", {{1, 2, 4, 4}, {2, 3, 4, 4}, {3, 4, 9, 9}, {4, 5, {}, 9}}, {{1, 3, 4, 4}}).text ==
          "lemma=4.1 ratio=1/1:3/1 excess=0 least-excess=0 gaps=0");
}

TEST_CASE("at a single ratio the best bounds of all pieces that contain it count") {
    CHECK(compared("4.1", {{3, 3, 4, 4}}, {{1, 3, 3, 3}, {3, 5, 4, 4}}).holds);
    CHECK(compared("4.1", {{3, 3, 4, 4}}, {{1, 3, 4, 4}, {3, 5, 3, 3}}).holds);
    CHECK(compared("4.1", {{3, 3, 4, 4}}, {{1, 3, 4, 3}, {3, 5, 4, 4}}).text ==
          "lemma=4.1 ratio=3/1:3/1 excess=0 least-excess=0 gaps=0");
    CHECK(compared("4.1", {{1, 3, 4, 4}, {3, 3, 5, 4}}, {{3, 5, 4, 4}}).holds);
    const Comparison low = compared("4.1", {{3, 3, 5, 4}}, {{1, 3, 3, 3}, {3, 5, 4, 4}});
    CHECK_FALSE(low.holds);
    CHECK(low.text == "lemma=4.1 not proved at 3/1");
}

TEST_CASE("the range that was asked about cuts the comparison") {
    Collisions a = claim({{1, 3, 4, 4}, {3, 5, 6, 6}});
    a.ratios.emplace(2, 3);
    const Comparison found = compare(*find_lemma("4.1"), a, claim({{1, 9, 5, 5}}));
    CHECK(found.holds);
    CHECK(found.text == "lemma=4.1 ratio=2/1:3/1 excess=-1 least-excess=-1 gaps=0");
}
