#include "campaign/merge.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "campaign/campaign.hpp"
#include "campaign/kinds/kinds.hpp"
#include "place.hpp"
#include "scripted_engine.hpp"

using namespace dumbbell;
using namespace dumbbell::campaign;
using namespace dumbbell_test;
using Catch::Matchers::Contains;

namespace {

void run(CampaignFolder& folder) {
    ScriptedEngine engine([](const Task& task, int) { return worked(task); });
    REQUIRE(run_campaign(folder, engine, {}).left == 0);
}

}  // namespace

TEST_CASE("nothing is merged before all shards are finished") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    const CampaignFolder folder(place.string());
    const Merge merge = merge_campaign(folder, {});
    CHECK(merge.shards == 4);
    CHECK(merge.unfinished == 4);
    CHECK_FALSE(merge.whole.has_value());
}

TEST_CASE("a result that was changed on the disk is found, taken away, and proved again by the next run") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    CampaignFolder folder(place.string());
    run(folder);
    const std::string before = merge_campaign(folder, {}).whole->text;
    const std::string id = folder.parts()[2].id;
    std::ofstream(folder.result_file(id), std::ios::app) << "more";
    const Merge merge = merge_campaign(folder, {.jobs = 3});
    CHECK_FALSE(merge.whole.has_value());
    REQUIRE(merge.withdrawn.size() == 1);
    CHECK_THAT(merge.withdrawn[0], Contains(id));
    CHECK_FALSE(folder.has_result(id));
    run(folder);
    CHECK(merge_campaign(folder, {}).whole->text == before);
}

TEST_CASE("results that nobody can look at stay where they are") {  // no verifier lies next to this test
    const Place place;
    collisions::CertifyRequest request;
    request.q_lo = 1;
    request.q_hi = 12;
    CampaignFolder::create(place.string(), *plan_collisions(request, 3, never));
    CampaignFolder folder(place.string());
    CampaignOptions careful;
    careful.verifiers = 1;
    ScriptedEngine own([](const Task& task, int) { return worked(task); });
    careful.own = &own;
    ScriptedEngine engine([](const Task& task, int) { return worked(task); });
    const CampaignRun unlooked = run_campaign(folder, engine, careful);
    CHECK(unlooked.accepted == 0);
    CHECK(unlooked.rejected == 0);
    CHECK(unlooked.given_up == 3);
    CHECK(engine.distrusted().empty());
    CHECK(std::filesystem::is_empty(place.path / "rejected"));
    run(folder);
    CHECK_THROWS_WITH(merge_campaign(folder, {}),
                      Contains("cannot start the verifier") && Contains("nothing is changed"));
    CHECK(folder.has_result(folder.parts()[0].id));
    CHECK(merge_campaign(folder, {.scrutiny = Scrutiny::form}).whole.has_value());
}

TEST_CASE("what nobody can verify later is not merged unverified") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    CampaignFolder folder(place.string());
    run(folder);
    CHECK_THROWS_WITH(merge_campaign(folder, {.scrutiny = Scrutiny::form}), Contains("without --unverified"));
}

TEST_CASE("a merge can be interrupted, and nothing is lost") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    CampaignFolder folder(place.string());
    run(folder);
    MergeOptions options;
    options.interrupted = [] { return true; };
    CHECK_FALSE(merge_campaign(folder, options).whole.has_value());
    CHECK(merge_campaign(folder, {}).whole.has_value());
}
