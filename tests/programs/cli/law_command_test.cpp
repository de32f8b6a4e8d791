#include <catch2/catch.hpp>
#include <tuple>

#include "programs.hpp"

using namespace dumbbell_test;
using Catch::Matchers::Contains;

TEST_CASE("law proves what a staircase says as a whole") {
    const TemporaryFolder folder;
    const std::string stairs = certificate(folder, "1:1000", {"--gap", "1e-9"});
    const Outcome law = dumbbell({"law", stairs});
    CHECK(law.code == 0);
    CHECK(law.err.empty());
    CHECK_THAT(law.out, Contains("s VERIFIED") && Contains("N is 2 at q = 1 and 29 at q = 1000: ") &&
                            Contains("Proved:     N(q) <= ceil(pi/gamma)") && !Contains("NOT proved") &&
                            Contains("85595129452713911412021948914557673005795294602"));
    const auto json = nlohmann::json::parse(dumbbell({"law", stairs, "--json", "--digits", "20"}).out);
    CHECK(json["schema"] == "dumbbell-law-1");
    CHECK(json["never_decreases"] == true);
    CHECK(json["below_paper_bound"] == true);
    CHECK(json["sup"]["hi"].get<double>() == Approx(2.1144048705).epsilon(1e-10));
}

TEST_CASE("law believes only what the verifier has accepted") {
    const TemporaryFolder folder;
    const std::string stairs = certificate(folder, "2:12");
    std::string text = contents(stairs);
    text.replace(text.find("upper 4"), 7, "upper 3");
    write_file(stairs, text);
    CHECK_THAT(refused({"law", stairs}), Contains("is not verified: s REJECTED"));
}

TEST_CASE("law needs a staircase of the dumbbell, without open pieces") {
    const TemporaryFolder folder;
    CHECK_THAT(refused({"law", certificate(folder, "10")}), Contains("is not a staircase"));
    for (const char* scene : {"wedge", "hybrid"}) {
        CHECK_THAT(refused({"law", certificate(folder, "2:4", {"--scene", scene})}),
                   Contains(std::string("of the scene ") + scene + ": the law is one of the dumbbell"));
    }
    CHECK_THAT(refused({"law", folder / "missing.dbc"}), Contains("missing.dbc': no such file"));
    const std::string open = folder / "open.dbc";
    CHECK(dumbbell({"certify", "2:100000", "--budget", "0s", "--out", open}).code == 3);
    const Outcome law = dumbbell({"law", open});
    CHECK(law.code == 3);
    CHECK_THAT(law.out, Contains("NOT proved: at least one piece of this staircase is open"));
}

TEST_CASE("law, audit and plot say what they read when given a certificate about initial conditions") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell({"trace", "10", "--phi", "0.3:0.31", "--phidot", "0", "--y", "3", "--ydot", "-1",
                      "--subdivide", "--out", "box.dbc"},
                     folder.path())
                .code == 0);
    const std::string ratios = "a certificate with a cover of mass ratios is needed";
    for (const auto& [command, needed] : std::vector<std::pair<Words, std::string>>{
             {{"law"}, ratios},
             {{"audit"}, ratios},
             {{"plot", "staircase", "--out", "x.svg"}, "needs a certificate by dumbbell certify LO:HI"}}) {
        Words words = command;
        words.emplace_back("box.dbc");
        const Outcome result = dumbbell(words, folder.path());
        CAPTURE(command);
        CHECK(result.code == 2);
        CHECK(result.out.empty());
        CHECK(count_lines(result.err) == 1);
        CHECK_THAT(result.err, Contains("'box.dbc' is about initial conditions") && Contains(needed));
    }
    CHECK(folder.names() == Words{"box.dbc"});
    (void)dumbbell({"trace", "10", "--incoming", "--subdivide", "--max-boxes", "20", "--out", "in.dbc"},
                   folder.path());
    CHECK_THAT(dumbbell({"law", "in.dbc"}, folder.path()).err,
               Contains("'in.dbc' is about all incoming trajectories"));
}

