#include <tuple>

#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;

TEST_CASE("law states the law for every mass ratio, and what the verifier says of it", "[wings]") {
    const Outcome law = dumbbell({"law"});
    CHECK(law.code == 0);
    CHECK(law.err.empty());
    CHECK_THAT(law.out, Contains("2 + floor(C sqrt q - c0 q^(-1/4)) <= N(q) <= 2 + floor(C sqrt q)") &&
                            Contains("0.88559512945271391141202194891455767300579529460285...") &&
                            Contains("0.205811589549495595339706567") && Contains("s VERIFIED"));
    // Its other answers rest on the certificate that was verified here.
    const std::string sha256 = law.out.substr(law.out.find(" sha256=") + 8, 64);
    for (const Words& question : {Words{"--ratio", "10"}, Words{"--count", "1e50"}}) {
        Words words{"law"};
        words.insert(words.end(), question.begin(), question.end());
        CHECK_THAT(dumbbell(words).out,
                   Contains("This rests on the law for every mass ratio (proofs/law.md)") &&
                       Contains("law.dbc.gz (sha256 " + sha256 + "); dumbbell law checks it.\n"));
        words.emplace_back("--json");
        CHECK(nlohmann::json::parse(dumbbell(words).out).at("sha256") == sha256);
    }
}

namespace {

/// What law says that is refused, in a program that comes with this file as the law's certificate, if any.
std::string refused_with(const std::string& certificate, Words words) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "bin");
    for (const char* program : {DUMBBELL_BIN, DUMBBELL_VERIFY_BIN}) {
        std::filesystem::copy_file(program,
                                   folder / "bin/" + std::filesystem::path(program).filename().string());
    }
    if (!certificate.empty()) {
        std::filesystem::create_directories(folder / "share/dumbbell/certificates");
        std::filesystem::copy_file(certificate, folder / "share/dumbbell/certificates/law.dbc.gz");
    }
    words.insert(words.begin(), {folder / "bin/dumbbell", "law"});
    const Outcome result = run(std::move(words), folder.path());
    CHECK(result.code == 2);
    CHECK(result.out.empty());
    CHECK(count_lines(result.err) == 1);
    return result.err;
}

const std::vector<Words> questions{{}, {"--ratio", "5"}, {"--count", "903"}};

}  // namespace

TEST_CASE("a program without its certificates says that they are missing", "[wings]") {
    for (const Words& question : questions) {
        CHECK(refused_with("", question) ==
              "dumbbell: the certificate law.dbc.gz that comes with this program is not found: install the "
              "program with its certificates\n");
    }
}

TEST_CASE("law believes no certificate that the verifier rejects, and answers by none but its own",
          "[wings]") {
    const TemporaryFolder folder;
    const std::string file = folder / "law.dbc", ten = certificate(folder, "10");
    std::string text = run({"gzip", "-dc", DUMBBELL_PROJECT "/certificates/law.dbc.gz"}).out;
    text.replace(text.find("\ncover end 1500"), 15, "\ncover end 150");
    write_file(file, text);
    CHECK_THAT(refused_with(file, {}), Contains("is not verified: s REJECTED"));
    CHECK_THAT(refused_with(ten, {}), Contains("is not verified: s REJECTED"));
    for (const Words& question : {questions[1], questions[2]}) {
        CHECK_THAT(refused_with(file, question), Contains("law.dbc.gz' is damaged"));
        CHECK_THAT(refused_with(ten, question),
                   Contains("law.dbc.gz' is not the certificate of the law that comes with this program"));
    }
}

TEST_CASE("law --prove makes the certificate that is shipped again, byte for byte", "[wings]") {
    const TemporaryFolder folder;
    const std::string made = folder / "law.dbc.gz";
    CHECK(dumbbell({"law", "--prove", "--quiet", "--out", made}).code == 0);
    CHECK((contents(made) == contents(DUMBBELL_PROJECT "/certificates/law.dbc.gz")));
}

TEST_CASE("law --ratio says N, or the two values that remain, of any ratio", "[wings]") {
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
        Contains("It lies 0.208 to 0.209 of a step above the ratio beyond which the maximum is 885595"));
    CHECK_THAT(dumbbell({"law", "--ratio", "62.7"}).out,
               Contains(" of a step below or ") && Contains("is 9: too near to tell.\n"));
}

TEST_CASE("law --count encloses the ratio at which the maximum steps to N, for any N from 903 on",
          "[wings]") {
    CHECK(dumbbell({"law", "--count", "903", "--quiet"}).out == "1035105.277 <= q_c(903) <= 1035105.972\n");
    CHECK(dumbbell({"law", "--count", "9.03e2"}).out == dumbbell({"law", "--count", "903"}).out);
    CHECK_THAT(dumbbell({"law", "--count", "10^18"}).out,
               Contains("The maximum steps from 999999999999999999 to 1000000000000000000 there.\n"));
    CHECK(dumbbell({"law", "--count", "1e100"}).code == 0);
}

TEST_CASE("law says what is wrong with its options, and leaves no file", "[wings]") {
    CHECK_THAT(refused({"law", "stairs.dbc"}), Contains("not expected here: 'stairs.dbc'"));
    CHECK_THAT(refused({"law", "--ratio", "1:2"}), Contains("--ratio takes one mass ratio"));
    CHECK_THAT(refused({"law", "--ratio", "0"}), Contains("must be greater than 0"));
    CHECK_THAT(refused({"law", "--ratio", "2", "--count", "903"}), Contains("--count"));
    CHECK_THAT(refused({"law", "--ratio", "2", "--digits", "9"}), Contains("--digits"));
    CHECK_THAT(refused({"law", "--count", "902"}),
               Contains("from 903 to 10^100, not '902': for less, dumbbell critical N\n"));
    CHECK_THAT(refused({"law", "--count", "903.5"}), Contains("from 903 to 10^100, not '903.5'\n"));
    CHECK_THAT(refused({"law", "--count", "1e101"}), Contains("from 903 to 10^100, not '1e101'\n"));
    CHECK_THAT(refused({"law", "--count", "903:905"}), Contains("--count: '903:905'"));
    CHECK_THAT(refused({"law", "--out", "x.dbc"}), Contains("--out requires --prove"));
    CHECK_THAT(refused({"law", "--prove", "--out", "x.txt"}), Contains("x.txt"));
}
