#include "campaign/folder.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "base/ended_early.hpp"
#include "base/error.hpp"
#include "file/file_contents.hpp"
#include "place.hpp"
#include "rooms/not_root.hpp"
#include "scripted_engine.hpp"

using namespace dumbbell;
using namespace dumbbell::campaign;
using namespace dumbbell_test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

using Kept = CampaignFolder::Kept;

void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

std::size_t entries(const fs::path& path) {
    return static_cast<std::size_t>(std::distance(fs::recursive_directory_iterator(path), {}));
}

}  // namespace

TEST_CASE("a campaign is found again with its plan, and with what is finished") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    std::string id;
    {
        const CampaignFolder folder(place.string());
        CHECK(folder.plan() == small_plan());
        REQUIRE(folder.parts().size() == 4);
        id = folder.parts()[2].id;
        CHECK(folder.keep_result(id, "result") == Kept::now);
    }
    const CampaignFolder again(place.string());
    for (const auto& part : again.parts()) {
        CHECK(part.finished == (part.id == id));
    }
    CHECK(file_contents(again.result_file(id)) == "result");
}

TEST_CASE("a campaign is made in a folder that is new or empty only") {
    const Place place;
    fs::create_directory(place.path);
    write(place.path / "thesis.tex", "years of work");
    CHECK_THROWS_WITH(CampaignFolder::create(place.string(), small_plan()), Contains("new or empty"));
    CHECK(entries(place.path) == 1);
    fs::remove(place.path / "thesis.tex");
    CampaignFolder::create(place.string(), small_plan());
    CHECK_THROWS_AS(CampaignFolder::create(place.string(), small_plan()), InputError);
}

TEST_CASE("a path lies in the folder or next to it, however it is spelled") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    const CampaignFolder folder(place.string());
    const std::string link = place.string() + "-link";
    fs::remove(link);
    fs::create_directory_symlink(place.path, link);
    const std::string name = place.path.filename().string();
    for (const char* inside : {"/plan", "/m.dbc", "/results/m.dbc", "/results/../m.dbc", "/new/m.dbc"}) {
        CAPTURE(inside);
        CHECK(folder.holds(place.string() + inside));
        CHECK(folder.holds(link + inside));
        CHECK(folder.holds(place.string() + "/../" + name + inside));
    }
    CHECK_FALSE(folder.holds(place.string() + ".dbc"));
    CHECK_FALSE(folder.holds(place.string() + "/../m.dbc"));
    CHECK_FALSE(folder.holds("m.dbc"));
    CHECK_FALSE(folder.holds(link));  // a rename replaces the link
    fs::remove(link);
    fs::create_symlink(link, link);
    CHECK_FALSE(folder.holds(link + "/m.dbc"));  // leads nowhere
    fs::remove(link);
}

TEST_CASE("what is no campaign is refused, and nothing is changed") {
    const Place place;
    CHECK_THROWS_WITH(CampaignFolder(place.string()), Contains("is not a campaign"));
    fs::create_directory(place.path);
    CHECK_THROWS_WITH(CampaignFolder(place.string()), Contains("dumbbell campaign plan"));
    write(place.path / "plan", "dumbbell-campaign 1\n");
    CHECK_THROWS_WITH(CampaignFolder(place.string()), Contains("damaged"));
    CHECK(entries(place.path) == 1);
}

TEST_CASE("a foreign file is named, and neither used nor deleted") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    for (const char* name : {"notes.txt", "results/notes.txt", "splits/x", "plan.bak"}) {
        CAPTURE(name);
        write(place.path / name, "mine");
        CHECK_THROWS_WITH(CampaignFolder(place.string()), Contains(name) && Contains("move it elsewhere"));
        CHECK(file_contents((place.path / name).string()) == "mine");
        fs::remove(place.path / name);
    }
    fs::create_directory(place.path / "old");
    CHECK_THROWS_WITH(CampaignFolder(place.string()), Contains("old"));
    fs::remove(place.path / "old");
    const std::string id = CampaignFolder(place.string()).parts().front().id;
    for (const std::string& name : {"results/" + id, "splits/" + id, std::string("journal")}) {
        CAPTURE(name);
        REQUIRE(::mkfifo((place.path / name).c_str(), 0600) == 0);  // a program that opens it waits for ever
        CHECK_THROWS_WITH(CampaignFolder(place.string()), Contains(name) && Contains("move it elsewhere"));
        fs::remove(place.path / name);
    }
    CHECK_NOTHROW(CampaignFolder(place.string()));
}

