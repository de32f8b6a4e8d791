// The judge runs the verifier that lies next to the program: tests/programs/cli/campaign_adiabatic_test.cpp.
#include <catch2/catch.hpp>
#include <fstream>

#include "adiabatic/case.hpp"
#include "adiabatic/prove.hpp"
#include "adiabatic/writer.hpp"
#include "base/error.hpp"
#include "campaign/kinds/kinds.hpp"
#include "rooms/campaign/place.hpp"

using namespace dumbbell;
using namespace dumbbell::adiabatic;
using namespace dumbbell::campaign;
using namespace dumbbell_test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

const std::string head = "prove adiabatic\naccuracy 1/10\n";

AdiabaticHypotheses bounce(const Rational& delta_lo, const Rational& delta_hi) {
    AdiabaticHypotheses of;
    of.claim = AdiabaticClaim::bounce;
    of.delta = {delta_lo, delta_hi};
    of.heights = {0, 1};
    of.margin = 1;
    return of;
}

std::vector<AdiabaticHypotheses> grid() {
    return {bounce(Rational(1, 100), Rational(1, 100)), bounce(Rational(1, 50), Rational(3, 100)),
            bounce(Rational(1, 20), Rational(1, 20))};
}

Plan planned() { return plan_adiabatic(grid(), Rational(1, 10)); }

}  // namespace

TEST_CASE("each statement of a grid is a shard, and its result what one run proves, byte for byte") {
    const Plan plan = planned();
    REQUIRE(plan.shards.size() == 3);
    CHECK(plan.whole.head == head);
    CHECK(plan.claim ==
          "adiabatic --theorem lemma3.1 --delta 0.01,0.02:0.03,0.05 --y 0:1 --phi-margin 1 --accuracy 0.1");
    CHECK(parse_plan(render(plan)) == plan);
    AdiabaticRequest request;
    request.of = grid()[1];
    request.jobs = 2;
    CHECK(plan.shards[1].end == plan.shards[1].first + 1);
    CHECK(*adiabatic_kind().work(plan.order(1, 2), ".", never) ==
          render(certificate_of(prove_adiabatic(request))).text);
}

TEST_CASE("results merge to a table with a line for each statement, wherever their files lie") {
    const Place place;
    const Plan plan = planned();
    const campaign::Kind::Merged merged =
        adiabatic_kind().merge(plan, ".", results(adiabatic_kind(), plan, place));
    CHECK_FALSE(merged.is_open);
    CHECK(merged.text.find(place.string()) == std::string::npos);
    const std::string text = *adiabatic_kind().work(plan.order(0, 1), ".", never);
    const std::string digest = text.substr(text.size() - 65, 64);
    CHECK_THAT(merged.text, Contains("\nlemma3.1\t0.01\t0.01\t0\t1\t1\t0.5\t1.988\t") &&
                                Contains("\t" + digest + "\tresults/" + plan.order(0, 1).id() + "\n"));
    CHECK(std::count(merged.text.begin(), merged.text.end(), '\n') == 8);
}

TEST_CASE("certificates of other statements are not merged") {
    const Place place;
    const Plan plan = planned();
    const auto files = results(adiabatic_kind(), plan, place);
    const auto refused = [&](const std::vector<std::string>& some) {
        CHECK_THROWS_WITH(adiabatic_kind().merge(plan, ".", some), Contains("do not tile the claim"));
    };
    refused({files[0], files[1]});
    refused({files[0], files[1], files[1]});
    refused({files[1], files[0], files[2]});
    Plan other = plan;
    other.claim.replace(plan.claim.find("0:1 "), 3, "0:2");
    CHECK_THROWS_WITH(adiabatic_kind().merge(other, ".", files), Contains("do not tile the claim"));
    std::ofstream(files[1], std::ios::app) << "more";
    CHECK_THROWS_AS(adiabatic_kind().merge(plan, ".", files), InputError);
}

TEST_CASE("orders about the adiabatic invariant that no plan makes are refused before any work") {
    const std::string unit = case_of(grid()[0]);
    const auto refused = [](const Order& order) {
        CAPTURE(order.head, order.units);
        CHECK_THROWS_AS(adiabatic_kind().work(order, ".", never), InputError);
    };
    refused({head, {}});
    refused({head, {unit, unit}});
    refused({head, {"case adiabatic-bounce 1/100 1/100 0/1 1/1 1/1"}});
    for (const char* accuracy : {"", "0/1", "2/1", "0.1", "2/20", "x", "1/10\nmore 1"}) {
        refused({std::string("prove adiabatic\naccuracy ") + accuracy + "\n", {unit}});
    }
    refused({"prove adiabatic\naccuracy 1/10", {unit}});
    refused({"prove adiabatic\n", {unit}});
}

TEST_CASE("an order about the adiabatic invariant that is interrupted has no result") {
    const Order order = planned().order(0, 1);
    CHECK_FALSE(adiabatic_kind().work(order, ".", [] { return true; }).has_value());
    int left = 3;
    CHECK_FALSE(adiabatic_kind().work(order, ".", [&] { return --left < 0; }).has_value());
}

TEST_CASE("a statement that cannot be proved has no result, and the reason names it") {
    AdiabaticHypotheses of = bounce(Rational(49, 100), Rational(49, 100));
    of.claim = AdiabaticClaim::scattering;
    CHECK_THROWS_WITH(adiabatic_kind().work({head, {case_of(of)}}, ".", never),
                      Contains("not certified: adiabatic --theorem thm3.5 --delta 0.49 --phi-margin 1;"));
}

TEST_CASE("a single statement needs no campaign, and none is proved twice") {
    const auto refused = [](const std::vector<AdiabaticHypotheses>& some, const char* reason) {
        CHECK_THROWS_WITH(plan_adiabatic(some, Rational(1, 10)), Contains(reason));
    };
    refused({grid()[0]}, "use dumbbell adiabatic --out");
    refused({grid()[0], grid()[1], grid()[0]}, "twice: --theorem lemma3.1 --delta 0.01 --y 0:1");
}
