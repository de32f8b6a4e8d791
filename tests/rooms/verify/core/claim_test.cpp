// What pieces say together: the demand of the command line against the chain of pieces.
#include <algorithm>
#include <random>
#include <vector>

#include "catch.hpp"

using dumbbell_verify::Collisions;

namespace {

struct Piece {
    int a, b;
    std::optional<std::uint64_t> upper;
    std::uint64_t lower;
};

/// Whether the pieces prove max and min on [lo, hi] (0, 0: on all that there is).
bool proves(const std::vector<Piece>& pieces, int lo, int hi, std::optional<std::uint64_t> most,
            std::optional<std::uint64_t> least, std::optional<mpq_class> gap = {}) {
    Collisions claim;
    claim.gap = gap;
    if (lo > 0) claim.ratios.emplace(lo, hi);
    claim.most = most;
    claim.least = least;
    claim.lo = pieces.front().a;
    claim.hi = pieces.back().b;
    for (const Piece& p : pieces) claim.add(p.a, p.b, p.upper, p.lower);
    return claim.missing().empty();
}

const std::vector<Piece> five_pieces = {
    {1, 5, 3, 3}, {5, 6, 4, 3}, {6, 9, 4, 4}, {9, 9, 4, 4}, {9, 12, {}, 2}};
constexpr auto none = std::nullopt;

/// The same gaps by the unit cells that they consist of: each cell of the range in question lies in one
/// piece.
dumbbell_verify::Known gaps_by_cells(const std::vector<Piece>& pieces, long from, long to) {
    dumbbell_verify::Known all;
    long begin = 0;
    for (long x = from; x <= to; ++x) {
        const bool known = x == to || std::any_of(pieces.begin(), pieces.end(), [&](const Piece& p) {
                               return p.a <= x && x < p.b && p.upper == p.lower;
                           });
        if (!known && begin == 0) begin = x;
        if (!known || begin == 0) continue;
        ++all.gaps;
        all.widest = std::max(all.widest, mpq_class(mpq_class(x) / begin - 1));
        begin = 0;
    }
    return all;
}

}  // namespace

TEST_CASE("a demand is met by implication") {
    CHECK(proves(five_pieces, 0, 0, none, none));
    CHECK(proves(five_pieces, 1, 9, 4, 3));
    CHECK(proves(five_pieces, 1, 9, 7, 1));
    CHECK_FALSE(proves(five_pieces, 1, 9, 3, none));
    CHECK_FALSE(proves(five_pieces, 1, 9, none, 4));
    CHECK(proves(five_pieces, 0, 0, none, 2));
    CHECK_FALSE(proves(five_pieces, 0, 0, none, 3));
    CHECK_FALSE(proves(five_pieces, 0, 0, 1000, none));  // a piece without upper bound
}

TEST_CASE("only the pieces that meet the range count, and a shared end point may use either") {
    CHECK(proves(five_pieces, 2, 4, 3, 3));
    CHECK(proves(five_pieces, 5, 5, 3, 3));
    CHECK(proves(five_pieces, 1, 5, 3, 3));
    CHECK_FALSE(proves(five_pieces, 1, 6, 3, none));
    CHECK(proves(five_pieces, 6, 9, 4, 4));
    CHECK_FALSE(proves(five_pieces, 5, 9, none, 4));
    CHECK(proves(five_pieces, 6, 6, 4, 4));
    CHECK(proves(five_pieces, 9, 9, 4, 4));
    CHECK_FALSE(proves(five_pieces, 9, 10, 4, none));
    CHECK(proves(five_pieces, 9, 10, none, 2));
}

TEST_CASE("ratios that the file does not cover are not proved") {
    CHECK_FALSE(proves(five_pieces, 13, 14, none, none));
    CHECK_FALSE(proves(five_pieces, 12, 13, none, none));
    CHECK_FALSE(proves({{3, 4, 3, 3}}, 2, 3, 3, none));
    CHECK(proves({{3, 4, 3, 3}}, 3, 3, 3, none));
}

TEST_CASE("of ratios that the file covers in part it is said which part") {
    const auto missing = [](const mpq_class& lo, const mpq_class& hi) {
        Collisions claim;
        claim.ratios.emplace(lo, hi);
        claim.most = 9;
        claim.lo = 1;
        claim.hi = 100;
        claim.add(1, 50, 7, 7);
        claim.add(50, 100, 10, 7);
        return claim.missing();
    };
    CHECK(missing(1, 200) == "of the mass ratios 1/1:200/1 only 1/1:100/1 are covered");
    CHECK(missing(mpq_class(3, 2), 101) == "of the mass ratios 3/2:101/1 only 3/2:100/1 are covered");
    CHECK(missing(100, 101) == "of the mass ratios 100/1:101/1 only 100/1:100/1 are covered");
    CHECK(missing(101, 102) == "nothing is said of the mass ratios 101/1:102/1, only of 1/1:100/1");
    CHECK(missing(2, 60) == "not proved: at most 9 collisions for every mass ratio in 2/1:60/1");
    CHECK(missing(2, 50).empty());
}

TEST_CASE("gaps that touch are one, and end with the range in question") {
    const auto said = [](const std::vector<Piece>& pieces, int lo, int hi) {
        Collisions claim;
        claim.ratios.emplace(lo, hi);
        claim.lo = pieces.front().a;
        claim.hi = pieces.back().b;
        for (const Piece& p : pieces) claim.add(p.a, p.b, p.upper, p.lower);
        const auto all = claim.whole();
        return std::pair(all.gaps, all.widest);
    };
    using Said = std::pair<mpz_class, mpq_class>;
    const std::vector<Piece> touching = {{1, 2, 3, 3}, {2, 3, 4, 3}, {3, 4, 5, 4}, {4, 8, 5, 5}};
    CHECK((said(touching, 1, 8) == Said(1, 1)));
    CHECK((said(touching, 3, 8) == Said(1, mpq_class(1, 3))));
    CHECK((said(touching, 4, 8) == Said(0, 0)));
    const std::vector<Piece> at_a_point = {{2, 3, 4, 3}, {3, 3, 4, 4}, {3, 4, 5, 4}};
    CHECK((said(at_a_point, 2, 4) == Said(1, 1)));
    CHECK_FALSE(proves({{2, 3, 4, 3}, {3, 9, 4, 4}}, 2, 9, none, none, mpq_class(1, 3)));
    CHECK(proves({{2, 3, 4, 3}, {3, 9, 4, 4}}, 2, 9, none, none, mpq_class(1, 2)));
    CHECK_FALSE(proves({{2, 3, 5, 3}, {3, 9, 4, 4}}, 2, 9, none, none, mpq_class(1, 2)));
    CHECK(proves({{2, 3, 4, 3}, {3, 4, 5, 4}}, 3, 3, none, none, mpq_class(0)));  // both say 4
    CHECK_FALSE(proves({{3, 3, 4, 3}}, 3, 3, none, none, mpq_class(1, 2)));
}
