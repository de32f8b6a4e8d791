// What the verifier computes for the law, digit by digit (near_law.tsv, made by
// tests/attacks/source_mutation/near_law.cpp). That it is true is what law_leaf_test.cpp is about.
#include <catch2/catch.hpp>

#include "law_rows.hpp"
#include "leaf_rows.hpp"

using dumbbell_verify::Work;

namespace {

const std::vector<leaf_rows::Row>& near_law_rows() {
    static const auto table = leaf_rows::read(DUMBBELL_PROJECT "/tests/data/near_law.tsv");
    return table;
}

/// Of the answers' lines `X in Y` the intervals X, up to a line of another kind: before it both arithmetics
/// have come by the same.
std::vector<std::pair<double, double>> enclosures(const std::string& answer) {
    std::vector<std::pair<double, double>> result;
    std::istringstream in(answer);
    for (std::string line; std::getline(in, line, ';');) {
        const std::size_t end = line.find("] in [");
        if (end == std::string::npos || line.at(1) != '[') continue;
        result.emplace_back(std::stod(line.substr(2)), std::stod(line.substr(line.find(", ") + 2)));
    }
    return result;
}

}  // namespace

TEST_CASE("law: rules and constants have the same enclosures as before, and ask for the same work") {
    REQUIRE(near_law_rows().size() > 100);
    std::uint64_t units = 0;
    for (const auto& row : near_law_rows()) {
        Work::begin();
        const std::string found = law_rows::judged(row.leaf);
        if (found != row.result) FAIL(row.leaf << "\n  expected: " << row.result << "\n  found: " << found);
        units += Work::done();
    }
    CHECK(units == 1'725'522'232);
}

TEST_CASE("law: what few bits certify 300 bits certify too, in narrower enclosures") {
    std::size_t compared = 0;
    for (const auto& row : near_law_rows()) {
        std::istringstream in(row.leaf);
        std::string what, bits, rest;
        in >> what >> bits;
        std::getline(in, rest);
        if (bits == "0" || row.result.find("certified") != 0) continue;
        const std::string fine = law_rows::judged(what + " 300" + rest);
        INFO(row.leaf << "\n  " << row.result << "\n  with 300 bits: " << fine);
        CHECK(fine.find("certified") == 0);
        const auto few = enclosures(row.result), many = enclosures(fine);
        REQUIRE(few.size() == many.size());
        for (std::size_t i = 0; i < few.size(); ++i, ++compared)
            CHECK((few[i].first <= many[i].first && many[i].second <= few[i].second));
    }
    CHECK(compared > 50);
}
