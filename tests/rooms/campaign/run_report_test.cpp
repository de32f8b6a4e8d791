#include "campaign/run_report.hpp"

#include <catch2/catch.hpp>

#include "rooms/parsed.hpp"

using namespace dumbbell;
using namespace dumbbell::campaign;
using Catch::Matchers::Contains;
using dumbbell_test::parsed;

namespace {

CampaignRun sample() {
    CampaignRun run;
    run.accepted = 9;
    run.rejected = 1;
    run.left = 2;
    run.seconds = 3;
    run.worked = 20;
    run.own_seconds = 0.05;
    run.engine.joined = 3;
    run.engine.lost = 1;
    run.engine.resent = 4;
    return run;
}

}  // namespace

TEST_CASE("the report of a run says what was done, and what it cost") {
    const std::string text = to_text(sample());
    CHECK_THAT(text, Contains("9 shards finished in 3 s\n"));
    CHECK_THAT(text, Contains("the manager's own: 5.00 ms a shard"));
    CHECK_THAT(text, Contains("results rejected: 1"));
    CHECK_THAT(text, Contains("3 came, 1 were lost; shards sent again: 4"));
    CHECK_THAT(text, !Contains("complete"));
    CHECK(parsed(to_json(sample(), "local"))["manager_seconds_a_shard"] == 0.005);
    CHECK_FALSE(parsed(to_json(sample(), "local"))["complete"]);
}

TEST_CASE("a complete campaign is called so, and a run without results divides by nothing") {
    CampaignRun run;
    CHECK_THAT(verdict(run), Contains("the campaign is complete"));
    CHECK(parsed(to_json(run, "local"))["manager_seconds_a_shard"] == 0);
}
