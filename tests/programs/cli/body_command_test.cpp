// certify: rods with mass, and the coin.
#include <iterator>
#include <sstream>

#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;
using Json = nlohmann::json;

namespace {

std::string refused_body(Words options) {
    options.insert(options.begin(), "certify");
    return refused(options);
}

}  // namespace

TEST_CASE("certify --coin proves 4, and is --rho 1 --inertia 4") {
    const TemporaryFolder folder;
    const Outcome coin = dumbbell({"certify", "--coin", "--out", "coin.dbc"}, folder.path());
    CHECK(coin.code == 0);
    CHECK_THAT(coin.out, Contains("Proved: at Q 4, rho 1 no motion of the body in a plane, without a corner, "
                                  "hits the floor more than 4 times, and some motion hits it 4 times."));
    CHECK_THAT(coin.out, Contains("dumbbell verify --coin --exactly 4 coin.dbc\n"));
    REQUIRE(dumbbell({"certify", "--rho", "1", "--inertia", "4", "--out", "same.dbc"}, folder.path()).code ==
            0);
    CHECK(contents(folder / "coin.dbc") == contents(folder / "same.dbc"));
}

TEST_CASE("a rod's mass is converted exactly, and --json says which body it is") {
    const Outcome result = dumbbell({"certify", "10", "--rod-mass", "0.01", "--json"});
    CHECK(result.code == 0);
    const Json json = Json::parse(result.out);
    CHECK(json.at("scene") == "body");
    CHECK(json.at("rho") == Json({{"lo", "211/2011"}, {"hi", "211/2011"}}));
    CHECK(json.at("ratio").at("lo") == "12132363/1248521");
    CHECK(json.at("pieces").at(0).at("upper") == 5);
    CHECK(json.at("pieces").at(0).at("lower") == 5);
    const TemporaryFolder folder;
    CHECK_THAT(dumbbell({"certify", "10", "--rod-mass", "0.01", "--out", "rod.dbc"}, folder.path()).out,
               Contains("dumbbell verify --ratio 10 --rod-mass 0.01 --exactly 5 rod.dbc\n"));
    CHECK_THAT(
        dumbbell({"certify", "--rho", "1", "--inertia", "2:5", "--out", "many.dbc"}, folder.path()).out,
        Contains("dumbbell verify --rho 1 --inertia 2:5 --max 4 --min 3 --gap 4.5e-7 --gaps 1 many.dbc\n"));
}

TEST_CASE("what is said of a body names no option that bodies do not have") {
    const Outcome open = dumbbell({"certify", "--rho", "1/2", "--inertia", "9", "--budget", "0s"});
    CHECK(open.code == 3);
    CHECK(open.err == "dumbbell: not decided: allow more time (--budget)\n");
    CHECK_THAT(refused_body({"--rho", "1/2", "--inertia", "1e40"}),
               Contains("Q = 1e40 is beyond 10^12, the greatest that is tried\n"));
    CHECK_THAT(refused_body({"--coin", "--section", "full"}),
               Contains("proved by perpendicular orbits, or by --section plain"));
}

TEST_CASE("numbers that are no body's are refused, with what to do") {
    CHECK_THAT(refused_body({}), Contains("--coin"));
    CHECK_THAT(refused_body({"--rho", "1"}), Contains("--rho needs --inertia"));
    CHECK_THAT(refused_body({"--rho", "2", "--inertia", "4"}), Contains("swap the ends"));
    CHECK_THAT(refused_body({"--rho", "1/2", "--inertia", "1.9", "--section", "plain"}),
               Contains("inertia times rho is at least 1"));
    CHECK_THAT(refused_body({"--rod-mass", "1"}), Contains("needs RATIO"));
    CHECK_THAT(refused_body({"1:2", "--rod-mass", "1"}), Contains("single mass ratio"));
    CHECK_THAT(refused_body({"10", "--rod-mass=-1"}), Contains("is negative"));
    CHECK_THAT(refused_body({"10", "--coin"}), Contains("a RATIO only with --rod-mass"));
    CHECK_THAT(refused_body({"--coin", "--list", "-"}), Contains("--list and --coin exclude each other"));
    CHECK_THAT(refused_body({"--coin", "--part", "1/2"}), Contains("--part is for a range"));
    CHECK_THAT(refused_body({"--coin", "--witness"}), Contains("--witness prints orbits of the dumbbell"));
}

