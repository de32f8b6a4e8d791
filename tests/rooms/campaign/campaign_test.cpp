#include "campaign/campaign.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "base/error.hpp"
#include "base/fields.hpp"
#include "campaign/kinds/kinds.hpp"
#include "campaign/local_engine.hpp"
#include "campaign/merge.hpp"
#include "campaign/status.hpp"
#include "collisions/writer.hpp"
#include "file/file_contents.hpp"
#include "file/sealed_lines.hpp"
#include "place.hpp"
#include "resealed.hpp"
#include "scripted_engine.hpp"
#include "staircase/critical_report.hpp"

using namespace dumbbell;
using namespace dumbbell::campaign;
using namespace dumbbell::collisions;
using namespace dumbbell_test;
using Catch::Matchers::Contains;

namespace {

struct Notes : Observer {
    void note(const std::string& line) override { text += line; }

    std::string text;
};

/// The table as one run of `critical` makes it.
std::string in_one_go(long first, long last) {
    staircase::CriticalReport report;
    report.request.first = first;
    report.request.last = last;
    report.request.digits = 10;
    report.rows = critical_ratios(report.request);
    return to_tsv(report);
}

std::string merged(const CampaignFolder& folder) {
    const Merge merge = merge_campaign(folder, {});
    REQUIRE(merge.whole.has_value());
    return merge.whole->text;
}

/// A campaign in a folder of its own, opened.
struct Campaign {
    Place place;
    std::optional<CampaignFolder> folder;

    explicit Campaign(const Plan& plan = small_plan(), const std::vector<std::string>& sources = {}) {
        CampaignFolder::create(place.string(), plan, sources);
        folder.emplace(place.string());
    }
    CampaignRun run(Engine& engine, const CampaignOptions& options = {}) {
        return run_campaign(*folder, engine, options);
    }
    [[nodiscard]] std::string result(const std::string& id) const {
        return file_contents(folder->result_file(id));
    }
    [[nodiscard]] std::string rejected(const std::string& id) const {
        return file_contents((place.path / "rejected" / id).string());
    }
};

bool is_complete(const CampaignFolder& folder) {
    const auto parts = folder.parts();
    return std::all_of(parts.begin(), parts.end(), [](const auto& part) { return part.finished; });
}

/// Results come from elsewhere; nothing is tried here unless a test says so.
CampaignOptions verified() {
    static ScriptedEngine nobody([](const Task& task, int) { return failed(task, "nobody asks"); });
    CampaignOptions options;
    options.verifiers = 2;
    options.own = &nobody;
    return options;
}

Plan plan_to_30() {
    CertifyRequest request;
    request.q_lo = 1;
    request.q_hi = 30;
    return *plan_collisions(request, 6, never);
}

/// An answer to an order about a range of ratios that leaves all of it undecided: well formed, and true.
campaign::Outcome undecided(const Task& task) {
    Certificate certificate;
    for (const std::string& unit : parse_order(task.order).units) {
        const auto fields = split(unit, ' ');
        Piece piece;
        piece.q_lo = parse_rational(fields[1]);
        piece.q_hi = parse_rational(fields[2]);
        certificate.pieces.push_back(piece);
    }
    return done(task, render(certificate).text);
}

/// What is looked at by its form alone, for there is no verifier next to this test.
CampaignOptions looked_at(Engine& own) {
    CampaignOptions options;
    options.verifiers = 2;
    options.scrutiny = Scrutiny::form;
    options.own = &own;
    return options;
}

}  // namespace

TEST_CASE("a campaign on this machine's threads gives what one run gives") {
    Campaign campaign;
    LocalEngine engine(2, campaign.place.string());
    const CampaignRun run = campaign.run(engine);
    CHECK(run.accepted == 4);
    CHECK(run.left == 0);
    CHECK(merged(*campaign.folder) == in_one_go(3, 14));
}

