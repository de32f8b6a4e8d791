#include <sstream>

#include "catch.hpp"
#include "rooms/parsed.hpp"
#include "sample_report.hpp"

using namespace dumbbell_test;
using namespace dumbbell::collisions;

namespace {

// The words of the line that begins with `start`.
std::vector<std::string> line_of(const std::string& text, const std::string& start) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(start)) {
            std::istringstream words(line);
            return {std::istream_iterator<std::string>(words), {}};
        }
    }
    return {};
}

using Words = std::vector<std::string>;

}  // namespace

TEST_CASE("the table of a single ratio: ratio, N, the paper's bound, boxes, time") {
    const SampleReport ten({piece(10, 10, 4, 4)});
    const std::string text = to_text(ten.report);
    CHECK(line_of(text, "mass ratio") == Words{"mass", "ratio", "N", "paper", "boxes", "time"});
    CHECK(line_of(text, "10 ") == Words{"10", "4", "7", "2", "0.500", "s"});
    CHECK_THAT(text, Contains("N: the greatest number of collisions; paper: ") && !Contains("piece"));
}

TEST_CASE("a sentence before the table says what was proved") {
    const SampleReport ten({piece(10, 10, 4, 4)});
    CHECK_THAT(to_text(ten.report),
               StartsWith("Proved: at mass ratio 10 no trajectory hits the floor more than 4 times, "
                          "and some trajectory hits it 4 times.\n"));
}

TEST_CASE("where no box was needed the table names the lemma") {
    Piece one = piece(1, 1, 2, 2);
    one.cover = {.equal_masses = true, .charts = {}};
    CHECK(line_of(to_text(SampleReport({one}).report), "1 ") ==
          Words{"1", "2", "3", "by", "L7", "0.500", "s"});
}

TEST_CASE("a single ratio that was not decided is not called proved") {
    const SampleReport open({open_piece(10, 10)});
    const std::string text = to_text(open.report);
    CHECK_THAT(text, Contains("Not decided"));
    CHECK_THAT(text, !Contains("Proved"));
    const SampleReport half({piece(10, 10, 5, 4)});
    CHECK_THAT(to_text(half.report), Contains("Not decided") && Contains("at least 4"));
}

TEST_CASE("the table of a range has a line per piece, gaps with both values, open ones marked") {
    const SampleReport sample(four_pieces());
    const std::string text = to_text(sample.report);
    CHECK(line_of(text, "4 :") == Words{"4", ":", "4.6033367", "3", "5", "2", "0.500", "s"});
    CHECK(line_of(text, "4.6033367 :") ==
          Words{"4.6033367", ":", "4.603341", "3", "or", "4", "5", "2", "0.500", "s"});
    CHECK(line_of(text, "5 : 12") == Words{"5", ":", "12", "open", "5-7", "0", "0.500", "s"});
    CHECK_THAT(text, Contains("4 pieces in 1.25 s"));
}

TEST_CASE("the sentence of a range says how much of it is decided") {
    const SampleReport sample(four_pieces());
    const std::string text = to_text(sample.report);
    CHECK_THAT(text, Contains("Decided: all but 0.25 of the range"));
    CHECK_THAT(text, Contains("open"));
    CHECK_THAT(text, Contains("no trajectory hits the floor more than N times"));
    SampleReport decided({piece(5, 11, 4, 4)});
    decided.report.undecided = 0;
    CHECK_THAT(to_text(decided.report), !Contains("gap") && !Contains("open") &&
                                            Contains("in the piece with one value N = 4") &&
                                            Contains("Decided: the whole range."));
    decided.report.undecided = exact(0x1p-40);
    CHECK_THAT(to_text(decided.report), Contains("Decided: all but 9.1e-13 of the range."));
    decided.report.undecided = parse_rational("4.999e-40");
    CHECK_THAT(to_text(decided.report), Contains("Decided: all but 5e-40 of the range."));
    CHECK(parsed(to_json(decided.report))["decided_fraction"] < 1);
    CHECK(parsed(to_json(decided.report))["undecided_share"] == to_fraction(parse_rational("4.999e-40")));
    decided.report.undecided = Rational(8, 9);
    CHECK_THAT(to_text(decided.report), Contains("Decided: 0.111 of the range."));
    decided.report.undecided = 1;  // all of it, but for pieces of length 0, as 1:1 is
    CHECK_THAT(to_text(decided.report), Contains("Decided: single ratios only."));
}

TEST_CASE("the sentence of a range names the values, so that it can stand alone") {
    const SampleReport two({piece(5, 11, 4, 4), piece(11, 12, 5, 5)});
    CHECK_THAT(verdict(two.report), Contains("in each of the 2 pieces with one value N, from 4 to 5, and"));
    const SampleReport same({piece(5, 11, 4, 4), piece(11, 12, 4, 4)});
    CHECK_THAT(verdict(same.report), Contains("in each of the 2 pieces with one value N = 4, and"));
}

TEST_CASE("where nothing was decided nothing is called proved") {
    SampleReport range({open_piece(5, 11)});
    range.report.undecided = 1;
    CHECK_THAT(
        to_text(range.report),
        !Contains("Proved") && Contains("Not decided. 1 piece is open. Decided: nothing of the range."));
    const SampleReport single({open_piece(5, 5)});
    CHECK_THAT(to_text(single.report), !Contains("Proved") && Contains("at mass ratio 5 nothing is proved"));
}

