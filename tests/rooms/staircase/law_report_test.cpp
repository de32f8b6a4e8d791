// What `law` says of staircases of every kind: each sentence must be true of each of them.
#include "staircase/law_report.hpp"

#include <catch2/catch.hpp>

#include "rooms/collisions/example.hpp"
#include "rooms/collisions/reference.hpp"
#include "rooms/parsed.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;
using Catch::Matchers::Contains;

namespace {

staircase::LawReport report_of(std::vector<Piece> pieces) {
    const PrecisionScope scope(230);
    return {.file = "stairs.dbc",
            .verdict = "s VERIFIED",
            .digits = 50,
            .law = staircase::law_of(Certificate{{"test", "1"}, std::move(pieces)})};
}

std::string text_of(std::vector<Piece> pieces) { return to_text(report_of(std::move(pieces))); }

}  // namespace

TEST_CASE("law: a range without a step has one value, and its supremum is attained at the lowest ratio") {
    const std::string text = text_of({piece(5, 6, 4, 4)});
    CHECK_THAT(text, Contains("N is 4 at q = 5 and 4 at q = 6: 1 piece with one value.\n") &&
                         Contains("The supremum is attained, at q = 5.\n") && !Contains("gaps") &&
                         !Contains("theorem 2"));
    CHECK(parsed(to_json(report_of({piece(5, 6, 4, 4)})))["sup"]["attained"] == true);
}

TEST_CASE("law: a supremum at a step is not attained") {
    const std::vector<Piece> stairs{piece(4, at("4.6"), 3, 3), piece(at("4.6"), at("4.61"), 4, 3),
                                    piece(at("4.61"), 7, 4, 4)};
    CHECK_THAT(
        text_of(stairs),
        Contains("N is 3 at q = 4 and 4 at q = 7: 2 pieces with one value, and 1 gap in which it is one of "
                 "two neighbouring values.\n") &&
            Contains("The supremum is not attained: it is the limit from above at a step"));
    CHECK(parsed(to_json(report_of(stairs)))["sup"]["attained"] == false);
}

TEST_CASE("law: where the range begins or ends in a gap, both of its values are said") {
    const std::vector<Piece> ends_in_gap{piece(at("4.5"), at("4.6"), 3, 3),
                                         piece(at("4.6"), at("4.604"), 4, 3)};
    CHECK_THAT(text_of(ends_in_gap),
               Contains("N is 3 at q = 4.5 and 3 or 4 at q = 4.604: 1 piece with one value") &&
                   Contains("Whether the supremum is attained is not decided"));
    CHECK(parsed(to_json(report_of(ends_in_gap)))["sup"]["attained"].is_null());
    CHECK_THAT(text_of({piece(at("4.603"), at("4.61"), 4, 3), piece(at("4.61"), 5, 4, 4)}),
               Contains("N is 3 or 4 at q = 4.603 and 4 at q = 5: "));
}

TEST_CASE("law: of a lone gap nothing is said that needs a piece with one value") {
    const std::string text = text_of({piece(5, 7, 5, 4)});
    CHECK_THAT(text, Contains("N is 4 or 5 at q = 5 and 4 or 5 at q = 7: 1 gap in which it is one of two") &&
                         !Contains("piece") && !Contains("upremum"));
    CHECK(parsed(to_json(report_of({piece(5, 7, 5, 4)})))["sup"].is_null());
}

TEST_CASE("law: with an open piece nothing is proved") {
    CHECK(verdict(report_of({piece(5, 6, 4, 4), open_piece(6, 7)})) ==
          "NOT proved: at least one piece of this staircase is open.\n");
}

TEST_CASE("law: the bounds, read as they are printed, hold: they are rounded outward, also below zero") {
    // By 50 digits of C: 2.01974909000100555..., 1.83074381414683649..., -1.42797564726356955...
    CHECK_THAT(
        text_of({piece(5, 6, 4, 4)}),
        Contains("in [2.0197490900010055, 2.0197490900010056]; the lower bound is its value at q = 5\n") &&
            Contains("in [1.8307438141468364, 1.8307438141468365]; the upper bound is its value at q = 6\n"));
    CHECK_THAT(text_of({piece(16, 25, 3, 3)}),
               Contains("Infimum  of N(q) - C sqrt q: in [-1.4279756472635696, "
                        "-1.4279756472635695]"));
}
