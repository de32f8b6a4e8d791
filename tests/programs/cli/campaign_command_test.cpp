// A campaign as a user runs it, on this machine: plan, run, status, merge.
#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <sstream>

#include "programs.hpp"

using namespace dumbbell_test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

const std::string small = "1:2000";

/// In the folder: a campaign `c` over a small range.
void plan(const TemporaryFolder& folder, const std::string& ratio = small, const Words& options = {}) {
    Words words{"campaign", "plan", folder / "c", ratio};
    words.insert(words.end(), options.begin(), options.end());
    const Outcome planned = dumbbell(words);
    CAPTURE(planned.err);
    REQUIRE(planned.code == 0);
}

Outcome run_it(const TemporaryFolder& folder, const Words& options = {}) {
    Words words{"campaign", "run", folder / "c"};
    words.insert(words.end(), options.begin(), options.end());
    return dumbbell(words);
}

Outcome merge_it(const TemporaryFolder& folder) {
    return dumbbell({"campaign", "merge", folder / "c", "--out", folder / "m.dbc"});
}

std::string in_one_go(const TemporaryFolder& folder, const std::string& ratio, Words options = {}) {
    return contents(certificate(folder, ratio, std::move(options)));
}

std::size_t shards(const TemporaryFolder& folder) {
    return nlohmann::json::parse(dumbbell({"campaign", "status", folder / "c", "--json"}).out)["shards"];
}

std::string any_result(const TemporaryFolder& folder) {
    return fs::directory_iterator(folder / "c/results")->path().string();
}

/// Of the right form, and complete, but one leaf claims fewer collisions than there are.
void falsify(const std::string& result) {
    std::string text = contents(result);
    const auto leaf = text.find("\ncount ");
    write_sealed(result, text.replace(leaf, text.find('\n', leaf + 1) - leaf, "\ncount 0 0"));
}

/// The same certificate with nothing said of its pieces.
std::string undecided(const std::string& text) {
    std::istringstream in(text);
    std::string made;
    int pieces = 0;
    for (std::string line; std::getline(in, line) && !line.starts_with("total ");) {
        if (line.starts_with("piece ")) {
            ++pieces;
            made += line + "\nbits 53\nupper none\nlower 0\n";
        } else if (pieces == 0) {
            made += line + "\n";
        }
    }
    for (const char* kind :
         {"split", "count", "outside", "meets", "meets-reversed", "equal-masses", "witness"}) {
        made += std::string("total ") + kind + " 0\n";
    }
    return made + "total open " + std::to_string(pieces) + "\nsha256 x\n";
}

/// One line on stderr, exit code 2, and all files as they were.
std::string refused_here(const TemporaryFolder& folder, const Words& words) {
    const auto files = [&] {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
            all[entry.path().string()] = entry.is_regular_file() ? contents(entry.path().string()) : "";
        }
        return all;
    };
    const auto before = files();
    const Outcome result = dumbbell(words);
    CAPTURE(result.out, result.err);
    CHECK(result.code == 2);
    CHECK(result.out.empty());
    CHECK(count_lines(result.err) == 1);
    CHECK((files() == before));
    return result.err;
}

}  // namespace

TEST_CASE("planned, run and merged, a claim is the file that certify writes, byte for byte") {
    const TemporaryFolder folder;
    plan(folder, "1:5000", {"--gap", "1e-9"});
    const Outcome ran = run_it(folder);
    CHECK(ran.code == 0);
    CHECK_THAT(ran.out, Contains("the campaign is complete") && Contains("ms a shard"));
    const Outcome merged = merge_it(folder);
    CHECK(merged.code == 0);
    CHECK_THAT(merged.out, Contains("they tile the claim: certify 1/1:5000/1 --gap 1/1000000000"));
    CHECK(contents(folder / "m.dbc") == in_one_go(folder, "1:5000", {"--gap", "1e-9"}));
    CHECK(verifier({"--ratio", "1:5000", folder / "m.dbc"}).code == 0);
}

