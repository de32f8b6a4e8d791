// What is demanded of the adiabatic invariant: each number, a little more than the file proves and not.
#include "verify/wings/adiabatic/demand.hpp"

#include "catch.hpp"

namespace adiabatic = dumbbell_verify::adiabatic;
using dumbbell_verify::Numbers;

TEST_CASE("adiabatic: each number that is demanded is compared with the file's") {
    adiabatic::Claim claim;
    claim.delta_lo = mpq_class(1, 30), claim.delta_hi = mpq_class(1, 20);
    claim.y_lo = mpq_class(3, 5), claim.y_hi = mpq_class(9, 10);
    claim.margin = mpq_class(2, 3);
    claim.exponent = 8;
    claim.bounds = {mpq_class(20, 3), 9};
    claim.attained = {{1, 0, mpq_class(1, 25), 1, mpq_class(3, 7)}, {1, 0, mpq_class(1, 24), 1, 2}};
    const mpq_class hair(1, 1'000'000'000);
    const auto fails = [&](const Numbers& numbers) { return !missing(claim, numbers).empty(); };
    const auto with = [&](std::string_view name, const mpq_class& a, const mpq_class& b) {
        return fails({{name, {a, b}}});
    };
    const Numbers whole{
        {"delta", {claim.delta_lo, claim.delta_hi}}, {"heights", {claim.y_lo, claim.y_hi}},
        {"margin", {claim.margin, claim.margin}},    {"exponent", {mpq_class(1, 2), mpq_class(1, 2)}},
        {"constant", {mpq_class(20, 3), 9}},         {"attained", {mpq_class(3, 7), 2}}};
    CHECK_FALSE(fails(whole));
    CHECK_FALSE(fails({}));
    CHECK(with("delta", claim.delta_lo - hair, claim.delta_hi));
    CHECK(with("delta", claim.delta_lo, claim.delta_hi + hair));
    CHECK_FALSE(with("delta", mpq_class(1, 25), mpq_class(1, 25)));
    CHECK(with("heights", claim.y_lo - hair, claim.y_hi));
    CHECK(with("heights", claim.y_lo, claim.y_hi + hair));
    CHECK_FALSE(with("heights", mpq_class(7, 10), mpq_class(7, 10)));
    CHECK(with("margin", claim.margin - hair, claim.margin - hair));
    CHECK_FALSE(with("margin", 1, 1));
    CHECK(with("exponent", mpq_class(7, 16), mpq_class(7, 16)));
    CHECK(with("constant", mpq_class(20, 3) - hair, 9));
    CHECK(with("constant", mpq_class(20, 3), 9 - hair));
    CHECK_FALSE(with("constant", 9, 9));
    CHECK(with("attained", mpq_class(3, 7) + hair, 2));
    CHECK(with("attained", mpq_class(3, 7), 2 + hair));
    // The states that attain are of the file's hypotheses, and not of narrower ones.
    for (const auto& [name, range] : Numbers{{"delta", {mpq_class(1, 25), mpq_class(1, 25)}},
                                             {"heights", {claim.y_lo, claim.y_hi - hair}},
                                             {"margin", {claim.margin + hair, claim.margin + hair}}}) {
        Numbers narrower = whole;
        narrower[name] = range;
        CHECK(fails(narrower));
        narrower.erase("attained");
        CHECK_FALSE(fails(narrower));
    }
    claim.delta_lo = 0;
    CHECK(with("delta", 0, 0));  // of which nothing is said
    CHECK_FALSE(with("delta", 0, hair));
}
