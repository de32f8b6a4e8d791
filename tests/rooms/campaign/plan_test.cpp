#include "campaign/plan.hpp"

#include <catch2/catch.hpp>
#include <numeric>
#include <random>

#include "base/error.hpp"
#include "resealed.hpp"
#include "scripted_engine.hpp"

using namespace dumbbell;
using namespace dumbbell::campaign;
using namespace dumbbell_test;
using Catch::Matchers::Contains;

namespace {

std::size_t sum(const std::vector<std::size_t>& costs) {
    return std::accumulate(costs.begin(), costs.end(), std::size_t{0});
}

}  // namespace

TEST_CASE("shards cover all units once, none is empty, and there are not more than wanted") {
    std::mt19937 random(1);
    for (int trial = 0; trial < 500; ++trial) {
        std::vector<std::size_t> costs(1 + random() % 60);
        for (std::size_t& cost : costs) {
            cost = 1 + random() % (trial % 2 == 0 ? 10 : 100'000);
        }
        const std::size_t wanted = 1 + random() % 70;
        const auto shards = even_shards(costs, wanted);
        REQUIRE(!shards.empty());
        CHECK(shards.size() <= std::min(wanted, costs.size()));
        std::size_t covered = 0;
        std::size_t cost = 0;
        for (const Plan::Shard& shard : shards) {
            REQUIRE(shard.first == covered);
            REQUIRE(shard.end > shard.first);
            covered = shard.end;
            cost += shard.cost;
        }
        CHECK(covered == costs.size());
        CHECK(cost == sum(costs));
    }
}

TEST_CASE("shards are of even cost, up to a unit") {
    std::vector<std::size_t> costs(1000);
    std::iota(costs.begin(), costs.end(), 1);
    const auto shards = even_shards(costs, 20);
    CHECK(shards.size() == 20);
    for (const Plan::Shard& shard : shards) {
        CHECK(std::abs(static_cast<double>(shard.cost) - static_cast<double>(sum(costs)) / 20) <= 1000);
    }
}

TEST_CASE("a plan is read back as it was written") {
    Plan plan = small_plan();
    plan.inputs = {"proof.dbc"};
    CHECK(parse_plan(render(plan)) == plan);
}

TEST_CASE("the shards' orders are about all units of the plan, in their order") {
    const Plan plan = small_plan();
    std::vector<std::string> units;
    for (const Plan::Shard& shard : plan.shards) {
        const Order order = plan.order(shard.first, shard.end);
        CHECK(order.head == plan.whole.head);
        units.insert(units.end(), order.units.begin(), order.units.end());
    }
    CHECK(units == plan.whole.units);
}

TEST_CASE("a plan that was changed anywhere is refused, and one whose shards leave something out") {
    const std::string text = render(small_plan());
    for (std::size_t i = 0; i < text.size(); i += 7) {
        std::string changed = text;
        changed[i] ^= 1;
        CHECK_THROWS_AS(parse_plan(changed), InputError);
    }
    CHECK_THROWS_AS(parse_plan(resealed(text, "shard 0 ", "shard 1 ")), InputError);
    CHECK_THROWS_AS(parse_plan(resealed(text, "units 12", "units 11")), InputError);
    CHECK_THROWS_AS(parse_plan(resealed(text, "shards 4", "shards 3")), InputError);
    CHECK_THROWS_AS(parse_plan(""), InputError);
}

TEST_CASE("a plan of another version is refused, with what to do") {
    const std::string other =
        resealed(render(small_plan()), "generator dumbbell " DUMBBELL_VERSION, "generator dumbbell 9.9");
    CHECK_THROWS_WITH(parse_plan(other), Contains("dumbbell 9.9") && Contains("go on with that version"));
}
