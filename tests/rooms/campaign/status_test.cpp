#include "campaign/status.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "campaign/campaign.hpp"
#include "campaign/status_report.hpp"
#include "place.hpp"
#include "rooms/parsed.hpp"
#include "scripted_engine.hpp"

using namespace dumbbell;
using namespace dumbbell::campaign;
using namespace dumbbell_test;
using Catch::Matchers::Contains;

TEST_CASE("before the first run nothing is done, and nothing is known of the time") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    const CampaignStatus status = campaign_status(CampaignFolder(place.string()));
    CHECK(status.shards == 4);
    CHECK(status.done == 0);
    CHECK_FALSE(status.is_running);
    CHECK_FALSE(status.rate.has_value());
    CHECK_FALSE(status.remaining.has_value());
    CHECK(verdict(status) == "0 of 4 shards are done (0.0 % of the estimated work); no run is at work\n");
}

TEST_CASE("the status counts what is finished, what failed, and who did it") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    CampaignFolder folder(place.string());
    folder.lock();
    std::size_t questions = 0;
    CampaignOptions options;
    options.interrupted = [&] { return ++questions > 4; };
    ScriptedEngine engine([](const Task& task, int) {
        static int count = 0;
        return count++ == 0 ? failed(task, "no") : worked(task);
    });
    const CampaignRun run = run_campaign(folder, engine, options);
    REQUIRE(run.left == 1);

    const CampaignStatus status = campaign_status(CampaignFolder(place.string()));
    CHECK(status.is_running);  // somebody has it locked
    CHECK(status.done == 3);
    CHECK(status.failed == 1);
    CHECK(status.connected == 1);
    CHECK((status.share > 0 && status.share < 1));
    CHECK(status.rate.has_value());
    CHECK(status.remaining.has_value());
    REQUIRE(status.workers.size() == 1);
    CHECK(status.workers.at("far").done == 3);
    CHECK(status.workers.at("far").failed == 1);
    CHECK(status.workers.at("far").seconds == Approx(1.5));
    CHECK_THAT(to_text(status),
               Contains("3 of 4 shards are done") && Contains("far") && Contains("failed: 1"));

    const auto json = parsed(to_json(status));
    CHECK(json["schema"] == "dumbbell-campaign-status-1");
    CHECK(json["done"] == 3);
    CHECK(json["workers"][0]["name"] == "far");
    CHECK_FALSE(json["complete"]);
}

TEST_CASE("the time that is left is told by the work, not by the time in which nobody came") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan(3, 14, 12));
    const CampaignFolder folder(place.string());
    const double now = seconds_since_1970();
    std::ofstream journal(place.string() + "/journal");
    const auto event = [&](double ago, const std::string& what) {
        journal << fmt::format("{:.3f}\t{}\n", now - ago, what);
    };
    event(1000, "begin\t\t\t0\t" + folder.plan_digest());
    double done = 0;  // of the cost, 3 + ... + 14
    for (int i = 0; i < 6; ++i) {
        const CampaignFolder::Part part = folder.parts()[static_cast<std::size_t>(i)];
        CHECK(folder.keep_result(part.id, "x") == CampaignFolder::Kept::now);
        event(50 - 10 * i, fmt::format("done\t{}\tfar\t10\t", part.id));
        done += part.cost;
    }
    journal.close();
    const CampaignStatus status = campaign_status(CampaignFolder(place.string()));
    CHECK(*status.rate == Approx(6));
    CHECK(*status.remaining == Approx(60 * (102 - done) / done));
}

TEST_CASE("a worker that comes, and the first task that is out, are in the journal at once") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    CampaignFolder folder(place.string());
    folder.lock();
    ScriptedEngine engine([](const Task& task, int) { return worked(task); });
    struct Look : Observer {
        explicit Look(std::string of) : folder(std::move(of)) {}
        void update(std::size_t done, std::size_t, std::optional<long>) override {
            const CampaignStatus status = campaign_status(CampaignFolder(folder));
            CHECK(status.connected == (done > 1 ? 1 : 0));  // the first look is after the first result
            CHECK((status.running > 0) == (done > 1));
        }
        std::string folder;
    } look(place.string());
    CampaignOptions options;
    options.observer = &look;
    CHECK(run_campaign(folder, engine, options).left == 0);
}

TEST_CASE("a split shard counts as its halves, and the estimated work stays the same") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    const CampaignFolder folder(place.string());
    folder.split(folder.parts()[0].id);
    CHECK(campaign_status(folder).shards == 5);
    const auto half = folder.parts()[0];
    CHECK(folder.keep_result(half.id, "x") == CampaignFolder::Kept::now);
    const CampaignStatus status = campaign_status(folder);
    CHECK(status.share == Approx(half.cost / 102));  // 3 + ... + 14
}
