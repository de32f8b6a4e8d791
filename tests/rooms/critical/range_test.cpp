#include "critical/range.hpp"

#include <atomic>

#include "catch.hpp"
#include "collisions/piece.hpp"
#include "rooms/collisions/critical_ratio.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell::critical;
using namespace dumbbell_test;

namespace {

Request request(long first, long last) {
    Request result;
    result.first = first;
    result.last = last;
    return result;
}

}  // namespace

TEST_CASE("Cover and witness confirm both sides of critical ratios, without theorem 2") {
    for (const char* distance : {"0.01", "1e-9", "1e-20"}) {
        for (const long n : {4L, 5L, 8L, 12L}) {
            CAPTURE(distance, n);
            const Ratio ratio = *enclose_ratio(n, {.digits = 30});
            const Piece below = prove_single(ratio.q_lo * (1 - at(distance)), {}).piece;
            const Piece above = prove_single(ratio.q_hi * (1 + at(distance)), {}).piece;
            CHECK(below.upper == n - 1);
            CHECK(below.lower == n - 1);
            CHECK(above.upper == n);
            CHECK(above.lower == n);
        }
    }
}

TEST_CASE("A range has its ratios in order, the same with any number of threads") {
    Request one = request(3, 40);
    one.digits = 20;
    struct Told : Observer {
        void update(std::size_t, std::size_t total, std::optional<long> n) override {
            seen += total == 38 && n >= 3 && n <= 40 ? 1 : 100;
        }
        std::atomic<std::size_t> seen = 0;
    } told;
    one.observer = &told;
    Request two = one;
    two.jobs = 2;
    const auto rows = enclose_ratios(one);
    const auto again = enclose_ratios(two);
    CHECK(told.seen == 76);
    REQUIRE(rows.size() == 38);
    REQUIRE(again.size() == 38);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CAPTURE(i);
        REQUIRE(rows[i].n == static_cast<long>(i) + 3);
        REQUIRE(rows[i].ratio);
        REQUIRE(rows[i].ratio->n == rows[i].n);
        REQUIRE(rows[i].ratio->q_lo == again[i].ratio->q_lo);
        REQUIRE(rows[i].ratio->q_hi == again[i].ratio->q_hi);
        REQUIRE(rows[i].ratio->bits == again[i].ratio->bits);
    }
}

TEST_CASE("What is not done within the budget stays open") {
    Request hasty = request(3, 20);
    hasty.budget = std::chrono::duration<double>(0);
    for (const Row& row : enclose_ratios(hasty)) {
        CHECK(row.n >= 3);
        CHECK_FALSE(row.ratio);
    }
}
