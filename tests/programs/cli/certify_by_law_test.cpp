// One mass ratio by the law: the certificate, and how the programs take it.
#include <catch2/catch.hpp>
#include <filesystem>

#include "programs.hpp"

using namespace dumbbell_test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using Json = nlohmann::json;

namespace {

const std::string shipped_law = DUMBBELL_PROJECT "/certificates/law.dbc.gz";
const std::string at_1e100 = "88559512945271391141202194891455767300579529460287";

}  // namespace

TEST_CASE("certify --by law agrees with certify, next to steps, too, and all its certificates are verified") {
    const TemporaryFolder folder;
    Words files{"--quiet"};
    for (const auto& [ratio, decided] : std::vector<std::pair<std::string, bool>>{
             {"1", true},        {"1.000001", true}, {"3/7", true},        {"4.6", false},
             {"4.61", false},    {"32/7", true},     {"24/5", true},       {"10", true},
             {"11", true},       {"11.2", false},    {"62.7", false},      {"62.75", true},
             {"100", true},      {"457.5", true},    {"1000", true},       {"12345.678", true},
             {"1e6", true},      {"1032803", true},  {"1032804.5", false}, {"1035103", true},
             {"1035105", false}, {"1035107", true},  {"1.5e7", true},      {"1e8", true}}) {
        CAPTURE(ratio);
        const std::string file = "q" + std::to_string(files.size()) + ".dbc";
        const Outcome by_law =
            dumbbell({"certify", ratio, "--by", "law", "--out", file, "--json"}, folder.path());
        CHECK(by_law.code == (decided ? 0 : 3));
        CHECK(count_lines(by_law.err) == (decided ? 0 : 1));
        const Json law = Json::parse(by_law.out);
        const Json piece = Json::parse(dumbbell({"certify", ratio, "--json"}).out).at("pieces").at(0);
        REQUIRE(piece.at("upper") == piece.at("lower"));
        const long n = piece.at("lower"), lower = std::stol(law.at("lower").get<std::string>()),
                   upper = std::stol(law.at("upper").get<std::string>());
        CHECK((lower <= n && n <= upper));
        CHECK(upper - lower == (decided ? 0 : 1));
        files.push_back(file);
    }
    files.insert(files.begin(), "verify");
    const std::string all = std::to_string(files.size() - 2);
    CHECK(last_line(dumbbell(files, folder.path()).out) ==
          "c files=" + all + " verified=" + all + " rejected=0 limit=0 unsupported=0 unreadable=0 exit=0");
}

TEST_CASE("certify --by law says N at any ratio, what that rests on, and how to check it") {
    const TemporaryFolder folder;
    const Outcome result = dumbbell({"certify", "1e100", "--by", "law", "--out", "x.dbc"}, folder.path());
    CHECK(result.code == 0);
    CHECK(result.err.empty());
    CHECK_THAT(
        result.out,
        StartsWith("N(q) = " + at_1e100 + " at q = 1e100.\n") &&
            Contains("This rests on the law for every mass ratio (proofs/law.md) with its certificate\n") &&
            Contains("Certificate: x.dbc (sha256 ") && Contains("Check it:    dumbbell verify x.dbc\n"));
    CHECK(dumbbell({"certify", "1e100", "--by", "law", "--quiet"}).out ==
          "N(q) = " + at_1e100 + " at q = 1e100.\n");
    CHECK_THAT(dumbbell({"certify", "3/7", "--by", "law"}).out,
               StartsWith("Ratios below 1: the masses are swapped, q -> 1/q.\nN(q) = 3 at q = 7/3.\n"));
    CHECK(dumbbell({"certify", "1e100", "--by", "law", "--out", "-", "--quiet"}).out ==
          contents(folder / "x.dbc"));
    // Another copy of the law, which the line "Check it" names.
    std::filesystem::copy_file(shipped_law, folder / "law.dbc.gz");
    CHECK_THAT(
        dumbbell({"certify", "63", "--by", "law", "--law", "law.dbc.gz", "--out", "y.dbc"}, folder.path())
            .out,
        Contains("Check it:    dumbbell verify --law law.dbc.gz y.dbc\n"));
    const Outcome verified =
        dumbbell({"verify", "--law=law.dbc.gz", "--exactly", "9", "y.dbc"}, folder.path());
    CHECK_THAT(last_line(verified.out),
               StartsWith("s VERIFIED claim=collisions-by-law ratio=63/1 upper=9 lower=9 "));
    const Outcome alone = verifier({"y.dbc"}, folder.path());
    CHECK(alone.code == 2);
    CHECK_THAT(last_line(alone.out), Contains("give it by --law FILE"));
}

