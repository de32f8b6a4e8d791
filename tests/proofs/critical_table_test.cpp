// The shipped table of critical ratios: complete, in order, and made again, byte for byte, row by row.
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <sstream>

#include "../cli/process.hpp"

using namespace dumbbell_test;

namespace {

using Lines = std::vector<std::string>;

constexpr long first = 3;
constexpr long last = 902;

const std::string table = DUMBBELL_PROJECT "/certificates/critical-ratios.tsv";

Lines lines_of(const std::string& path) {
    Lines lines;
    std::istringstream in(contents(path));
    for (std::string line; std::getline(in, line);) {
        lines.push_back(line);
    }
    return lines;
}

Lines made(const std::string& counts) {
    const TemporaryFolder folder;
    const Outcome result =
        run({DUMBBELL_BIN, "critical", counts, "--digits", "50", "--out", folder / "made.tsv"});
    CAPTURE(result.err);
    REQUIRE(result.code == 0);
    return lines_of(folder / "made.tsv");
}

Lines without_remarks(Lines lines) {
    lines.erase(
        std::remove_if(lines.begin(), lines.end(), [](const auto& line) { return line.starts_with('#'); }),
        lines.end());
    return lines;
}

}  // namespace

TEST_CASE("the table of critical ratios has every N from 3 to 902, with 50 digits, increasing") {
    const Lines rows = without_remarks(lines_of(table));
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
    const Lines shipped = lines_of(table);
    const Lines rows = without_remarks(shipped);
    // The first rows with the remarks in front.
    const Lines beginning = made("3:40");
    REQUIRE(beginning.size() <= shipped.size());
    CHECK(std::equal(beginning.begin(), beginning.end(), shipped.begin()));
    std::mt19937_64 engine(2026);
    for (int i = 0; i < 12; ++i) {
        const auto n = first + static_cast<long>(engine() % (last - first + 1));
        CAPTURE(n);
        const Lines again = without_remarks(made(std::to_string(n)));
        REQUIRE(again.size() == 1);
        CHECK(again.front() == rows.at(static_cast<std::size_t>(n - first)));
    }
}