TEST_CASE("results in any order are accepted once each, and no more tasks are under way than wanted") {
    Campaign campaign(small_plan(3, 40, 38));
    ScriptedEngine engine([](const Task& task, int) { return worked(task); }, 5);
    const CampaignRun run = campaign.run(engine, verified());
    CHECK(run.accepted == campaign.folder->parts().size());
    CHECK(engine.most() <= 5);
    CHECK(merged(*campaign.folder) == in_one_go(3, 40));
}

TEST_CASE("what is finished is not done again") {
    Campaign campaign;
    bool stop = false;
    ScriptedEngine first([&](const Task& task, int) { return stop = true, worked(task); });
    CampaignOptions options;
    options.interrupted = [&] { return stop; };
    CHECK(campaign.run(first, options).left == 3);
    ScriptedEngine second([](const Task& task, int) { return worked(task); });
    const CampaignRun run = campaign.run(second);
    CHECK(run.accepted == 3);
    CHECK(second.attempts().size() == 3);
}

TEST_CASE("garbage is rejected by verification, kept for a look, and the shard proved elsewhere") {
    Campaign campaign;
    ScriptedEngine engine([](const Task& task, int attempt) {
        const campaign::Outcome truth = worked(task);
        switch (attempt) {
            case 1:
                return done(task, "garbage");
            case 2:
                return done(task, truth.result.substr(0, truth.result.size() / 2));
            case 3:
                return done(task, "");
            default:
                return truth;
        }
    });
    const CampaignRun run = campaign.run(engine, verified());
    CHECK(run.rejected == 12);
    CHECK(engine.distrusted() == std::vector<std::string>(12, "far"));
    CHECK(run.accepted == 4);
    CHECK(merged(*campaign.folder) == in_one_go(3, 14));
    CHECK(std::filesystem::exists(campaign.place.path / "rejected" / campaign.folder->parts()[0].id));
    CHECK(std::filesystem::is_empty(campaign.place.path / "arrived"));
}

TEST_CASE("the true result of another shard is garbage here") {
    Campaign campaign;
    std::string other;
    ScriptedEngine engine([&](const Task& task, int attempt) {
        const std::string mine = worked(task).result;
        const std::string given = attempt == 1 && !other.empty() ? other : mine;
        other = mine;
        return done(task, given);
    });
    const CampaignRun run = campaign.run(engine, verified());
    CHECK(run.rejected > 0);
    CHECK(run.left == 0);
    CHECK(merged(*campaign.folder) == in_one_go(3, 14));
}

TEST_CASE("a shard that always fails is given up, with the reason, and the others are not held up") {
    Campaign campaign;
    const std::string bad = campaign.folder->parts()[1].id;
    ScriptedEngine engine(
        [&](const Task& task, int) { return task.id == bad ? failed(task, "disk\nfull") : worked(task); });
    Notes said;
    CampaignOptions options = verified();
    options.observer = &said;
    const CampaignRun run = campaign.run(engine, options);
    CHECK(run.accepted == 3);
    CHECK(run.given_up == 1);
    CHECK(run.left == 1);
    CHECK(engine.attempts().at(bad) == 5);
    CHECK_THAT(said.text, Contains(bad) && Contains("disk?full"));
    const Merge merge = merge_campaign(*campaign.folder, {});
    CHECK(merge.unfinished == 1);
    CHECK_FALSE(merge.whole.has_value());
}

TEST_CASE("shards that are too big are split until they fit, and a single unit has all the time") {
    Campaign campaign(small_plan(3, 14, 1));
    std::size_t unlimited = 0;
    ScriptedEngine engine([&](const Task& task, int) {
        unlimited += task.limit ? 0 : 1;
        return task.limit ? too_long(task) : worked(task);
    });
    CampaignOptions options;
    options.shard_limit = std::chrono::seconds(1);
    const CampaignRun run = campaign.run(engine, options);
    CHECK(run.split == 11);
    CHECK(run.accepted == 12);
    CHECK(unlimited == 12);
    CHECK(merged(*campaign.folder) == in_one_go(3, 14));
    CHECK_NOTHROW(CampaignFolder(campaign.place.string()));
}