TEST_CASE("certify --by law: two values are exit code 3, one line, and a certificate that says both") {
    const TemporaryFolder folder;
    const Outcome result =
        dumbbell({"certify", "62.7", "--by", "law", "--out", "x.dbc", "--quiet"}, folder.path());
    CHECK(result.code == 3);
    CHECK(result.out == "N(q) is 8 or 9 at q = 62.7.\n");
    CHECK(result.err ==
          "dumbbell: not decided: the law leaves two values at this ratio; without --by law a cover may "
          "decide\n");
    CHECK_THAT(contents(folder / "x.dbc"), Contains("\nupper 9\nlower 8\n"));
}

TEST_CASE("certify --by law refuses what has no meaning with it, in one line, and writes nothing") {
    const TemporaryFolder folder;
    const std::string ten = certificate(folder, "10");
    for (const Words& options : std::vector<Words>{{"--gap", "1e-3"},
                                                   {"--scene", "wedge"},
                                                   {"--section", "full"},
                                                   {"--jobs", "1"},
                                                   {"--budget", "3s"},
                                                   {"--witness"}}) {
        CAPTURE(options.front());
        Words words{"certify", "10", "--by", "law", "--out", folder / "x.dbc"};
        words.insert(words.end(), options.begin(), options.end());
        CHECK_THAT(refused(words), Contains(options.front() + " means nothing with --by law: leave it out"));
    }
    CHECK_THAT(refused({"certify", "1:2", "--by", "law"}), Contains("--by law takes one mass ratio"));
    CHECK_THAT(refused({"certify", "10", "--by", "orbit"}), Contains("cover,law"));
    CHECK_THAT(refused({"certify", "10", "--law", shipped_law}),
               Contains("--law means nothing without --by law: add that, or leave it out"));
    CHECK_THAT(refused({"certify", "10", "--by", "cover", "--law", shipped_law}),
               Contains("--law means nothing without --by law"));
    CHECK_THAT(refused({"certify", "10", "--by", "law", "--law", ten}),
               Contains("is not a certificate of the law for every mass ratio"));
    CHECK_THAT(refused({"certify", "10", "--by", "law", "--law", "missing.dbc"}),
               Contains("cannot read 'missing.dbc': no such file\n"));
    CHECK(folder.names().size() == 1);
}

TEST_CASE("commands about covers say of a certificate by the law what it is") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell({"certify", "10", "--by", "law", "--out", "x.dbc"}, folder.path()).code == 0);
    for (const Words& command : std::vector<Words>{{"audit", "x.dbc"},
                                                   {"law", "x.dbc"},
                                                   {"plot", "cover", "x.dbc", "--out", "x.svg"},
                                                   {"report", "x.dbc", "--out", "x.html"}}) {
        const Outcome result = dumbbell(command, folder.path());
        CAPTURE(command.front(), result.err);
        CHECK(result.code == 2);
        CHECK(count_lines(result.err) == 1);
        CHECK_THAT(result.err,
                   Contains("'x.dbc' is about one mass ratio by the law (dumbbell certify --by law)"));
    }
    CHECK(folder.names() == Words{"x.dbc"});
}
