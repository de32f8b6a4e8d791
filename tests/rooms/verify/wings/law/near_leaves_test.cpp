// What the verifier computes for the law, digit by digit (near_law.tsv, made by
// tests/attacks/source_mutation/near_law.cpp). That it is true is what leaf_test.cpp is about.
#include "catch.hpp"
#include "rooms/verify/core/leaf_rows.hpp"
#include "rows.hpp"
#include "scale.hpp"
#include "verify/wings/law/rule.hpp"

using namespace dumbbell_verify;

namespace {

const bool all_rows = scaled(1) >= 20;  ///< else of the parts of the bulk, which are dear, every fourth
const std::vector<leaf_rows::Row>& near_law_rows() {
    static const auto table = [] {
        auto rows = leaf_rows::read(DUMBBELL_PROJECT "/tests/data/near_law.tsv");
        if (!all_rows)
            std::erase_if(rows, [i = 0](const auto& row) mutable {
                return row.leaf.starts_with("bulk") && ++i % 4 != 0;
            });
        return rows;
    }();
    return table;
}

/// Of the answer's lines `X in Y` the intervals X.
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

struct OpenRule : law::Rule<double> {
    OpenRule() : Rule(leaf, nullptr) {}
    using Rule::within;
    law::Leaf leaf;
};
constexpr double after(double x) { return x * (1 + 0x1p-52); }

}  // namespace

TEST_CASE("law: beyond what a series is for nothing is known") {
    using I = Interval<double>;
    const auto is_unbounded = [](const I& x) {
        return std::isinf(x.lo) && x.lo < 0 && std::isinf(x.hi) && x.hi > 0;
    };
    using Function = I (*)(const I&);
    for (const auto function : {Function(law::sinc<double>), Function(law::falling_cosine<double>),
                                Function([](const I& x) { return law::falling_share(x, 4); })}) {
        CHECK_FALSE(is_unbounded(function(I(0, 2))));
        CHECK_FALSE(is_unbounded(function(I(0, 0))));
        for (const I& x : {I(0, after(2)), I(-0x1p-60, 1), I(-1, 3), I(1, 3), I(3, 4), I(-2, -1)})
            CHECK(is_unbounded(function(x)));
    }
    CHECK_FALSE(is_unbounded(law::square_root(I(0, 4))));
    for (const I& x : {I(-0x1p-60, 4), I(-4, -1)}) CHECK(is_unbounded(law::square_root(x)));
    for (const I& x : {I(-1, 3), I(-3, 1), I(1, 3), I(-3, -1)}) {
        CHECK(law::up_to_size(x).lo == -3);
        CHECK(law::up_to_size(x).hi == 3);
    }
}

TEST_CASE("law: an enclosure lies within bounds if all of it certainly does") {
    OpenRule rule;
    using I = Interval<double>;
    const I least(0, 1), most(2, 3);
    for (const I& x : {I(1, 2), I(1, 1), I(2, 2), I(1.25, 1.5)}) CHECK(rule.within("", x, least, most));
    for (const I& x :
         {I(0.5, 2), I(1, 2.5), I(0.5, 0.5), I(2.5, 2.5), I(0, 3), I(-1, 1), I(2, 4), I(1.5, 1.25)})
        CHECK_FALSE(rule.within("", x, least, most));
}

TEST_CASE("law: rules and constants have the same enclosures as before, and ask for the same work") {
    REQUIRE(near_law_rows().size() > 100);
    std::uint64_t units = 0;
    for (const auto& row : near_law_rows()) {
        Meter::begin();
        const std::string found = law_rows::judged(row.leaf);
        if (found != row.result) FAIL(row.leaf << "\n  expected: " << row.result << "\n  found: " << found);
        units += Meter::done();
    }
    CHECK(units == (all_rows ? 10'488'574'600 : 4'282'261'844));
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