TEST_CASE("law without a file states the law for every mass ratio, and what the verifier says of it") {
    const Outcome law = dumbbell({"law"});
    CHECK(law.code == 0);
    CHECK(law.err.empty());
    CHECK_THAT(law.out, Contains("2 + floor(C sqrt q - c0 q^(-1/4)) <= N(q) <= 2 + floor(C sqrt q)") &&
                            Contains("0.88559512945271391141202194891455767300579529460285...") &&
                            Contains("0.205811589549495595339706567") && Contains("s VERIFIED"));
    CHECK(dumbbell({"law", DUMBBELL_PROJECT "/certificates/law.dbc.gz", "--quiet"}).out ==
          dumbbell({"law", "--quiet"}).out);
}

TEST_CASE("a program without its certificates says how to name that of the law") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "bin");
    std::filesystem::copy_file(DUMBBELL_BIN, folder / "bin/dumbbell");
    const auto said = [&folder](Words words) {
        words.insert(words.begin(), folder / "bin/dumbbell");
        const Outcome result = run(std::move(words), folder.path());
        CHECK(result.code == 2);
        CHECK(count_lines(result.err) == 1);
        return result.err;
    };
    const std::string missing =
        "dumbbell: the certificate law.dbc.gz that comes with this program is not found: install the program "
        "with its certificates";
    const std::string named = missing + ", or name the file: dumbbell ";
    CHECK(said({"law"}) == named + "law FILE\n");
    CHECK(said({"law", "--ratio", "5"}) == named + "law FILE --ratio Q\n");
    CHECK(said({"certify", "10", "--by", "law"}) == named + "certify Q --by law --law FILE\n");
    CHECK(said({"critical", "903", "--by", "law"}) == missing + "\n");
}

TEST_CASE("law believes no certificate of the law that the verifier rejects") {
    const TemporaryFolder folder;
    const std::string file = folder / "law.dbc";
    REQUIRE(dumbbell({"law", "--prove", "--out", file}).code == 0);
    std::string text = contents(file);
    text.replace(text.find("\ncover end 1500"), 15, "\ncover end 150");
    write_file(file, text);
    CHECK_THAT(refused({"law", file}), Contains("is not verified: s REJECTED"));
}

TEST_CASE("law --ratio says N, or the two values that remain, of any ratio") {
    for (const auto& [ratio, code, said] : std::vector<std::tuple<std::string, int, std::string>>{
             {"1", 0, "N(q) = 2 at q = 1.\n"},
             {"1e6", 0, "N(q) = 887 at q = 1000000.\n"},
             {"1e24", 0, "N(q) = 885595129454 at q = 1e24.\n"},
             {"1e100", 0, "N(q) = 88559512945271391141202194891455767300579529460287 at q = 1e100.\n"},
             {"3/7", 0, "N(q) = 3 at q = 7/3.\n"},
             {"10", 0, "N(q) = 4 at q = 10.\n"},
             {"62.7", 3, "N(q) is 8 or 9 at q = 62.7.\n"}}) {
        CAPTURE(ratio);
        const Outcome law = dumbbell({"law", "--ratio", ratio, "--quiet"});
        CHECK(law.code == code);
        CHECK(law.err.empty());
        CHECK(law.out == said);
    }
    CHECK_THAT(
        dumbbell({"law", "--ratio", "1e100"}).out,
        Contains("It lies 0.208 to 0.209 of a step above the ratio beyond which the maximum is 885595") &&
            Contains("This rests on the law for every mass ratio (proofs/law.md)"));
}

TEST_CASE("law says what is wrong with its options, and leaves no file") {
    const TemporaryFolder folder;
    const std::string ten = certificate(folder, "10");
    CHECK_THAT(refused({"law", "--prove", ten}), Contains("name where to write it by --out, and no FILE"));
    CHECK_THAT(refused({"law", "--ratio", "1:2"}), Contains("--ratio takes one mass ratio"));
    CHECK_THAT(refused({"law", "--ratio", "0"}), Contains("must be greater than 0"));
    CHECK_THAT(refused({"law", "--ratio", "2", ten}), Contains("is not a certificate of the law"));
    for (const Words& words : {Words{"law", "missing.dbc"}, Words{"law", "missing.dbc", "--ratio", "5"}}) {
        CHECK_THAT(refused(words), Contains("cannot read 'missing.dbc': no such file\n"));
    }
    CHECK_THAT(refused({"law", "--out", folder / "x.dbc"}), Contains("--out requires --prove"));
    CHECK_THAT(refused({"law", "--prove", "--out", folder / "x.txt"}), Contains("x.txt"));
    CHECK(folder.names().size() == 1);
}