TEST_CASE("a campaign over critical ratios is the table that critical writes") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell({"campaign", "plan", folder / "c", "critical", "3:40", "--digits", "30"}).code == 0);
    REQUIRE(run_it(folder).code == 0);
    REQUIRE(dumbbell({"campaign", "merge", folder / "c", "--out", folder / "m.tsv"}).code == 0);
    REQUIRE(dumbbell({"critical", "3:40", "--digits", "30", "--out", folder / "t.tsv"}).code == 0);
    CHECK(contents(folder / "m.tsv") == contents(folder / "t.tsv"));
}

TEST_CASE("the result does not depend on the number of threads and shards") {
    std::string first;
    for (const Words& options : {Words{"--shards", "1"}, {"--shards", "7"}, {"--shards", "1000"}}) {
        const TemporaryFolder folder;
        plan(folder, small, options);
        REQUIRE(run_it(folder, {"--jobs", options[1] == "7" ? "1" : "4"}).code == 0);
        REQUIRE(merge_it(folder).code == 0);
        first = first.empty() ? contents(folder / "m.dbc") : first;
        CHECK(contents(folder / "m.dbc") == first);
    }
}

TEST_CASE("killed at any moment, a campaign goes on and ends with the same bytes") {
    std::mt19937 random(5);
    for (int kills = 0; kills <= 3;) {  // a run may be done before it is killed
        const TemporaryFolder folder;
        plan(folder, "1:30000", {"--gap", "1e-12", "--shards", "200"});
        const std::size_t all = shards(folder);
        for (std::size_t wanted = 3; kept(folder / "c/results") < all; wanted += 5 + random() % 30) {
            Process process(with_program({"campaign", "run", folder / "c"}));
            process.until([&] { return kept(folder / "c/results") >= std::min(wanted, all); });
            process.kill();
            kills += process.wait().signal == SIGKILL;
            REQUIRE(kills < 200);
        }
        REQUIRE(run_it(folder).code == 0);
        REQUIRE(merge_it(folder).code == 0);
        CHECK(contents(folder / "m.dbc") == in_one_go(folder, "1:30000", {"--gap", "1e-12"}));
    }
}

TEST_CASE("a campaign out of time says so with exit code 3, and goes on") {
    const TemporaryFolder folder;
    plan(folder, "1:1e6", {"--gap", "1e-9"});
    const Outcome late = run_it(folder, {"--budget", "0.2s"});
    CHECK(late.code == 3);
    CHECK_THAT(late.err, Contains("left: the same command goes on"));
    const Outcome early = merge_it(folder);
    CHECK(early.code == 3);
    CHECK_THAT(early.err, Contains("are not finished") && Contains("dumbbell campaign run"));
    CHECK_FALSE(fs::exists(folder / "m.dbc"));
}

TEST_CASE("asked to stop, a campaign stops soon, says what is left, and ends by the signal") {
    const TemporaryFolder folder;
    plan(folder, "1:2e6", {"--gap", "1e-9"});
    Process process(with_program({"campaign", "run", folder / "c"}));
    REQUIRE(process.until([&] { return kept(folder / "c/results") >= 1; }));
    process.send(SIGTERM);
    const Outcome stopped = process.wait();
    CHECK(stopped.signal == SIGTERM);
    CHECK_THAT(stopped.err, Contains("stopped by SIGTERM") && Contains(" left: the same command goes on"));
}

TEST_CASE("the status is told at any time, as text and as JSON") {
    const TemporaryFolder folder;
    plan(folder);
    const Outcome before = dumbbell({"campaign", "status", folder / "c"});
    CHECK(before.code == 0);
    CHECK_THAT(before.out, Contains("0 of ") && Contains("no run is at work"));
    REQUIRE(run_it(folder).code == 0);
    const Outcome after = dumbbell({"campaign", "status", folder / "c", "--json"});
    const auto json = nlohmann::json::parse(after.out);
    CHECK(json["complete"] == true);
    CHECK(json["done"] == json["shards"]);
    CHECK(json["workers"][0]["name"] == "local");
    CHECK(count_lines(dumbbell({"campaign", "status", folder / "c", "--quiet"}).out) == 1);
    const auto run = nlohmann::json::parse(run_it(folder, {"--json"}).out);
    CHECK(run["schema"] == "dumbbell-campaign-run-1");
    CHECK(run["accepted"] == 0);
    CHECK(run["complete"] == true);
}

