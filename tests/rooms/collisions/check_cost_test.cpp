#include "collisions/check_cost.hpp"

#include <catch2/catch.hpp>
#include <string>

using namespace dumbbell;
using namespace dumbbell::collisions;

namespace {

/// A piece as `certify RATIO` writes it where an orbit has 1 + 2 `half` collisions.
Piece single(long half, int bits = 53) {
    Piece piece;
    piece.bits = bits;
    piece.upper = piece.lower = 1 + 2 * half;
    const Node count{std::nullopt, {Reason::count, half, half}};
    piece.cover.charts = {{Chart::bridge, {count}}, {Chart::light, {count}}};
    piece.witness = Witness{1, 1, half, half, Chart::bridge};
    return piece;
}
std::string option_of(const Piece& piece, Section section = Section::turning) {
    const Piece* const pieces[] = {&piece};
    return budget_option(check_seconds(pieces, section)).value();
}

}  // namespace

TEST_CASE("the check of one ratio needs no budget in double, and one with many bits") {
    CHECK(option_of(single(442'798)).empty());             // 10^12
    CHECK(option_of(single(442'797'564'726)).empty());     // 10^24
    CHECK(option_of(single(442'798, 128)).empty());        // macro steps
    CHECK_FALSE(option_of(single(19'000, 2048)).empty());  // more bits cost more
    CHECK_FALSE(option_of(single(442'798, 2048)).empty());
}

TEST_CASE("macro steps cost the verifier no more than is said") {
    struct Measured {
        long half;
        int bits;
        double
            seconds;  ///< `work` of dumbbell-verify --json, with --precision where a file has double's bits
    };
    for (const auto& [half, bits, seconds] :
         {Measured{442'798, 53, 0.042}, Measured{442'798, 512, 0.865}, Measured{442'797'564'726, 53, 0.262},
          Measured{442'797'564'726, 256, 0.515}, Measured{442'797'564'726, 512, 1.568},
          Measured{442'797'564'726'356'956, 256, 1.317}, Measured{442'797'564'726'356'956, 512, 3.283}}) {
        const Piece piece = single(half, bits);
        const Piece* const pieces[] = {&piece};
        CAPTURE(half, bits);
        CHECK(check_seconds(pieces, Section::turning) > 2 * seconds);
    }
}

TEST_CASE("a budget is named from the verifier's own on, and never less than the cost") {
    CHECK(budget_option(30) == "");
    CHECK(budget_option(30.1) == "--budget 1m ");
    CHECK(budget_option(3600) == "--budget 1h ");
    CHECK(budget_option(3601) == "--budget 4h ");
    CHECK(budget_option(99999 * 3600.) == "--budget 99999h ");
    CHECK_FALSE(budget_option(99999 * 3600. + 1));
    CHECK_FALSE(budget_option(1e12));
}
