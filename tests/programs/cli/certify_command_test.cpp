#include <iterator>
#include <sstream>

#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;
using Json = nlohmann::json;

TEST_CASE("the option --out writes a certificate and --json names it with its checksum") {
    const TemporaryFolder folder;
    const Outcome result = dumbbell({"certify", "10", "--json", "--out", "ten.dbc"}, folder.path());
    CHECK(result.code == 0);
    CHECK(folder.names() == Words{"ten.dbc"});
    const Json json = Json::parse(result.out);
    CHECK(json.at("out") == "ten.dbc");
    CHECK(last_line(contents(folder / "ten.dbc")) == "sha256 " + json.at("sha256").get<std::string>());
}

TEST_CASE("below 1 the masses are swapped, and the program says so") {
    const Outcome tenth = dumbbell({"certify", "0.1"});
    CHECK(tenth.code == 0);
    CHECK_THAT(tenth.out, Contains("masses are swapped") && Contains("at mass ratio 10 no"));
    const Outcome range = dumbbell({"certify", "0.1:1/5", "--json"});
    CHECK(range.code == 0);
    const Json json = Json::parse(range.out);
    CHECK(json.at("ratio").at("lo") == "5/1");
    CHECK(json.at("ratio").at("hi") == "10/1");
    CHECK(dumbbell({"certify", "0.5:1"}).code == 0);
}

TEST_CASE("a certificate depends on nothing but the claim: not on the jobs, the time, the file's name") {
    const TemporaryFolder folder;
    const std::string one = contents(certificate(folder, "1:50", {"--jobs", "1"}));
    CHECK(contents(certificate(folder, "1:50", {"--jobs", "2"})) == one);
    CHECK(contents(certificate(folder, "1:50", {"--jobs", "8", "--budget", "1h", "--witness"})) == one);
}

TEST_CASE("the option --witness prints an orbit of N collisions, in text and in JSON") {
    const Outcome text = dumbbell({"certify", "10", "--witness"});
    CHECK(text.code == 0);
    CHECK_THAT(text.out, Contains("Witness at mass ratio 10: 4 collisions") && Contains("heavy") &&
                             Contains("Smallest margin") && Contains("Proved: at mass ratio 10"));
    const Outcome json = dumbbell({"certify", "100", "--witness", "--json"});
    CHECK(json.code == 0);
    const Json orbit = Json::parse(json.out).at("pieces").at(0).at("witness").at("collisions");
    CHECK(orbit.size() == 10);
    for (const auto& collision : orbit) {
        CHECK(collision.at("grazing_sine").at(0) > 0);
    }
}

namespace {

// What `trace` says of the start in the air in this text: the command is pasted as it is printed.
std::string traced_start(const std::string& text) {
    const std::size_t at = text.find(" dumbbell trace ");
    REQUIRE(at != std::string::npos);
    std::istringstream line(text.substr(at, text.find('\n', at) - at));
    const Words pasted{std::istream_iterator<std::string>(line), {}};
    const Outcome traced = dumbbell({pasted.begin() + 1, pasted.end()});
    CHECK(traced.code == 0);
    return traced.out;
}

}  // namespace

TEST_CASE("the witness is also printed as a start in the air that trace proves to have N collisions",
          "[wings]") {
    for (const char* ratio : {"1", "1.1", "4.61", "10", "100", "1000", "1e4", "1e6"}) {
        CAPTURE(ratio);
        const auto known = std::ranges::find_if(
            known_maxima, [&](const Known& k) { return std::stod(k.ratio) == std::stod(ratio); });
        const std::string outcome = "\nexactly " + std::to_string(known->maximum) + " collisions\n";
        CHECK_THAT(traced_start(dumbbell({"certify", ratio, "--witness"}).out), Contains(outcome));
        const std::string plain = dumbbell({"certify", ratio}).out;
        if (known->maximum <= 100) {
            CHECK_THAT(traced_start(plain), Contains(outcome));
        } else {
            CHECK_THAT(plain, !Contains("dumbbell trace"));
        }
    }
    for (const Words& other :
         {Words{"certify", "10", "--quiet"}, Words{"certify", "4:5"}, Words{"certify", "--coin"}}) {
        CHECK_THAT(dumbbell(other).out, !Contains("dumbbell trace"));
    }
}