TEST_CASE("a worker that leaves everything undecided costs time and nothing else") {
    Campaign campaign(plan_to_30());
    ScriptedEngine liar([](const Task& task, int) { return undecided(task); });
    LocalEngine own(2, campaign.place.string());
    const CampaignRun run = campaign.run(liar, looked_at(own));
    CHECK(run.left == 0);
    CHECK(run.accepted == 6);
    CHECK(run.rejected == 6);
    CHECK(liar.distrusted() == std::vector<std::string>(6, "far"));
    const Merge merge = merge_campaign(*campaign.folder, {.scrutiny = Scrutiny::form});
    REQUIRE(merge.whole.has_value());
    CHECK_FALSE(merge.whole->is_open);
    CHECK(campaign_status(*campaign.folder).workers.at("local").done == 6);
}

TEST_CASE("what is undecided on this machine too is the result, and its worker told the truth") {
    Campaign campaign(plan_to_30());
    const std::string hard = campaign.folder->parts()[2].id;
    const Script script = [&](const Task& task, int) {
        return task.id == hard ? undecided(task) : worked(task);
    };
    ScriptedEngine far(script);
    ScriptedEngine own(script);
    Notes said;
    CampaignOptions options = looked_at(own);
    options.observer = &said;
    const CampaignRun run = campaign.run(far, options);
    CHECK(run.left == 0);
    CHECK(run.rejected == 0);
    CHECK(far.distrusted().empty());
    CHECK(own.attempts() == std::map<std::string, int>{{hard, 1}});
    CHECK_THAT(said.text, Contains(hard) && Contains("a piece stays undecided, here too"));
    CHECK(merge_campaign(*campaign.folder, {.scrutiny = Scrutiny::form}).whole->is_open);

    CHECK(withdraw_open_results(*campaign.folder) == 1);
    CHECK_FALSE(campaign.folder->has_result(hard));
    CHECK(withdraw_open_results(*campaign.folder) == 0);
    LocalEngine again(1, campaign.place.string());
    CHECK(campaign.run(again).accepted == 1);
    CHECK_FALSE(merge_campaign(*campaign.folder, {.scrutiny = Scrutiny::form}).whole->is_open);
}

TEST_CASE("a shard that is too big here is split, and while enough is tried here others may try, too") {
    Campaign campaign(plan_to_30());
    ScriptedEngine far([](const Task& task, int) { return undecided(task); });
    ScriptedEngine own([](const Task& task, int) { return task.limit ? too_long(task) : worked(task); }, 1);
    CampaignOptions options = looked_at(own);
    options.shard_limit = std::chrono::seconds(1);
    const CampaignRun run = campaign.run(far, options);
    CHECK(run.left == 0);
    CHECK(own.most() == 1);
    CHECK(run.split == campaign.folder->plan().whole.units.size() - 6);
    CHECK_FALSE(merge_campaign(*campaign.folder, {.scrutiny = Scrutiny::form}).whole->is_open);
}

TEST_CASE("a result that comes twice counts once, and one that is no proof gives way to one that is") {
    Campaign campaign;
    const auto part = campaign.folder->parts()[0];
    const std::string truth = *critical_kind().work(campaign.folder->order(part), ".", never);
    std::string there = truth;
    ScriptedEngine engine([&](const Task& task, int) {
        if (task.id == part.id) {  // it came by another way, meanwhile
            CHECK(campaign.folder->keep_result(task.id, there) == CampaignFolder::Kept::now);
        }
        return worked(task);
    });
    Notes said;
    CampaignOptions options;
    options.observer = &said;
    SECTION("the same") {
        const CampaignRun run = campaign.run(engine, options);
        CHECK(run.again == 1);
        CHECK(run.accepted == 3);
        CHECK(said.text.empty());
    }
    SECTION("garbage") {
        there = "something else";
        CHECK(campaign.run(engine, options).left == 0);
        CHECK(campaign.result(part.id) == truth);
        CHECK(campaign.rejected(part.id) == "something else");
        CHECK_THAT(said.text, Contains(part.id) && Contains("the second is kept"));
    }
    SECTION("another proof") {
        // 4.6033388487517003 lies between; the ends of the true result are nearer.
        const std::string line = truth.substr(
            truth.find("ratio 4 "), truth.find('\n', truth.find("ratio 4 ")) - truth.find("ratio 4 "));
        there = resealed(truth, line, "ratio 4 4603338848751/1000000000000 4603338848752/1000000000000 128");
        CHECK(campaign.run(engine, options).left == 0);
        CHECK(campaign.result(part.id) == there);
        CHECK(campaign.rejected(part.id) == truth);
        CHECK_THAT(said.text, Contains("the first is kept"));
    }
    CHECK(merge_campaign(*campaign.folder, {}).whole.has_value());
}