TEST_CASE("a merged file is not put into the campaign's folder, least of all over its plan") {
    const TemporaryFolder folder;
    plan(folder, "1:10");
    REQUIRE(run_it(folder, {"--quiet"}).code == 0);
    for (const char* inside : {"c/plan", "c/m.dbc", "c/results/m.dbc", "c/../c/plan"}) {
        CAPTURE(inside);
        CHECK_THAT(refused_here(folder, {"campaign", "merge", folder / "c", "--out", folder / inside}),
                   Contains("lies in the campaign's folder") && Contains("give another place"));
    }
    CHECK(merge_it(folder).code == 0);
}

TEST_CASE("a result that was tampered with is found whatever the program was started with") {
    const TemporaryFolder folder;
    plan(folder);
    REQUIRE(run_it(folder).code == 0);
    falsify(any_result(folder));
    const Outcome merged = run({"bash", "-c", "trap '' CHLD; exec \"$@\"", "-", DUMBBELL_BIN, "campaign",
                                "merge", folder / "c", "--out", folder / "m.dbc"});
    CHECK(merged.code == 3);
    CHECK_THAT(merged.err, Contains("not verified: s REJECTED"));
    CHECK_FALSE(fs::exists(folder / "m.dbc"));
}

TEST_CASE("a result that was tampered with is found by the merge, put aside, and proved again") {
    const TemporaryFolder folder;
    plan(folder);
    REQUIRE(run_it(folder).code == 0);
    const std::string result = any_result(folder);
    const std::string truth = contents(result);
    write_file(folder / "r", truth);
    REQUIRE(run({"gzip", folder / "r"}).code == 0);
    for (const auto& [spoiled, fault] :
         {std::pair{truth.substr(0, truth.size() / 2), "rejected"},
          {contents(folder / "r.gz"), "it is compressed, and results are plain text"}}) {
        CAPTURE(fault);
        write_file(result, spoiled);
        const Outcome merged = merge_it(folder);
        CHECK(merged.code == 3);
        CHECK_THAT(merged.err, Contains("1 of ") && Contains(fault) && Contains("proves them again"));
        CHECK_FALSE(fs::exists(folder / "m.dbc"));
        REQUIRE(run_it(folder).code == 0);
        CHECK(contents(result) == truth);
    }
    CHECK(merge_it(folder).code == 0);
}

TEST_CASE("a true certificate of something else is no result") {
    const TemporaryFolder folder;
    plan(folder);
    REQUIRE(run_it(folder).code == 0);
    write_file(any_result(folder), in_one_go(folder, "3:4"));
    const Outcome merged = merge_it(folder);
    CHECK(merged.code == 3);
    CHECK_THAT(merged.err, Contains("it proves something else"));
}

TEST_CASE("the commands that a campaign names next can be pasted, whatever its folder is called") {
    const TemporaryFolder folder;
    for (const auto& [name, quoted] : {std::pair{"my campaign", "'my campaign'"}, {"a\tb", "$'a\\011b'"}}) {
        const Outcome planned = dumbbell({"campaign", "plan", name, "1:10"}, folder.path());
        CHECK_THAT(planned.out, Contains(std::string("dumbbell campaign run ") + quoted + "\n"));
        const Outcome early = dumbbell({"campaign", "merge", name, "--out", "m.dbc"}, folder.path());
        CHECK_THAT(early.err, Contains(std::string("dumbbell campaign run ") + quoted + " goes on"));
        const Outcome pasted =
            run({"bash", "-c", std::string(DUMBBELL_BIN) + " campaign run " + quoted}, folder.path());
        CHECK(pasted.code == 0);
    }
}

TEST_CASE("workers are refused a campaign whose folder they could not name") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell({"campaign", "plan", "a\tb", "1:10"}, folder.path()).code == 0);
    const Outcome run = dumbbell({"campaign", "run", "a\tb", "--engine", "workqueue"}, folder.path());
    CHECK(run.code == 2);
    CHECK(count_lines(run.err) == 1);
    CHECK_THAT(run.err, Contains("/a?b' has a character in its name that not every shell"));
}