TEST_CASE("of an orbit of more than 5000 collisions --witness says that no start is looked for", "[wings]") {
    const std::string no_start =
        "\nNo start in the air: it is looked for only along orbits of up to 5000 collisions.\n";
    const std::string out = dumbbell({"certify", "4e7", "--witness"}).out;
    CHECK_THAT(out, Contains(no_start) && !Contains("dumbbell trace"));
    CHECK_THAT(dumbbell({"certify", "4e7"}).out, !Contains("start in the air"));
}

TEST_CASE("of a range each start in the air belongs to the lowest ratio of its piece, and stands in the JSON",
          "[wings]") {
    const Json pieces = Json::parse(dumbbell({"certify", "4.5:5", "--witness", "--json"}).out).at("pieces");
    REQUIRE(pieces.size() == 3);
    for (const Json& piece : pieces) {
        const Json& witness = piece.at("witness");
        const Json& start = witness.at("start");
        REQUIRE(start.is_object());
        Words command{"trace", witness.at("ratio").get<std::string>()};
        for (const char* quantity : {"phi", "phidot", "y", "ydot"}) {
            command.insert(command.end(),
                           {std::string("--") + quantity, start.at(quantity).get<std::string>()});
        }
        if (start.at("digits") > 0) {
            command.insert(command.end(), {"--digits", std::to_string(start.at("digits").get<int>())});
        }
        const std::string n = std::to_string(witness.at("collisions").size());
        CHECK_THAT(dumbbell(command).out, Contains("\nexactly " + n + " collisions\n"));
    }
}

TEST_CASE("options may stand before the ratio and be joined with =") {
    CHECK(dumbbell({"certify", "--jobs=1", "--gap=1e-4", "4:5"}).code == 0);
}

TEST_CASE(
    "next to a critical ratio the verifier has bits enough, at every distance that the prover decides") {
    const TemporaryFolder folder;
    const std::string ratio =
        "4."
        "6033388487517003525565820291030165130673971341605323460394301154384587319659709987165469972272571909"
        "972486139686448666270416427888322855665627206860201212593";
    for (const std::size_t length : {17U, 38U, 61U, 70U, 77U, 121U, 140U, 153U}) {
        CAPTURE(length);
        CHECK(verifier({certificate(folder, ratio.substr(0, length))}).code == 0);
        // Up to 152 digits the ratio lies below the critical one; one more in the last place, above.
        const std::string above = ratio.substr(0, length - 1) + static_cast<char>(ratio[length - 1] + 1);
        if (ratio[length - 1] != '9') {
            CHECK(verifier({"--exactly", "4", certificate(folder, above)}).code == 0);
        }
    }
}

TEST_CASE("the bounds of a critical ratio with as many digits as there are are mass ratios, and are decided",
          "[wings]") {
    const TemporaryFolder folder;
    const auto json = nlohmann::json::parse(dumbbell({"critical", "4", "--digits", "1000", "--json"}).out);
    for (const auto& [end, n] : {std::pair("lo", "3"), std::pair("hi", "4")}) {
        const std::string ratio = json.at("ratios").at(0).at(end), path = certificate(folder, ratio);
        CHECK(verifier({"--max-bits", "4096", "--ratio", ratio, "--exactly", n, path}).code == 0);
        CHECK(dumbbell({"law", "--ratio", ratio}).code == 3);
        const std::string fraction =
            ratio.substr(0, 1) + ratio.substr(2) + "/1" + std::string(ratio.size() - 2, '0');
        CHECK(contents(certificate(folder, fraction)) == contents(path));
    }
    // The greatest ratio of the law, and next to it.
    for (const std::string& ratio :
         {"1" + std::string(1000, '0'), std::string(1001, '9') + "/11", "0." + std::string(999, '0') + "1"}) {
        CHECK(dumbbell({"law", "--ratio", ratio}).code == 0);
    }
    CHECK_THAT(refused({"certify", "1." + std::string(1500, '1')}),
               Contains("too long for a line of a certificate"));
}

TEST_CASE("gaps may be narrower than doubles are") {
    const TemporaryFolder folder;
    for (const char* gap : {"1e-15", "1e-20", "1e-40", "1e-70"}) {
        CAPTURE(gap);
        const std::string path = certificate(folder, "4.6:4.61", {"--gap", gap});
        const Outcome verified = verifier({path});
        CHECK(verified.code == 0);
        CHECK_THAT(verified.out, Contains("upper=4 lower=3 gaps=1 open=0"));
    }
}
