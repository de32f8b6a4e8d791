// Leaves that are just certified and leaves that just are not (near_leaves.tsv): a formula, a pad or an end
// of an interval that is wrong moves one of these edges. How the table is made:
// tests/attacks/source_mutation/README.md.
#include "catch.hpp"
#include "leaf_rows.hpp"
#include "verify/machine/meter.hpp"

using namespace leaf_rows;
using dumbbell_verify::Meter;

namespace {

const std::vector<Row>& near_leaf_rows() {
    static const std::vector<Row> table = read(DUMBBELL_PROJECT "/tests/data/near_leaves.tsv");
    return table;
}

}  // namespace

TEST_CASE("leaves near the edge of what is certified are judged as before, for the same reason") {
    REQUIRE(near_leaf_rows().size() > 100);
    std::uint64_t units = 0;
    for (const Row& row : near_leaf_rows()) {
        Meter::begin();
        const std::string found = judged(parsed(row.leaf));
        if (found != row.result) FAIL(row.leaf << "\n  expected: " << row.result << "\n  found: " << found);
        units += Meter::done();
    }
    // Nor is another amount charged for them: what was within the default budget still is.
    CHECK(units == 1'836'558'529);
}

TEST_CASE("what doubles or few bits certify, 300 bits certify, too") {
    for (const Row& row : near_leaf_rows()) {
        if (row.result != "certified") continue;
        AnyLeaf leaf = parsed(row.leaf);
        std::visit(
            [](auto& any) {
                if constexpr (requires { any.leaf; })
                    set_bits(any.leaf, 300);
                else if constexpr (requires { any.bits; })
                    set_bits(any, 300);
            },
            leaf);
        const std::string found = judged(leaf);
        if (found != row.result) FAIL(row.leaf << "\n  with 300 bits: " << found);
    }
}
