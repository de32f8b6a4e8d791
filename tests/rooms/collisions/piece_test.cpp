#include "collisions/piece.hpp"

#include <ctime>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "collisions/piece_lines.hpp"
#include "collisions/section.hpp"
#include "collisions/step_guess.hpp"
#include "critical_ratio.hpp"
#include "number/parallel.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;

TEST_CASE("a single ratio is decided: upper and lower bound are the recomputed maximum") {
    for (const char* text :
         {"1.0000001", "1.000000000001", "1.1", "9/2", "4.61", "10", "12", "100", "1000", "1e6"}) {
        CAPTURE(text);
        const Rational q = parse_rational(text);
        const ProvedPiece proved = prove_single(q, {});
        CHECK(proved.piece.status() == Status::exact);
        CHECK(proved.piece.upper == reference_maximum(q));
        CHECK(proved.piece.lower == reference_maximum(q));
        CHECK(proved.piece.bits == 53);
        REQUIRE(proved.piece.witness.has_value());
        CHECK(proved.piece.witness->total() >= proved.piece.lower);
        CHECK(proved.margin > 0);
        CHECK(proved.width > 0);
        CHECK(proved.width < 1e-6);
    }
}

TEST_CASE("equal masses end with two, by lemma L7 and a witness") {
    const ProvedPiece proved = prove_single(1, {});
    CHECK(proved.piece.status() == Status::exact);
    CHECK(proved.piece.upper == 2L);
    CHECK(proved.piece.cover.equal_masses);
    CHECK(proved.piece.cover.leaves() == 0);
    REQUIRE(proved.piece.witness.has_value());
    CHECK(bridge_counts(proved.piece.witness->e, proved.piece.witness->eta, 1).forward +
              bridge_counts(proved.piece.witness->e, proved.piece.witness->eta, 1).backward ==
          1);
}

TEST_CASE("ratios are decided at every distance from a critical one that a certificate can spell") {
    const FineStep five = *find_step(5, 1060);
    for (const char* distance : {"1e-90", "1e-119", "1e-150", "1e-190", "1e-300"}) {
        CAPTURE(distance);
        const ProvedPiece above = prove_single(five.above * (1 + parse_rational(distance)), {});
        CHECK(above.piece.upper == 5L);
        CHECK(above.piece.lower == 5);
        CHECK(above.obstacle == Obstacle::none);
        const ProvedPiece below = prove_single(five.below * (1 - parse_rational(distance)), {});
        CHECK(below.piece.upper == 4L);
        CHECK(below.piece.lower == 4);
    }
    const ProvedPiece near_one = prove_single(1 + parse_rational("1e-401"), {});
    CHECK(near_one.piece.upper == 3L);
    CHECK(near_one.piece.lower == 3);
    CHECK(near_one.piece.bits == 2080);
}

TEST_CASE("where threads share the counts of a piece it is the same with any number of them") {
    const Rational q =
        scaled(1) >= 20 ? parse_rational("1e28") : find_step(887, 440)->above * (1 + parse_rational("1e-14"));
    const auto proved_with = [&](int threads) {
        const Piece piece = with_threads(threads, [&] { return prove_single(q, {.parallel = true}).piece; });
        CHECK(piece.status() == Status::exact);
        CHECK(piece.bits > 53);
        PieceLines lines;
        lines.proof(piece);
        return std::move(lines).sealed().text;
    };
    const std::string alone = proved_with(1);
    for (const int threads : {2, 8}) {
        CHECK(proved_with(threads) == alone);
    }
}

TEST_CASE("an open piece says what was in the way") {
    const Rational near = critical_ratio(5) * (1 + parse_rational("1e-45"));
    CHECK(prove_single(near, {.max_bits = 53}).obstacle == Obstacle::maximum);
    CHECK(prove_single(near, {.interrupted = [] { return true; }}).obstacle == Obstacle::time);
    CHECK(prove_piece(5, 11, 5, 5, {.max_bits = 53}).obstacle == Obstacle::witness);
    CHECK(prove_piece(5, 11, 3, 3, {.max_bits = 53}).obstacle == Obstacle::boxes);
    CHECK(prove_piece(5, 11, 4, 4, {}).obstacle == Obstacle::none);
}

TEST_CASE("false claims about a range stay open") {
    const PieceOptions cheap{.max_bits = 53};
    CHECK(prove_piece(5, 11, 3, 3, cheap).piece.status() == Status::open);   // the maximum is 4
    CHECK(prove_piece(5, 11, 5, 5, cheap).piece.status() == Status::open);   // 5 do not occur
    CHECK(prove_piece(5, 12, 4, 4, cheap).piece.status() == Status::open);   // straddles q_c(5)
    CHECK(prove_piece(11, 12, 5, 5, cheap).piece.status() == Status::open);  // straddles q_c(5)
    CHECK_FALSE(prove_piece(5, 12, 4, 4, cheap).piece.upper.has_value());
}

TEST_CASE(
    "ends close to critical ratios are proved at the first precision that tells them, without boxes in "
    "vain") {
    struct Boxes : Observer {
        std::size_t judged = 0;
        void advance(std::size_t more) override { judged += more; }
    };
    const std::vector<std::tuple<long, const char*, int>> ends{
        {5, "1e-30", 160}, {5, "1e-120", 544}, {887, "1e-14", 160}};
    for (const auto& [n, distance, bits] : ends) {
        CAPTURE(n, distance);
        const Rational rel = parse_rational(distance);
        const Rational lo = find_step(n, 440)->above * (1 + rel);
        const Rational hi = find_step(n + 1, 440)->below * (1 - rel);
        Boxes boxes;
        const ProvedPiece proved = prove_piece(lo, hi, n, n, {.observer = &boxes});
        CHECK(proved.piece.status() == Status::exact);
        CHECK(proved.piece.bits == bits);
        CHECK(boxes.judged == 2);  // one for each chart
    }
}

TEST_CASE("what fails only above keeps its proved lower bound") {
    const ProvedPiece proved = prove_piece(5, 12, 4, 4, {.max_bits = 53});
    CHECK(proved.piece.lower == 4);
    CHECK(proved.piece.witness.has_value());
}

TEST_CASE("an interrupted piece ends soon, in the middle of an orbit of many million collisions too") {
    for (const Section section : {Section::turning, Section::full, Section::plain}) {
        // By macro steps an orbit takes much less than its number of collisions.
        const bool short_orbits = section == Section::turning;
        const std::clock_t start = std::clock();  // of the processor: the machine may be busy
        const auto seconds = [&] { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; };
        const auto late = [&] { return seconds() > 0.08; };
        const ProvedPiece proved =
            prove_single(exact(short_orbits ? 1e100 : 1e14), {.system = {section}, .interrupted = late});
        CHECK(proved.piece.status() == Status::open);
        CHECK(proved.obstacle == Obstacle::time);
        CHECK(seconds() < 10);
    }
}

TEST_CASE("a step is decided at a relative distance of 1e-20") {
    // Near 10^18, at the digits of `critical 885595132 --digits 20`.
    const long n = 885'595'132;
    const PieceOptions options = piece_options({});
    const Piece above = prove_single(at("1000000001235988269.0026"), options).piece;
    CHECK((above.lower == n && above.upper == n));
    if (scaled(1) >= 20) {
        const Piece below = prove_single(at("1000000001235988268.9825"), options).piece;
        CHECK((below.lower == n - 1 && below.upper == n - 1));
    }
}