TEST_CASE("a range of Q below 1 has parts, which join, and a missing one is named with its command") {
    const TemporaryFolder folder;
    const auto certify = [&](Words more) {
        Words words{"certify", "--rho", "1/2"};
        std::ranges::move(more, std::back_inserter(words));
        return dumbbell(words, folder.path());
    };
    CHECK_THAT(certify({"--inertia", "0.4:0.6", "--part", "1/2", "--out", "1.dbc"}).out,
               Contains("Part 1 of 2 of Q 0.4 : 0.6: those from 0.4 to 0.5.\n"));
    const Words join{"join", "1.dbc", "--range", "0.4:0.6", "--out", "whole.dbc"};
    CHECK_THAT(dumbbell(join, folder.path()).err,
               Contains("missing: Q from 0.5 to 0.6; to make them: dumbbell certify --rho 0.5 --inertia "
                        "0.5:0.6 --out missing-1.dbc\n"));
    CHECK(certify({"--inertia", "0.5:0.6", "--out", "2.dbc"}).code == 0);
    Words both = join;
    both.insert(both.begin() + 1, "2.dbc");
    CHECK(dumbbell(both, folder.path()).code == 0);
    CHECK(verifier({"--rho", "1/2", "--inertia", "0.4:0.6", "--exactly", "3", folder / "whole.dbc"}).code ==
          0);
}

TEST_CASE("a list of Q has a folder of certificates") {
    const TemporaryFolder folder;
    write_file(folder / "list", "1/2\n1/2:3\n100\n");
    const Outcome list =
        dumbbell({"certify", "--list", "list", "--rho", "1/2", "--out", "answers"}, folder.path());
    CHECK(list.code == 0);
    CHECK_THAT(list.out, Contains("1/2:3\t1/2\t0.5\t3/1\t3\t3\t3\t"));
    CHECK(verifier({"--claims", folder / "answers/claims.tsv"}).code == 0);
    CHECK(dumbbell({"certify", "--list", "list", "--coin"}, folder.path()).code == 2);
}

TEST_CASE("ranges of bodies are verified with their gaps, and where N leaps by 2 they say so") {
    const TemporaryFolder folder;
    const Outcome leaps =
        dumbbell({"certify", "--rho", "0.25", "--inertia", "4:30", "--out", "range.dbc"}, folder.path());
    CHECK(leaps.code == 0);
    CHECK_THAT(leaps.out, Contains("  3 to 5  ") && Contains("--inertia 4:30 --max 7 --min 3 --gap "));
    CHECK(verifier({"--rho", "0.25", "--inertia", "4:30", "--max", "7", "--min", "3", "--gap", "1e-6",
                    "--gaps", "2", folder / "range.dbc"})
              .code == 0);
}

TEST_CASE("a share of a rectangle of bodies is proved in cells, and verified of parts, too") {
    const TemporaryFolder folder;
    const auto run = [&](const std::string& words) {
        std::istringstream in(words);
        return dumbbell(Words(std::istream_iterator<std::string>(in), {}), folder.path());
    };
    const std::string certify = "certify --rho 1/5:1 --inertia 2:40 --decided 0.7 ";
    const Outcome made = run(certify + "--out some.dbc");
    CHECK(made.code == 0);
    CHECK_THAT(made.out, Contains("Proved: of at least 0.7") &&
                             Contains("dumbbell verify --rho 0.2:1 --inertia 2:40 --decided 0.7"));
    CHECK(run("verify --decided 0.7 some.dbc").code == 0);
    CHECK(run("verify --decided 0.8 some.dbc").code == 1);
    CHECK(run("verify --rho 0.3:0.4 --inertia 10:12 --exactly 5 some.dbc").code == 0);
    CHECK(run(certify + "--budget 0s --out none.dbc").code == 3);
    CHECK_THAT(run("verify none.dbc").out, Contains("s OPEN ") && Contains(" decided=0.000000 "));
    CHECK(Json::parse(run(certify + "--json").out).at("decided").get<std::string>() >= "0.7");
    CHECK_THAT(run("certify --rho 1/5:1 --inertia 2:40 --decided 1").err, Contains("a share below 1"));
}

TEST_CASE("a page shows what is about bodies, and other pictures refuse it", "[wings]") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell(
                {"certify", "--rho", "1", "--inertia", "2:5", "--section", "plain", "--out", "symmetric.dbc"},
                folder.path())
                .code == 0);
    const Outcome result = dumbbell({"plot", "staircase", "symmetric.dbc", "--out", "x.svg"}, folder.path());
    CHECK(result.code == 2);
    CHECK_THAT(result.err, Contains("is about rigid bodies"));
    CHECK(dumbbell({"report", "symmetric.dbc", "--out", "x.html"}, folder.path()).code == 0);
    CHECK_THAT(contents(folder / "x.html"),
               Contains("--rho 1 --inertia 2:5") && Contains("\"symmetric\":true"));
    CHECK(folder.names() == Words{"symmetric.dbc", "x.html"});
}
