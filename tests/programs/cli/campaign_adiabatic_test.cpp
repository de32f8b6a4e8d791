// dumbbell campaign over statements about the adiabatic invariant, with the verifier as the judge.
#include <catch2/catch.hpp>
#include <sstream>

#include "programs.hpp"

using namespace dumbbell_test;
using Catch::Matchers::Contains;

namespace {

/// A campaign in `grid` of the folder, planned.
class Campaign {
  public:
    explicit Campaign(Words options) {
        options.insert(options.begin(), {"campaign", "plan", "grid", "adiabatic"});
        const Outcome planned = dumbbell(options, folder.path());
        CAPTURE(planned.err);
        REQUIRE(planned.code == 0);
    }
    Outcome run() { return dumbbell({"campaign", "run", "grid", "--quiet"}, folder.path()); }
    Outcome merge() {
        return dumbbell({"campaign", "merge", "grid", "--out", "table.tsv", "--quiet"}, folder.path());
    }

    const TemporaryFolder folder;
};

/// The cells of each line of a table, but not the remarks.
std::vector<Words> rows(const std::string& table) {
    std::vector<Words> result;
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("#")) {
            continue;
        }
        Words cells;
        std::istringstream parts(line);
        for (std::string cell; std::getline(parts, cell, '\t');) {
            cells.push_back(cell);
        }
        result.push_back(cells);
    }
    return result;
}

const Words bounces{"--theorem", "lemma3.1", "--delta", "0.01,0.02:0.03,0.05"};

}  // namespace

TEST_CASE(
    "a grid is planned, run and merged, and each line has the certificate that adiabatic --out writes") {
    Campaign campaign(bounces);
    CHECK(campaign.run().code == 0);
    CHECK(campaign.merge().code == 0);
    const auto table = rows(contents(campaign.folder / "table.tsv"));
    REQUIRE(table.size() == 3);
    const Words deltas{"0.01", "0.02:0.03", "0.05"};
    for (std::size_t i = 0; i < table.size(); ++i) {
        REQUIRE(table[i].size() == 13);
        CAPTURE(table[i]);
        const std::string file = "grid/" + table[i][12];
        REQUIRE(dumbbell({"adiabatic", "--theorem", "lemma3.1", "--delta", deltas[i], "--out", "one.dbc"},
                         campaign.folder.path())
                    .code == 0);
        CHECK(contents(campaign.folder / file) == contents(campaign.folder / "one.dbc"));
        const Outcome verified = verifier({"--claim", "adiabatic-bounce", file}, campaign.folder.path());
        CHECK(verified.code == 0);
        CHECK_THAT(last_line(verified.out), Contains("sha256=" + table[i][11]));
    }
}

TEST_CASE("whatever the theorem, the judge accepts what was proved") {
    for (const Words& options :
         std::vector<Words>{{"--delta", "0.1,0.01", "--phi-margin", "1"},
                            {"--delta", "0.01,0.02", "--theorem", "printed"},
                            {"--delta", "0.01", "--theorem", "cor3.2", "--k", "1/2,1/4"}}) {
        Campaign campaign(options);
        CAPTURE(options);
        CHECK(campaign.run().code == 0);
        CHECK(campaign.merge().code == 0);
        CHECK(rows(contents(campaign.folder / "table.tsv")).size() == 2);
    }
}

TEST_CASE("the certificate of another statement is withdrawn at the merge, and the true one proved again") {
    Campaign campaign(bounces);
    REQUIRE(campaign.run().code == 0);
    REQUIRE(campaign.merge().code == 0);
    const std::string table = contents(campaign.folder / "table.tsv");
    const std::string first = campaign.folder / ("grid/" + rows(table)[0][12]);
    const std::string last = campaign.folder / ("grid/" + rows(table)[2][12]);
    const std::string bytes = contents(last);

    const auto withdrawn = [&](const std::string& reason) {
        std::filesystem::remove(campaign.folder / "table.tsv");
        const Outcome merged = campaign.merge();
        CHECK(merged.code == 3);
        CHECK_THAT(merged.err, Contains("1 of 3 results were not verified") && Contains(reason));
        CHECK_FALSE(std::filesystem::exists(last));
        CHECK_FALSE(std::filesystem::exists(campaign.folder / "table.tsv"));
        CHECK(campaign.run().code == 0);
        CHECK(contents(last) == bytes);
    };
    write_file(last, contents(first));
    withdrawn("it proves something else");
    const std::string other = campaign.folder / "other.dbc";
    REQUIRE(dumbbell({"adiabatic", "--delta", "0.01", "--theorem", "printed", "--out", other}).code == 0);
    std::filesystem::rename(other, last);
    withdrawn("it proves something else");
    write_file(last, bytes.substr(0, bytes.size() / 2));
    withdrawn("is damaged");
    CHECK(campaign.merge().code == 0);
    CHECK(contents(campaign.folder / "table.tsv") == table);
}

TEST_CASE("grids that make no sense are refused in one line, and nothing is planned") {
    const auto reason = [](Words options) {
        options.insert(options.begin(), {"campaign", "plan", "grid"});
        return refused(options);
    };
    CHECK_THAT(reason({"adiabatic", "--delta", "0.01"}), Contains("use dumbbell adiabatic --out"));
    CHECK_THAT(reason({"adiabatic", "--delta", "0.01,1/100"}), Contains("twice"));
    CHECK_THAT(reason({"adiabatic", "--delta", "0.01,"}), Contains("--delta"));
    CHECK_THAT(reason({"adiabatic", "--delta", "0.01,0.5"}), Contains("between 0 and 1/2"));
    CHECK_THAT(reason({"adiabatic", "--delta", "0.01,0.03:0.02"}), Contains("reversed"));
    CHECK_THAT(reason({"adiabatic", "--delta", "0.01,0.02", "--accuracy", "2"}), Contains("--accuracy"));
    CHECK_THAT(reason({"adiabatic", "--delta", "0.01,0.02", "--k", "1/2"}), Contains("cor3.2 only"));
    CHECK_THAT(reason({"--shards", "2", "adiabatic", "--delta", "0.01,0.02"}), Contains("--shards"));
    CHECK_THAT(reason({"--gap", "1e-3", "adiabatic", "--delta", "0.01,0.02"}), Contains("--gap"));
    CHECK_THAT(reason({"1:9", "adiabatic", "--delta", "0.01,0.02"}), Contains("RATIO"));
    std::string many = "0.1";
    for (int i = 2; i <= 400; ++i) {
        many += ",0." + std::to_string(10000 + i);
    }
    CHECK_THAT(reason({"adiabatic", "--delta", many, "--phi-margin", many}), Contains("more than 100000"));
}
