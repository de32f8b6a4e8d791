#include "staircase/law.hpp"

#include <catch2/catch.hpp>

#include "collisions/certify.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell::staircase;

namespace {

Piece piece(const char* lo, const char* hi, long upper, long lower) {
    Piece result;
    result.q_lo = parse_rational(lo);
    result.q_hi = parse_rational(hi);
    result.upper = upper;
    result.lower = lower;
    return result;
}

Law law_of_pieces(std::vector<Piece> pieces) {
    const PrecisionScope scope(200);
    return law_of(Certificate{{"test", "1"}, std::move(pieces)});
}

/// The true staircase from 1 to 12.
std::vector<Piece> true_staircase() {
    return {piece("1", "1", 2, 2),      piece("1", "1.001", 3, 2),    piece("1.001", "4.6", 3, 3),
            piece("4.6", "4.61", 4, 3), piece("4.61", "11.36", 4, 4), piece("11.36", "11.37", 5, 4),
            piece("11.37", "12", 5, 5)};
}

}  // namespace

TEST_CASE("the law of a true staircase") {
    const Law law = law_of_pieces(true_staircase());
    CHECK(law.complete);
    CHECK(law.never_decreases);
    CHECK(law.below_paper);
    CHECK(law.values == 4);
    CHECK(law.gaps == 3);
    CHECK((law.first.lower == 2 && law.first.upper == 2));
    CHECK((law.last.lower == 5 && law.last.upper == 5));
    // 3 just above 1, and 4 just below 11.37 (or at 11.36): by hand.
    CHECK(law.sup->inner.lo() == Approx(3 - 0.8855951294527139 * std::sqrt(1.001)).epsilon(1e-14));
    CHECK(law.sup->outer.hi() == Approx(3 - 0.8855951294527139).epsilon(1e-14));
    CHECK(law.sup->at == parse_rational("1.001"));
    CHECK(law.inf->inner.hi() == Approx(4 - 0.8855951294527139 * std::sqrt(11.36)).epsilon(1e-14));
    CHECK(law.inf->outer.lo() == Approx(4 - 0.8855951294527139 * std::sqrt(11.37)).epsilon(1e-14));
}

TEST_CASE("a staircase that goes down is seen, wherever it does") {
    auto down = true_staircase();
    down[4] = piece("4.61", "11.36", 2, 2);
    CHECK_FALSE(law_of_pieces(down).never_decreases);
    auto gap_too_high = true_staircase();
    gap_too_high[5] = piece("11.36", "11.37", 6, 5);
    CHECK_FALSE(law_of_pieces(gap_too_high).never_decreases);
    auto gap_too_low = true_staircase();
    gap_too_low[5] = piece("11.36", "11.37", 4, 3);
    CHECK_FALSE(law_of_pieces(gap_too_low).never_decreases);
    // Of two gaps side by side the first may have its upper value, the second its lower one.
    CHECK_FALSE(law_of_pieces({piece("4.6", "4.61", 4, 3), piece("4.61", "4.62", 4, 3)}).never_decreases);
}

TEST_CASE("a value above ceil(pi/gamma) is seen, also where it is too high at the lower end only") {
    auto high = true_staircase();
    high[2] = piece("1.001", "4.6", 4, 4);
    CHECK_FALSE(law_of_pieces(high).below_paper);
    // ceil(pi/gamma) = 2 at q = 1 alone.
    CHECK_FALSE(law_of_pieces({piece("1", "1.001", 3, 2), piece("1.001", "2", 3, 3)}).below_paper);
    CHECK_FALSE(law_of_pieces({piece("1", "1", 3, 2), piece("1", "2", 3, 3)}).below_paper);
    // and 3 at q = 3, 4 after it.
    CHECK(law_of_pieces({piece("2", "3", 3, 3), piece("3", "4", 4, 4)}).below_paper);
    CHECK_FALSE(law_of_pieces({piece("3", "4", 4, 4)}).below_paper);
}

TEST_CASE("with an open piece nothing is said") {
    auto open = true_staircase();
    open[3].upper.reset();
    const Law law = law_of_pieces(open);
    CHECK_FALSE(law.complete);
    CHECK_FALSE(law.never_decreases);
    CHECK_FALSE(law.sup.has_value());
}

TEST_CASE("the law of a proved staircase holds") {
    CertifyRequest request;
    request.q_lo = 1;
    request.q_hi = 1000;
    std::vector<Piece> pieces;
    for (const ProvedPiece& proved : certify(request)) {
        pieces.push_back(proved.piece);
    }
    const Law law = law_of_pieces(pieces);
    CHECK(law.complete);
    CHECK(law.never_decreases);
    CHECK(law.below_paper);
    CHECK(law.last.upper == 29);
}

TEST_CASE("whether the supremum is attained is said only where the pieces tell") {
    const auto attained = [](std::vector<Piece> pieces) {
        return law_of_pieces(std::move(pieces)).sup->attained;
    };
    CHECK(attained(true_staircase()) == false);
    // No step in the range: N - C sqrt q falls.
    CHECK(attained({piece("5", "6", 4, 4)}) == true);
    CHECK(attained({piece("5", "6", 4, 4), piece("6", "7", 4, 4)}) == true);
    // A step at the end of a range whose value at the lowest ratio is greater: in the gap N may be 4 at once.
    CHECK(attained({piece("2", "4.6", 3, 3), piece("4.6", "4.7", 4, 3)}) == std::nullopt);
    CHECK(attained({piece("2", "4.6", 3, 3), piece("4.6", "4.61", 4, 3), piece("4.61", "5", 4, 4)}) == false);
    CHECK(attained({piece("1.001", "4.5", 3, 3), piece("4.5", "5", 4, 3)}) == std::nullopt);
    // Even 5 in that gap would be less: 5 - C sqrt 11.36 < 4 - C sqrt 4.61.
    CHECK(attained({piece("4.61", "11.36", 4, 4), piece("11.36", "11.37", 5, 4)}) == true);
    // It begins in a gap, and what is approached after it may be the value at the lowest ratio.
    CHECK(attained({piece("4.6", "4.61", 4, 3), piece("4.61", "5", 4, 4)}) == std::nullopt);
    CHECK_FALSE(law_of_pieces({piece("5", "7", 5, 4)}).sup.has_value());
}