TEST_CASE("ratios are printed exactly, so that no two of them look alike") {
    const Rational near_one = parse_rational("1.000000000000000000000000000000000000000000000000001");
    const SampleReport single({piece(near_one, near_one, 3, 3)});
    CHECK_THAT(to_text(single.report),
               Contains("at mass ratio 1.000000000000000000000000000000000000000000000000001 no"));
    CHECK_FALSE(
        line_of(to_text(single.report), "1.000000000000000000000000000000000000000000000000001 ").empty());

    const Rational left = parse_rational("4.60333884875170035");
    const Rational right = parse_rational("4.60333884875170036");
    const SampleReport range(
        {piece(Rational(13, 3), left, 3, 3), piece(left, right, 4, 3), piece(right, 5, 4, 4)});
    const std::string text = to_text(range.report);
    CHECK_THAT(text, Contains("13/3 : 4.60333884875170035 ") &&
                         Contains("4.60333884875170035 : 4.60333884875170036 ") &&
                         Contains("4.60333884875170036 : 5 "));
}

TEST_CASE("a proof of the full section says that the heavy mass hits the floor at most once") {
    SampleReport full({piece(5, 11, 4, 4)});
    CHECK_THAT(to_text(full.report), !Contains("heavy mass"));
    full.report.claim.system.section = Section::full;
    CHECK_THAT(to_text(full.report), Contains("the heavy mass hits the floor at most once"));
    CHECK(parsed(to_json(full.report))["heavy_at_most_once"] == true);
    full.report.claim.system.section = Section::turning;
    CHECK(parsed(to_json(full.report))["heavy_at_most_once"].is_null());
    SampleReport open({piece(5, 11, 4, 4), open_piece(11, 12)});
    open.report.claim.system.section = Section::full;
    CHECK(parsed(to_json(open.report))["heavy_at_most_once"].is_null());
}

TEST_CASE("a written certificate is named with its checksum and the command that checks it") {
    SampleReport ten({piece(10, 10, 4, 4)});
    CHECK_THAT(to_text(ten.report), !Contains("verify"));
    ten.report.out = "ten.dbc";
    ten.report.sha256 = std::string(64, 'a');
    CHECK_THAT(to_text(ten.report), Contains("ten.dbc (sha256 " + std::string(64, 'a') + ")") &&
                                        Contains("dumbbell verify --ratio 10 --exactly 4 ten.dbc\n"));
}

TEST_CASE("the JSON object has the contract's fields") {
    SampleReport sample(four_pieces());
    sample.report.out = "stairs.dbc";
    sample.report.sha256 = std::string(64, 'b');
    const auto json = parsed(to_json(sample.report));
    CHECK(json.at("schema").is_string());
    CHECK(json.at("scene") == "dumbbell");
    CHECK(json.at("section") == "turning");
    CHECK(json.at("ratio").at("lo") == "4/1");
    CHECK(json.at("ratio").at("hi") == "12/1");
    CHECK(json.at("gap") == "1/1000000");
    CHECK(json.at("jobs") == 2);
    CHECK(json.at("decided_fraction") == 0.75);
    CHECK(json.at("undecided_share") == "1/4");
    CHECK(json.at("seconds") == 1.25);
    CHECK(json.at("out") == "stairs.dbc");
    CHECK(json.at("sha256") == std::string(64, 'b'));
    REQUIRE(json.at("pieces").size() == 4);
}

TEST_CASE(
    "a piece in JSON: exact rationals, both bounds, status, the paper's bound, leaves, bits, margin, width") {
    const SampleReport sample(four_pieces());
    const auto pieces = parsed(to_json(sample.report)).at("pieces");
    const auto& gap = pieces.at(1);
    CHECK(gap.at("lo") == "46033367/10000000");
    CHECK(gap.at("hi") == "4603341/1000000");
    CHECK(gap.at("upper") == 4);
    CHECK(gap.at("lower") == 3);
    CHECK(gap.at("status") == "gap");
    CHECK(gap.at("paper_bound") == 5);
    CHECK(gap.at("leaves") == 2);
    CHECK(gap.at("bits") == 53);
    CHECK(gap.at("margin") == 0.125);
    CHECK(gap.at("width") == 1e-9);
    CHECK(pieces.at(0).at("status") == "exact");
    CHECK(pieces.at(3).at("status") == "open");
    CHECK(pieces.at(3).at("upper").is_null());
    CHECK(pieces.at(3).at("lower") == 0);
    CHECK(pieces.at(3).at("paper_bound") == 7);
}

TEST_CASE("in JSON margin and width are null where no witness orbit is known") {
    SampleReport sample(four_pieces());
    sample.report.rows[3].margin = sample.report.rows[3].width = 0;
    const auto pieces = parsed(to_json(sample.report)).at("pieces");
    CHECK(pieces.at(0).at("margin") == 0.125);
    CHECK(pieces.at(3).at("margin").is_null());
    CHECK(pieces.at(3).at("width").is_null());
}

TEST_CASE("without a file out and sha256 are null, without an orbit there is no witness") {
    const SampleReport ten({piece(10, 10, 4, 4)});
    const auto json = parsed(to_json(ten.report));
    CHECK(json.at("out").is_null());
    CHECK(json.at("sha256").is_null());
    CHECK_FALSE(json.at("pieces").at(0).contains("witness"));
}
