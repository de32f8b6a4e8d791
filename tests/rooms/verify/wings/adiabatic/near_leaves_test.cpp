// Leaves and attained states of the adiabatic claims that are just certified, and their neighbours that just
// are not (near_adiabatic.tsv, made by tests/attacks/source_mutation/near_adiabatic.cpp).
#include "catch.hpp"
#include "rooms/verify/core/leaf_rows.hpp"
#include "rows.hpp"
#include "scale.hpp"
#include "verify/machine/meter.hpp"

using dumbbell_verify::Meter;

namespace {

const bool all_adiabatic_rows = scaled(1) >= 20;  ///< else of the classes, which are dear, every fourth
const std::vector<leaf_rows::Row>& near_adiabatic_rows() {
    static const auto table = [] {
        auto rows = leaf_rows::read(DUMBBELL_PROJECT "/tests/data/near_adiabatic.tsv");
        const auto is_left_out = [i = 0](const auto& row) mutable {
            return adiabatic_rows::parsed(row.leaf).part == dumbbell_verify::adiabatic::Leaf::class_tree &&
                   ++i % 4 != 0;
        };
        if (!all_adiabatic_rows) std::erase_if(rows, is_left_out);
        return rows;
    }();
    return table;
}

}  // namespace

TEST_CASE("adiabatic leaves near the edge of what is certified are judged as before, for the same reason") {
    REQUIRE(near_adiabatic_rows().size() > 100);
    std::uint64_t units = 0;
    for (const auto& row : near_adiabatic_rows()) {
        Meter::begin();
        const std::string found = judged(adiabatic_rows::parsed(row.leaf));
        if (found != row.result) FAIL(row.leaf << "\n  expected: " << row.result << "\n  found: " << found);
        units += Meter::done();
    }
    // Nor is another amount charged for them: what was within the default budget still is.
    CHECK(units == (all_adiabatic_rows ? 12'472'305'637 : 4'461'102'277));
}

TEST_CASE("adiabatic: what few bits certify, 300 bits certify, too") {
    for (const auto& row : near_adiabatic_rows()) {
        adiabatic_rows::Case c = adiabatic_rows::parsed(row.leaf);
        if (row.result != "certified" || c.bits == 0 ||
            c.part == dumbbell_verify::adiabatic::Leaf::class_tree)
            continue;  // doubles are exact enough, and a class takes long
        c.bits = 300;
        const std::string found = judged(c);
        // A box that by rounding alone reaches beyond the margin holds no state that is spoken of.
        if (found == "the leaf reaches below pi/2 and above the margin") continue;
        if (found != row.result) FAIL(row.leaf << "\n  with 300 bits: " << found);
    }
}