TEST_CASE("results that leave all undecided spoil nothing") {
    const TemporaryFolder folder;
    plan(folder);
    REQUIRE(run_it(folder).code == 0);
    const std::string result = any_result(folder);
    const std::string truth = contents(result);
    write_sealed(result, undecided(truth));
    CHECK(run_it(folder).code == 0);
    CHECK(merge_it(folder).code == 3);
    const Outcome again = run_it(folder, {"--again"});
    CHECK(again.code == 0);
    CHECK_THAT(again.err, Contains("shards that left something undecided, and are tried again: 1"));
    CHECK(contents(result) == truth);
    CHECK(merge_it(folder).code == 0);
}

TEST_CASE("joined without verification, a false result is in the file, which says so to the verifier") {
    const TemporaryFolder folder;
    plan(folder);
    REQUIRE(run_it(folder).code == 0);
    const Words only_join{"campaign", "merge", folder / "c", "--out", folder / "m.dbc", "--unverified"};
    const Outcome joined = dumbbell(only_join);
    CHECK(joined.code == 0);
    CHECK_THAT(joined.out, Contains("shards NOT verified"));
    CHECK(contents(folder / "m.dbc") == in_one_go(folder, small));

    falsify(any_result(folder));
    CHECK(dumbbell(only_join).code == 0);
    CHECK(verifier({folder / "m.dbc"}).code == 1);
    CHECK_THAT(merge_it(folder).err, Contains("not verified: s REJECTED"));
}

TEST_CASE("what stands in the way of a campaign is said in one line, and nothing is changed") {
    const TemporaryFolder folder;
    plan(folder);
    const std::string campaign = folder / "c";
    CHECK_THAT(refused_here(folder, {"campaign", "plan", campaign, small}), Contains("new or empty"));
    CHECK_THAT(refused_here(folder, {"campaign", "run", folder.path()}), Contains("is not a campaign"));
    CHECK_THAT(refused_here(folder, {"campaign", "status", folder / "none"}), Contains("is not a campaign"));
    CHECK_THAT(refused_here(folder, {"campaign", "merge", campaign, "--out", folder.path()}),
               Contains("is a directory"));

    write_file(campaign + "/results/notes", "mine");
    for (const char* word : {"run", "status"}) {
        CHECK_THAT(refused_here(folder, {"campaign", word, campaign}),
                   Contains("notes") && Contains("move it"));
    }
    fs::remove(campaign + "/results/notes");

    const std::string text = contents(campaign + "/plan");
    write_file(campaign + "/plan",
               replaced(text, "generator dumbbell " DUMBBELL_VERSION, "generator dumbbell 9.9.9"));
    CHECK_THAT(refused_here(folder, {"campaign", "run", campaign}), Contains("damaged"));
    write_file(campaign + "/plan", text.substr(0, text.size() - 1));
    CHECK_THAT(refused_here(folder, {"campaign", "run", campaign}), Contains("damaged"));
    write_file(campaign + "/plan", text);
}

TEST_CASE("one campaign has one run at a time") {
    const TemporaryFolder folder;
    plan(folder, "1:2e6", {"--gap", "1e-9", "--shards", "20"});
    Process process(with_program({"campaign", "run", folder / "c"}));
    REQUIRE(process.until([&] { return fs::exists(folder / "c/journal"); }));
    process.send(SIGSTOP);
    const Outcome second = run_it(folder);
    CHECK(second.code == 2);
    CHECK_THAT(second.err, Contains("in use by another run"));
    CHECK_THAT(dumbbell({"campaign", "status", folder / "c"}).out, Contains("running: "));
    process.kill();
}

TEST_CASE("a plan that was changed after the start is refused") {
    const TemporaryFolder folder;
    plan(folder);
    REQUIRE(run_it(folder).code == 0);
    const TemporaryFolder other;
    plan(other, small, {"--shards", "3"});
    write_file(folder / "c/plan", contents(other / "c/plan"));
    CHECK_THAT(refused_here(folder, {"campaign", "run", folder / "c"}),
               Contains("was changed after the start"));
}

