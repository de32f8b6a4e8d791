// The shipped table of critical ratios: complete, in order, and made again, byte for byte, row by row.
#include <algorithm>
#include <array>
#include <random>
#include <sstream>

#include "catch.hpp"
#include "collisions/reader.hpp"
#include "flight/paper_bound.hpp"
#include "programs/cli/process.hpp"

using namespace dumbbell_test;

namespace {

using Lines = std::vector<std::string>;

constexpr long first = 3;
constexpr long last = 902;

const Lines table = lines_of(contents(DUMBBELL_PROJECT "/certificates/critical-ratios.tsv"));

Lines made(const std::string& counts) {
    const TemporaryFolder folder;
    const Outcome result =
        run({DUMBBELL_BIN, "critical", counts, "--digits", "50", "--out", folder / "made.tsv"});
    CAPTURE(result.err);
    REQUIRE(result.code == 0);
    return lines_of(contents(folder / "made.tsv"));
}

Lines without_remarks(Lines lines) {
    lines.erase(
        std::remove_if(lines.begin(), lines.end(), [](const auto& line) { return line.starts_with('#'); }),
        lines.end());
    return lines;
}

constexpr std::array staircases{"stairs-1-100.dbc", "stairs-1-1e4.dbc.gz", "stairs-1-1e6.dbc.gz"};

dumbbell::collisions::Certificate staircase(const std::string& name) {
    return dumbbell::collisions::read_certificate(DUMBBELL_PROJECT "/certificates/" + name);
}

}  // namespace

TEST_CASE("the table of critical ratios has every N from 3 to 902, with 50 digits, increasing") {
    const Lines rows = without_remarks(table);
    REQUIRE(rows.size() == last - first + 1);
    long double previous = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::istringstream in(rows[i]);
        long n = 0;
        std::string ratio;
        in >> n >> ratio;
        CAPTURE(rows[i]);
        REQUIRE(n == first + static_cast<long>(i));
        REQUIRE((n == 3 || ratio.size() == 51));
        REQUIRE(std::stold(ratio) > previous);
        previous = std::stold(ratio);
    }
}

TEST_CASE("a sample of the table of critical ratios is made again, byte for byte") {
    const Lines rows = without_remarks(table);
    // The first rows with the remarks in front.
    const Lines beginning = made("3:40");
    REQUIRE(beginning.size() <= table.size());
    CHECK(std::equal(beginning.begin(), beginning.end(), table.begin()));
    std::mt19937_64 engine(2026);
    for (int i = 0; i < 12; ++i) {
        const auto n = first + static_cast<long>(engine() % (last - first + 1));
        CAPTURE(n);
        const Lines again = without_remarks(made(std::to_string(n)));
        REQUIRE(again.size() == 1);
        CHECK(again.front() == rows.at(static_cast<std::size_t>(n - first)));
    }
}

TEST_CASE("the covers and the two orbits of the theorem agree on [1, 10^6]") {
    // The staircases know nothing of the theorem, the table nothing of the covers.
    const Lines rows = without_remarks(table);
    for (const char* name : staircases) {
        const auto stairs = staircase(name);
        for (const dumbbell::collisions::Piece& piece : stairs.pieces) {
            const long n = as_long(*piece.upper);
            CAPTURE(name, n);
            if (piece.status() == dumbbell::collisions::Status::exact) {
                continue;
            }
            // The gap from n - 1 to n: q_c(n) = value + [0, radius] lies in it.
            std::istringstream in(rows.at(static_cast<std::size_t>(n - first)));
            std::string number, value, radius;
            in >> number >> value >> radius;
            REQUIRE(number == std::to_string(n));
            const dumbbell::Rational from = dumbbell::parse_rational(value);
            CHECK(piece.q_lo <= from);
            CHECK(from + dumbbell::parse_rational(radius) <= piece.q_hi);
        }
        const auto& last_piece = stairs.pieces.back();
        CHECK(last_piece.status() == dumbbell::collisions::Status::exact);
    }
}

TEST_CASE("no piece of the shipped staircases attains the paper's bound") {
    // It grows with the ratio. The piece that begins at 1 is about greater ratios: it is 4 from there to 3.
    for (const char* name : staircases) {
        for (const dumbbell::collisions::Piece& piece : staircase(name).pieces) {
            const bool behind_1 = piece.q_lo == 1 && piece.q_hi > 1;
            CAPTURE(name, piece.q_lo);
            CHECK(*piece.upper < (behind_1 ? 4 : dumbbell::flight::paper_bound(piece.q_lo)));
        }
    }
}