TEST_CASE("two words of workers that differ stop the campaign, and both are kept") {
    const std::string file = DUMBBELL_PROJECT "/certificates/stairs-1-100.dbc";
    VerifiedPlan verification = plan_verified(file, 2);
    verification.sources[1] = file;  // there is no verifier next to this test
    Campaign campaign(verification.plan, verification.sources);
    const auto word = [](const Task& task) {
        const auto units = parse_order(task.order).units;
        return fmt::format("s PART of {}\n", units.size());
    };
    ScriptedEngine engine([&](const Task& task, int) {
        (void)campaign.folder->keep_result(task.id, "another word\n");
        return done(task, word(task));
    });
    CHECK_THROWS_AS(campaign.run(engine), ResultsDiffer);
    const auto part =
        campaign.folder->parts()[0].finished ? campaign.folder->parts()[0] : campaign.folder->parts()[1];
    CHECK(campaign.result(part.id) == "another word\n");
    CHECK_THAT(campaign.rejected(part.id), Contains("s PART of"));
}

TEST_CASE("outcomes of tasks that nobody gave are passed over") {
    Campaign campaign;
    int strange = 0;
    ScriptedEngine engine([&](const Task& task, int attempt) {
        if (attempt == 1 && strange++ == 0) {
            return campaign::Outcome{std::string(32, 'f'), campaign::Outcome::End::done, "x", {}, "far", 0};
        }
        return worked(task);
    });
    // The task whose answer went astray is never answered: the run is ended from outside.
    int questions = 0;
    CampaignOptions options;
    options.interrupted = [&] { return ++questions > 50; };
    const CampaignRun run = campaign.run(engine, options);
    CHECK(run.accepted == 3);
    CHECK(run.left == 1);
}

TEST_CASE("a campaign of many shards with failures, garbage, splits and restarts loses nothing") {
    constexpr long last = 302;
    Campaign campaign(small_plan(3, last, 150));
    std::mt19937 random(11);
    std::map<std::string, std::string> answers;  // enclosing takes time
    std::size_t given = 0;                       // outcomes, in one run
    const Script script = [&](const Task& task, int) {
        ++given;
        const auto luck = random() % 10;
        if (luck == 0) {
            return failed(task, "worker lost");
        }
        if (luck == 1) {
            return done(task, "garbage");
        }
        if (luck == 2 && task.limit) {
            return too_long(task);
        }
        auto& answer = answers[task.id];
        if (answer.empty()) {
            answer = worked(task).result;
        }
        return done(task, answer);
    };
    std::size_t accepted = 0;
    for (int run = 0; run < 100 && !is_complete(*campaign.folder); ++run) {
        const auto most = 5 + random() % 40;
        given = 0;
        CampaignOptions options = verified();
        options.shard_limit = std::chrono::seconds(1);
        options.interrupted = [&] { return given >= most; };
        ScriptedEngine engine(script, 16);
        campaign.folder.emplace(campaign.place.string());  // a new program
        accepted += campaign.run(engine, options).accepted;
    }
    CHECK(accepted == campaign.folder->parts().size());
    CHECK(merged(*campaign.folder) == in_one_go(3, last));
}
