#include "staircase/critical_range.hpp"

#include <atomic>
#include <catch2/catch.hpp>

#include "collisions/critical_guess.hpp"
#include "rooms/collisions/critical_ratio.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell::staircase;
using namespace dumbbell_test;

namespace {

CriticalRatio enclosed(long n, int digits) { return *enclose_critical_ratio(n, {.digits = digits}); }

CriticalRequest request(long first, long last) {
    CriticalRequest result;
    result.first = first;
    result.last = last;
    return result;
}

}  // namespace

TEST_CASE("Cover and witness confirm both sides of critical ratios, without theorem 2") {
    for (const char* distance : {"0.01", "1e-9", "1e-20"}) {
        for (const long n : {3L, 4L, 5L, 8L, 12L}) {
            CAPTURE(distance, n);
            const Rational rel = at(distance);
            const CriticalRatio ratio = enclosed(n, std::max(15, digits_to_confirm(rel)));
            const Confirmation confirmation = confirm(ratio, rel, never);
            CHECK(confirmation.holds());
            CHECK(confirmation.below.upper == n - 1);
            CHECK(confirmation.below.lower == n - 1);
            CHECK(confirmation.above.upper == n);
            CHECK(confirmation.above.lower == n);
            const auto farthest = rel * Rational(102, 100);
            CHECK(confirmation.above.q >= ratio.q_hi * (1 + rel));
            CHECK(confirmation.above.q <= ratio.q_lo * (1 + farthest));
            if (n == 3) {
                CHECK(confirmation.below.q == 1);
            } else {
                CHECK(confirmation.below.q <= ratio.q_lo * (1 - rel));
                CHECK(confirmation.below.q >= ratio.q_hi * (1 - farthest));
            }
        }
    }
}

TEST_CASE("A wrong critical ratio is not confirmed, nor one for which there was no time") {
    for (const char* wrong : {"0.999999", "1.000001"}) {
        CriticalRatio ratio = enclosed(6, 15);
        ratio.q_lo *= at(wrong);
        ratio.q_hi *= at(wrong);
        CHECK_FALSE(confirm(ratio, at("1e-9"), never).holds());
    }
    CHECK_FALSE(confirm(enclosed(6, 15), at("1e-9"), [] { return true; }).holds());
}

TEST_CASE(
    "Neighbouring critical ratios are more than 1/n apart, relatively: the distance that can be confirmed") {
    for (long n = 4; n < 300; ++n) {
        CAPTURE(n);
        const double q = guess_critical_ratio(n);
        REQUIRE(guess_critical_ratio(n + 1) / q - 1 > 1.5 / static_cast<double>(n));
        REQUIRE(1 - guess_critical_ratio(n - 1) / q > 1.5 / static_cast<double>(n));
    }
}

TEST_CASE("A range has its ratios in order, the same with any number of threads") {
    CriticalRequest one = request(3, 40);
    one.digits = 20;
    struct Told : Observer {
        void update(std::size_t, std::size_t total, std::optional<long> n) override {
            seen += total == 38 && n >= 3 && n <= 40 ? 1 : 100;
        }
        std::atomic<std::size_t> seen = 0;
    } told;
    one.observer = &told;
    CriticalRequest two = one;
    two.jobs = 2;
    const auto rows = critical_ratios(one);
    const auto again = critical_ratios(two);
    CHECK(told.seen == 76);
    REQUIRE(rows.size() == 38);
    REQUIRE(again.size() == 38);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CAPTURE(i);
        REQUIRE(rows[i].n == static_cast<long>(i) + 3);
        REQUIRE(rows[i].finished(one));
        REQUIRE(rows[i].ratio->n == rows[i].n);
        REQUIRE(rows[i].ratio->q_lo == again[i].ratio->q_lo);
        REQUIRE(rows[i].ratio->q_hi == again[i].ratio->q_hi);
        REQUIRE(rows[i].ratio->bits == again[i].ratio->bits);
    }
}

TEST_CASE("Rows are finished only if confirmed, where that was asked for") {
    CriticalRequest asked = request(4, 6);
    asked.confirm = at("1e-6");
    for (const CriticalRow& row : critical_ratios(asked)) {
        CHECK(row.finished(asked));
        CHECK(row.confirmation->holds());
    }
    const auto without = critical_ratios(request(4, 4));
    CHECK_FALSE(without.front().finished(asked));
}

TEST_CASE("What is not done within the budget stays open") {
    CriticalRequest hasty = request(3, 20);
    hasty.budget = std::chrono::duration<double>(0);
    for (const CriticalRow& row : critical_ratios(hasty)) {
        CHECK(row.n >= 3);
        CHECK_FALSE(row.ratio);
        CHECK_FALSE(row.finished(hasty));
    }
}

TEST_CASE("The time is estimated from the number of flights") {
    using namespace std::chrono_literals;
    CHECK(estimated_time(request(4, 4)) < 10s);
    CHECK(estimated_time(request(1'000'000'000'000, 1'000'000'000'000)) < 10min);  // by macro steps
    CHECK(estimated_time(request(3, 1'000'000)) > 24h);
}

TEST_CASE("The first half of a range takes a quarter of the time, as orbits get longer") {
    CHECK(share_of_first(9'999, request(3, 20'000)) == Approx(0.25).margin(0.001));
    CHECK(share_of_first(1, request(3, 4)) == Approx(3.0 / 7));
    CHECK(share_of_first(18, request(3, 20)) == 1);
    CHECK(share_of_first(5, request(1'000'000, 1'000'009)) == Approx(0.5).margin(0.01));  // by macro steps
}
