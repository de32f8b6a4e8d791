#include "collisions/certify.hpp"

#include <atomic>

#include "catch.hpp"
#include "critical_ratio.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;

namespace {

std::vector<ProvedPiece> certified(const Rational& lo, const Rational& hi, int jobs = 2) {
    CertifyRequest request;
    request.claim.range.lo = lo;
    request.claim.range.hi = hi;
    request.jobs = jobs;
    return certify(request);
}

ProvedPiece proved(const Rational& lo, const Rational& hi, std::optional<long> upper, long lower) {
    ProvedPiece result;
    result.piece.q_lo = lo;
    result.piece.q_hi = hi;
    result.piece.upper = upper;
    result.piece.lower = lower;
    return result;
}

}  // namespace

TEST_CASE("single ratios get the number of the recomputation in 80 digits") {
    std::vector<Rational> ratios{1};
    for (const char* text : {"1.0000001", "1.000000000001", "1.1", "4.6", "4.61", "4.7", "10", "11.36", "12",
                             "25", "100", "1000", "1e4", "1e6", "22/7", "355/113"}) {
        ratios.push_back(at(text));
    }
    Random choices(31);
    for (int i = 0; i < 60; ++i) {
        ratios.push_back(exact(choices.log_uniform(1, choices.coin() ? 30 : 2000)));
    }
    for (const Rational& q : ratios) {
        CAPTURE(q);
        const auto pieces = certified(q, q);
        REQUIRE(pieces.size() == 1);
        const long n = q == 1 ? 2 : reference_maximum(q);
        CHECK(pieces.front().piece.upper == n);
        CHECK(pieces.front().piece.lower == n);
        CHECK(undecided_share(pieces) == 0);
    }
}

TEST_CASE("ranges that begin, end or lie inside a neighbourhood of a critical ratio leave nothing open") {
    for (const long n : {4L, 5L, 6L, 11L}) {
        for (const char* distance : {"1e-6", "1e-9"}) {
            const Rational c = critical_ratio(n);
            const Rational d = at(distance);
            CAPTURE(n, distance);
            for (const auto& [lo, hi] :
                 {std::pair(c * (1 - d), c * at("1.01")), std::pair(c * (1 + d), c * at("1.01")),
                  std::pair(c * at("0.99"), c * (1 + d)), std::pair(c * at("0.99"), c * (1 - d)),
                  std::pair(c * (1 - d), c * (1 + d)), std::pair(c * (1 + d), c * (1 + 2 * d)),
                  std::pair(c * (1 - 2 * d), c * (1 - d))}) {
                for (const ProvedPiece& p : certified(lo, hi)) {
                    CAPTURE(p.piece.q_lo, p.piece.q_hi);
                    CHECK(p.piece.status() != Status::open);
                }
            }
        }
    }
}

TEST_CASE("without any time every piece is left open, and the pieces still tile the range") {
    CertifyRequest request;
    request.claim.range.lo = 1;
    request.claim.range.hi = 30;
    request.budget = std::chrono::duration<double>(0);
    const auto pieces = certify(request);
    CHECK(pieces.front().piece.q_lo == 1);
    CHECK(pieces.back().piece.q_hi == 30);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        CHECK(pieces[i].piece.status() == Status::open);
        CHECK(pieces[i].piece.lower == 0);
        CHECK((i == 0 || pieces[i].piece.q_lo == pieces[i - 1].piece.q_hi));
    }
    CHECK(undecided_share(pieces) == 1);
    request.claim.range = {10, 10};
    CHECK(certify(request).front().piece.status() == Status::open);
    CHECK(undecided_share(certify(request)) == 1);
}

TEST_CASE("ratios beyond those that are tried are left open at once") {
    const Rational huge = at("1e300");
    const auto pieces = certified(huge, huge);
    REQUIRE(pieces.size() == 1);
    CHECK(pieces.front().piece.status() == Status::open);
    CHECK(undecided_share(pieces) == 1);
    CHECK(certified(10, huge).size() == 1);
}

TEST_CASE("pieces and gaps high up are decided, on both sides of a step") {
    using Range = std::tuple<const char*, const char*, long>;
    for (const auto& [lo, hi, n] :
         steps<Range>({{"1e12", "1000003000000", 885'597}}, {{"1e18", "1000000002e9", 885'595'131}})) {
        CAPTURE(lo);
        const auto pieces = certified(at(lo), at(hi));
        REQUIRE(pieces.size() == 3);
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(pieces[i].piece.lower == n + (i == 2 ? 1 : 0));
            CHECK(pieces[i].piece.upper == n + (i > 0 ? 1 : 0));
        }
        CHECK(undecided_share(pieces) < Rational(1, 500));
    }
}

TEST_CASE("progress is reported once per piece and ends complete") {
    struct Told : Observer {
        void enter(std::string_view phase, std::string_view) override { proving = phase == "proving"; }
        void update(std::size_t done, std::size_t all, std::optional<long> n) override {
            if (!proving) {
                return;  // still looking for steps
            }
            in_range = in_range && n >= 2 && n <= 11;
            ++calls;
            total = all;
            for (std::size_t seen = most; done > seen && !most.compare_exchange_weak(seen, done);) {
            }
        }
        std::atomic<std::size_t> calls = 0;
        std::atomic<std::size_t> most = 0;
        std::atomic<std::size_t> total = 0;
        std::atomic<bool> in_range = true;
        std::atomic<bool> proving = false;
    } told;
    CertifyRequest request;
    request.claim.range.lo = 1;
    request.claim.range.hi = 100;
    request.jobs = 2;
    request.observer = &told;
    const auto pieces = certify(request);
    CHECK(told.calls == pieces.size());
    CHECK(told.most == pieces.size());
    CHECK(told.total == pieces.size());
    CHECK(told.in_range);
}

TEST_CASE("the undecided share is the exact share of the pieces that are not exact") {
    CHECK(undecided_share({proved(1, 2, 3, 3), proved(2, 5, 4, 3)}) == Rational(3, 4));
    CHECK(undecided_share({proved(1, 2, 3, 3), proved(2, 4, 4, 3)}) == Rational(2, 3));
    CHECK(undecided_share({proved(1, 2, 3, 3), proved(2, 3, 4, 4)}) == 0);
    CHECK(undecided_share({proved(1, 2, std::nullopt, 3)}) == 1);
    CHECK(undecided_share({proved(10, 10, 4, 4)}) == 0);
    CHECK(undecided_share({proved(10, 10, 5, 4)}) == 1);
    const Rational nearly = 1 + at("1e-300");
    CHECK(undecided_share({proved(1, nearly, 3, 2), proved(nearly, 2, 3, 3)}) == at("1e-300"));
}
