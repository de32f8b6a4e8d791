#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;

TEST_CASE("critical 4 prints 15 proved digits, and what they rest on") {
    const Outcome result = dumbbell({"critical", "4"});
    CHECK(result.code == 0);
    CHECK(result.err.empty());
    CHECK_THAT(result.out, StartsWith("q_c(4) = 4.60333884875170...\n"));
    CHECK_THAT(result.out, Contains("steps from 3 to 4") && Contains("theorem 2 of proofs/theorem.md") &&
                               Contains("do not use"));
}

TEST_CASE("critical within a budget: what was finished is printed, and exit 3 tells that not all was") {
    const TemporaryFolder folder;
    const Outcome result =
        dumbbell({"critical", "100000000000", "--budget", "0.2s", "--out", "a.tsv"}, folder.path());
    CHECK(result.code == 3);
    CHECK_THAT(result.out, Contains("not enclosed"));
    CHECK(count_lines(result.err) == 1);
    CHECK_THAT(result.err, Contains("allow more time"));
    CHECK_THAT(contents(folder / "a.tsv"), Contains("100000000000\topen\t-\t-\tcorner\t49999999999\n"));
}

TEST_CASE("critical says in one line which ratios of a long range its budget did not reach") {
    const Outcome result = dumbbell({"critical", "3:1000000", "--budget", "0.2s", "--json"});
    CHECK(result.code == 3);
    const auto report = nlohmann::json::parse(result.out);
    const auto& ratios = report.at("ratios");
    const long next = 3 + static_cast<long>(ratios.size());
    CHECK(next < 1'000'000);
    CHECK(report.at("left_out_from") == next);
    CHECK(report.at("open").get<long>() >= 1'000'001 - next);
    CHECK((ratios.size() == 1 || ratios.back().at("status") == "proved"));
}

TEST_CASE("critical refuses what is no number of collisions from 3 on, and says why") {
    for (const char* count : {"0", "1", "2", "0002", "2:5"}) {
        CHECK_THAT(refused({"critical", count, "--out", "file.tsv"}), Contains("never below 2"));
    }
    for (const char* count : {"", "x", "-4", "+4", "4.5", "1e-3", ":", "4:", ":4", "3:4:5", "3-5", "nan",
                              "4/3", "0x4", "4\n5", "4 "}) {
        CAPTURE(count);
        refused({"critical", count, "--out", "file.tsv"});
    }
    CHECK_THAT(refused({"critical", "x"}), Contains("write N or N1:N2"));
    CHECK_THAT(refused({"critical", "5:3"}), Contains("smaller N first"));
    CHECK_THAT(refused({"critical", "100000000000000001"}), Contains("10^17"));
    CHECK_THAT(refused({"critical", std::string(100'000, '9')}), Contains("10^17"));
    CHECK_THAT(refused({"critical", "3:2000000"}), Contains("a shorter range"));
    refused({"critical"});
    refused({"critical", "4", "5"});
}

TEST_CASE("critical takes every spelling of a whole number, and encloses those of long orbits") {
    const std::string many = dumbbell({"critical", "10000", "--digits", "20", "--quiet"}).out;
    CHECK(many == "q_c(10000) = 127454738.69283755285...\n");
    for (const char* count : {"1e4", "10^4", "10000.0", "20000/2"}) {
        CHECK(dumbbell({"critical", count, "--digits", "20", "--quiet"}).out == many);
    }
    const Outcome outcome = dumbbell({"critical", "10^12", "--digits", "20"});
    CHECK_THAT(outcome.out, StartsWith("q_c(1000000000000) = 1.2750568866952327882e24...\n") &&
                                Contains("followed by macro steps (L42)"));
    CHECK_THAT(dumbbell({"critical", "20000:20001"}).out,
               Contains("By interval Newton") && Contains("From N = 20001 on, just below it"));
}

TEST_CASE("critical refuses options out of range") {
    CHECK_THAT(refused({"critical", "4", "--budget", "5"}), Contains("30s"));
    CHECK_THAT(refused({"critical", "4", "--out", "no/such/folder/file.tsv"}), Contains("no/such/folder"));
}

TEST_CASE("critical --rho prints steps of bodies as it does ratios: as text, JSON and a table") {
    const TemporaryFolder folder;
    const Outcome result =
        dumbbell({"critical", "4:5", "--rho", "0.25", "--out", "steps.tsv"}, folder.path());
    CHECK(result.code == 0);
    CHECK_THAT(result.out,
               Contains("4  4.66455342222012...") && Contains("     3        5\n") && Contains("L83"));
    CHECK_THAT(contents(folder / "steps.tsv"),
               StartsWith("# Steps of bodies.") &&
                   Contains("\n# N\tQ_c\tradius\tbits\tfrom\tto\n4\t4.66455342222012\t"));
    CHECK(dumbbell({"critical", "3", "--rho", "1", "--quiet"}).out == "Q_c(3; 1) = 1.00000000000000...\n");
    const auto report = nlohmann::json::parse(dumbbell({"critical", "5", "--rho", "1/2", "--json"}).out);
    CHECK((report.at("rho") == "0.5" && report.at("ratios").at(0).at("from") == 4));
    CHECK_FALSE(report.at("ratios").at(0).contains("orbit"));
}

TEST_CASE("critical --ratio --rod-mass prints the masses at which N falls, and what is open") {
    const Outcome result = dumbbell({"critical", "--ratio", "10", "--rod-mass"});
    CHECK(result.code == 0);
    CHECK_THAT(result.out, Contains("5  0.530596177731867...") && Contains("no rises, is open"));
    CHECK(dumbbell({"critical", "--ratio", "10", "--rod-mass", "--quiet"}).out ==
          "The mass at which N falls from 5 to 3 = 0.530596177731867...\n");
}

TEST_CASE("critical of bodies refuses in a line what has no step") {
    CHECK_THAT(refused({"critical", "3", "--rho", "1/2"}), Contains("the steps begin with N = 4"));
    CHECK_THAT(refused({"critical", "5", "--rho", "2"}), Contains("at most 1"));
    CHECK_THAT(refused({"critical", "5", "--ratio", "10", "--rod-mass"}), Contains("exclude each other"));
    CHECK_THAT(refused({"critical", "--ratio", "10"}), Contains("--rod-mass"));
    CHECK_THAT(refused({"critical", "2000000", "--rho", "1/2"}), Contains("at most 10^6"));
}
