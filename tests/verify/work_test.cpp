// The bound of the work on a leaf: what format.md promises to accept is within it, and what is beyond ends.
#include "verify/work.hpp"

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <numeric>

#include "verify/precision.hpp"
#include "verify/ray.hpp"
#include "verify/reader.hpp"

using namespace dumbbell_verify;

namespace {

/// Follows a ray at q = 10^12 for so many collisions, of hundreds of thousands. False: it has more.
template <class N>
bool follow(std::uint64_t collisions) {
    const N r = bound(down, mpq_class(1, 1'000'000'000'000), N(0));
    return Rays<N>(nullptr).at_most("", {N(0), r, r}, collisions);
}
template <class N>
double per_collision(std::uint64_t collisions) {
    Work::begin();
    CHECK_FALSE(follow<N>(collisions));
    return static_cast<double>(Work::done()) / static_cast<double>(collisions);
}

}  // namespace

TEST_CASE("the collisions of format.md, section 4, are within the bound") {
    const double most = static_cast<double>(Work::most);
    CHECK(1e8 * per_collision<double>(1000) < most);
    for (const unsigned bits : {53U, 64U, 96U, 128U, 160U, 200U, 256U, 400U, 512U, 1000U, 2048U, 4096U}) {
        Big::precision = bits;
        const double promised = std::min(1e6, 0x1p34 / bits / bits);
        INFO(bits << " bits, " << promised << " collisions");
        CHECK(promised * per_collision<Big>(bits < 1000 ? 200 : 20) < most);
    }
}

TEST_CASE("the bound of the work ends rays, in double and in multiple precision") {
    Work::begin();
    Work::spend(Work::most - 1'000'000);
    CHECK_THROWS_AS(follow<double>(1000), std::length_error);
    Work::begin();
    Work::spend(Work::most - 1'000'000);
    Big::precision = 128;
    CHECK_THROWS_AS(follow<Big>(1000), std::length_error);
    Work::begin();
    CHECK_FALSE(follow<Big>(10));
}

TEST_CASE("every leaf has the whole bound, and one beyond it is a resource limit") {
    CHECK_THROWS_AS(Work::spend(Work::most + 1), std::length_error);
    Leaf leaf;
    leaf.claimed = 4;
    leaf.a = 1;
    leaf.b = 2;
    leaf.opcode = count_leaf;
    leaf.multiple = true;
    leaf.bits = 100;
    leaf.box = turning().root(0, 10, 10);
    CHECK(turning().check(leaf, nullptr) == nullptr);
    CHECK(Work::done() < Work::most / 1000);
    const auto failure = judge(7, "count", [] {
        Work::spend(Work::most);
        return static_cast<const char*>(nullptr);
    });
    REQUIRE(failure);
    CHECK(failure->verdict == Verdict::limit);
    CHECK(failure->line == 7);
}

TEST_CASE("leaves behind a failure are not judged, those before it are") {
    std::vector<int> leaves(500);
    std::iota(leaves.begin(), leaves.end(), 0);
    for (const unsigned jobs : {1U, 4U}) {
        std::vector<std::atomic<bool>> judged(leaves.size());
        const auto judge_one = [&](int i) -> std::optional<Failure> {
            judged[static_cast<std::size_t>(i)] = true;
            if (i == 200 || i == 220) return Failure{Verdict::limit, static_cast<std::uint64_t>(i), "", ""};
            return std::nullopt;
        };
        try {
            judge_all(leaves, jobs, judge_one);
            FAIL("no failure");
        } catch (const Failure& failure) {
            CHECK(failure.line == 200);
        }
        CHECK(
            std::all_of(judged.begin(), judged.begin() + 201, [](const auto& done) { return done.load(); }));
        if (jobs == 1)
            CHECK(std::none_of(judged.begin() + 201, judged.end(), [](const auto& d) { return d.load(); }));
    }
}