TEST_CASE("what cannot be read is named") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    const std::string id = CampaignFolder(place.string()).parts().front().id;
    fs::create_symlink(id, place.path / "results" / id);
    CHECK_THROWS_WITH(CampaignFolder(place.string()), Contains("cannot read") && Contains(id));
}

TEST_CASE("a plan or a journal that cannot be read is called neither missing nor damaged") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    write(place.path / "journal", "");
    for (const char* name : {"plan", "journal"}) {
        const std::string file = (place.path / name).string();
        const fs::perms before = fs::status(file).permissions();
        fs::permissions(file, fs::perms::none);
        {
            const NotRoot user;
            CHECK_THROWS_WITH(CampaignFolder(place.string()),
                              "cannot read '" + file + "': Permission denied");
        }
        fs::permissions(file, before);
    }
    fs::remove(place.path / "plan");
    fs::create_symlink("plan", place.path / "plan");
    CHECK_THROWS_WITH(CampaignFolder(place.string()), Contains("plan': Too many levels of symbolic links"));
}

TEST_CASE("a plan whose inputs cannot be copied leaves nothing in its folder") {
    const Place place;
    Plan plan = small_plan();
    plan.inputs = {"certificate.dbc"};
    CHECK_THROWS_WITH(CampaignFolder::create(place.string(), plan, {"/no/such/file"}),
                      Contains("/no/such/file"));
    CHECK_NOTHROW(CampaignFolder::require_new(place.string()));
}

TEST_CASE("a campaign that is interrupted while it is made leaves nothing") {
    const Place place;
    CHECK_THROWS_AS(CampaignFolder::create(place.string(), small_plan(), {}, [] { return true; }),
                    EndedEarly);
    CHECK_FALSE(fs::exists(place.path));
}

TEST_CASE("a result of another plan is foreign, too") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    write(place.path / "results" / std::string(32, 'a'), "");
    CHECK_THROWS_WITH(CampaignFolder(place.string()), Contains("belongs to no shard of the plan"));
}

TEST_CASE("what a killed program leaves is no foreign file") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    write(place.path / "plan.dumbbell-tmp", "");
    write(place.path / "results" / (std::string(32, 'a') + ".dumbbell-tmp"), "");
    CHECK_NOTHROW(CampaignFolder(place.string()));
}

TEST_CASE("a plan that was changed after the start is refused, even with a right checksum") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    {
        CampaignFolder folder(place.string());
        folder.journal().append({0, JournalEntry::What::begin, "", "", 0, folder.plan_digest()});
    }
    CHECK_NOTHROW(CampaignFolder(place.string()));
    write(place.path / "plan", render(small_plan(3, 15)));
    CHECK_THROWS_WITH(CampaignFolder(place.string()), Contains("was changed after the start"));
}

TEST_CASE("a result is kept once: the same again changes nothing, and neither does another one") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    const CampaignFolder folder(place.string());
    const std::string id = folder.parts().front().id;
    CHECK(folder.keep_result(id, "one") == Kept::now);
    CHECK(folder.keep_result(id, "one") == Kept::before);
    CHECK(folder.keep_result(id, "two") == Kept::other);
    CHECK(file_contents(folder.result_file(id)) == "one");
}

TEST_CASE("a split shard is its halves, down to single units, and all units stay covered") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    const CampaignFolder folder(place.string());
    for (int round = 0; round < 4; ++round) {
        for (const auto& part : folder.parts()) {
            if (part.end - part.first > 1) {
                folder.split(part.id);
            }
        }
        std::size_t covered = 0;
        for (const auto& part : folder.parts()) {
            CHECK(part.first == covered);
            covered = part.end;
        }
        CHECK(covered == 12);
    }
    CHECK(folder.parts().size() == 12);
    CHECK_NOTHROW(CampaignFolder(place.string()));
}

TEST_CASE("two programs do not change one campaign at the same time") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    CampaignFolder folder(place.string());
    CHECK_FALSE(folder.is_locked_by_another());
    {
        CampaignFolder other(place.string());
        other.lock();
        CHECK(folder.is_locked_by_another());
        CHECK_THROWS_WITH(folder.lock(), Contains("in use by another run"));
    }
    CHECK_NOTHROW(folder.lock());
}

TEST_CASE("a result that is withdrawn is no longer finished, and still there for a look") {
    const Place place;
    CampaignFolder::create(place.string(), small_plan());
    const CampaignFolder folder(place.string());
    const std::string id = folder.parts().front().id;
    CHECK(folder.keep_result(id, "wrong") == Kept::now);
    folder.withdraw_result(id);
    CHECK_FALSE(folder.has_result(id));
    CHECK(file_contents((place.path / "rejected" / id).string()) == "wrong");
}