TEST_CASE("claims that make no campaign are refused, with what to do") {
    CHECK_THAT(refused({"campaign", "plan", "c", "10"}), Contains("use dumbbell certify"));
    CHECK_THAT(refused({"campaign", "plan", "c", "critical", "5"}), Contains("use dumbbell critical"));
    CHECK_THAT(refused({"campaign", "plan", "c"}), Contains("give the claim"));
    CHECK_THAT(refused({"campaign", "plan", "c", "1:5", "critical", "3:5"}), Contains("give either"));
    CHECK_THAT(refused({"campaign", "plan", "c", "5:1"}), Contains("smaller ratio first"));
    CHECK_THAT(refused({"campaign", "plan", "c", "1:5", "--shards", "0"}), Contains("--shards"));
    CHECK_THAT(refused({"campaign", "plan", "c", "1:5", "--lemmas", "none"}), Contains("--section full"));
    CHECK_THAT(refused({"campaign"}), Contains("--help"));
}

TEST_CASE(
    "a claim's name where the folder should stand plans nothing, and its help shows where the folder "
    "stands") {
    const TemporaryFolder folder;
    for (const Words& claim :
         {Words{"critical", "3:20"}, {"critical"}, {"adiabatic", "1:2"}, {"verify", "1:9"}}) {
        Words words{"campaign", "plan"};
        words.insert(words.end(), claim.begin(), claim.end());
        const Outcome forgotten = dumbbell(words, folder.path());
        CHECK(forgotten.code == 2);
        CHECK_THAT(forgotten.err,
                   Contains("the folder is missing: dumbbell campaign plan FOLDER " + claim[0]));
        CHECK(folder.names().empty());
    }
    for (const Words& before : {Words{}, {"some.campaign"}}) {
        Words words{"campaign", "plan"};
        words.insert(words.end(), before.begin(), before.end());
        words.insert(words.end(), {"critical", "--help"});
        const Outcome help = dumbbell(words);
        CHECK(help.code == 0);
        CHECK_THAT(help.out, Contains("dumbbell campaign plan FOLDER critical [OPTIONS] N1:N2"));
    }
    CHECK_THAT(dumbbell({"campaign", "plan", "--help"}).out,
               Contains("dumbbell campaign plan [OPTIONS] FOLDER"));
    CHECK(dumbbell({"campaign", "plan", "./critical", "critical", "3:20"}, folder.path()).code == 0);
    CHECK(folder.names() == Words{"critical"});
}

TEST_CASE("the number of shards may stand before and after what is planned") {
    const TemporaryFolder folder;
    CHECK(dumbbell({"campaign", "plan", folder / "c", "critical", "3:40", "--shards", "5"}).code == 0);
    CHECK(shards(folder) == 5);
    CHECK_THAT(refused({"campaign", "plan", "d", "critical", "3:40", "--gap", "1e-3"}),
               Contains("give either"));
}

TEST_CASE("a folder that is there is refused before anything is planned") {
    const TemporaryFolder folder;
    plan(folder);
    CHECK_THAT(refused_here(folder, {"campaign", "plan", folder / "c", "1:1e9"}),
               Contains("is there already"));
}

TEST_CASE("limits of shards that are none are refused, by their option's name") {
    const TemporaryFolder folder;
    plan(folder);
    for (const char* limit : {"0s", "abc", "-1s"}) {
        CHECK_THAT(refused_here(folder, {"campaign", "run", folder / "c", "--shard-limit", limit}),
                   Contains("--shard-limit"));
    }
}

TEST_CASE("a table is not merged unverified, since nobody can verify it later") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell({"campaign", "plan", folder / "c", "critical", "3:9"}).code == 0);
    REQUIRE(run_it(folder).code == 0);
    CHECK_THAT(
        refused_here(folder, {"campaign", "merge", folder / "c", "--out", folder / "t.tsv", "--unverified"}),
        Contains("merge without --unverified"));
}

TEST_CASE("a worker refuses an order that is damaged or of another version") {
    const TemporaryFolder folder;
    write_file(folder / "order", "dumbbell-order 1\n");
    CHECK_THAT(refused_here(folder, {"campaign", "work", folder / "order", folder / "result"}),
               Contains("damaged"));
    CHECK_THAT(refused_here(folder, {"campaign", "work", folder / "none", folder / "result"}),
               Contains("none': no such file"));
}
