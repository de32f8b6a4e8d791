// What consecutive pieces say together: the same as Collisions says of them one after the other.
#include "verify/program/piece_sums.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace dumbbell_verify;

namespace {

Collisions random_claim(std::uint64_t pieces, const Pieces& keep, std::mt19937& random) {
    Collisions claim;
    claim.keep = keep;
    for (std::uint64_t i = 0; i < pieces; ++i) {
        const std::uint64_t lower = random() % 5;
        std::optional<std::uint64_t> upper;
        if (random() % 4 > 0) upper = lower + random() % 3;
        claim.add(static_cast<unsigned long>(i + 1), static_cast<unsigned long>(i + 2), upper, lower);
    }
    return claim;
}

void check_all(const Collisions& claim) {
    const PieceSums sums(claim);
    for (std::size_t i = 0; i < claim.parts.size(); ++i) {
        Collisions expected;
        for (std::size_t j = i; j < claim.parts.size(); ++j) {
            const Collisions::Part& p = claim.parts[j];
            expected.add(p.lo, p.hi, p.upper, p.lower);
            const Bounds found = sums.of({claim.keep.first + i, claim.keep.first + j});
            INFO(claim.parts.size() << " pieces, " << i << " to " << j);
            REQUIRE((found.upper == expected.upper));
            REQUIRE((found.lower == expected.lower));
            REQUIRE(found.gaps == expected.gaps);
            REQUIRE(found.open == expected.open);
        }
    }
}

}  // namespace

TEST_CASE("sums of pieces: any of up to 40 pieces, as if they were added one by one") {
    std::mt19937 random(1);
    for (std::uint64_t n = 1; n <= 40; ++n) check_all(random_claim(n, all_pieces, random));
}

TEST_CASE("sums of pieces: of those that are kept, under their own numbers") {
    std::mt19937 random(2);
    for (std::uint64_t first = 1; first <= 9; ++first)
        for (std::uint64_t last = first; last <= 9; ++last) {
            const Collisions claim = random_claim(9, {first, last}, random);
            REQUIRE(claim.parts.size() == last - first + 1);
            REQUIRE(to_string(claim.parts.front().lo) == std::to_string(first) + "/1");
            REQUIRE(to_string(claim.parts.back().hi) == std::to_string(last + 1) + "/1");
            check_all(claim);
        }
    CHECK(random_claim(9, {}, random).parts.empty());
}
