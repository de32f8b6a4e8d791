// Ratios at which a count has more than 64 bits.
#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;
using Json = nlohmann::json;

namespace {

const std::string maximum = "88559512945271391143";  // what `law --ratio 1e40` says, too
const std::string one_more = "88559512945271391144", one_less = "88559512945271391142";

Outcome verified(const std::string& file, const Words& claim) {
    Words words{"--quiet", "--ratio", "1e40", file};
    words.insert(words.end(), claim.begin(), claim.end());
    return verifier(words);
}

/// The text with every line that begins with `keyword` made another one.
std::string with(const std::string& text, const std::string& keyword, const std::string& line) {
    const std::size_t begin = text.find("\n" + keyword + " ") + 1;
    return text.substr(0, begin) + line + text.substr(text.find('\n', begin));
}

/// The last hint of a line with this keyword, one more or less.
std::string moved_hint(const std::string& text, const std::string& keyword, char from, char to) {
    const std::size_t end = text.find('\n', text.find("\n" + keyword + " ") + 1);
    REQUIRE(text[end - 1] == from);
    return text.substr(0, end - 1) + to + text.substr(end);
}

}  // namespace

TEST_CASE("a maximum beyond 64 bits is proved, verified, and said in full", "[wings]") {
    const TemporaryFolder folder;
    const std::string file = folder / "far.dbc";
    const Outcome made = dumbbell({"certify", "1e40", "--json", "--out", file});
    REQUIRE(made.code == 0);
    const Json piece = Json::parse(made.out).at("pieces").at(0);
    CHECK(piece.at("upper") == maximum);
    CHECK(piece.at("lower") == maximum);
    CHECK(piece.at("status") == "exact");

    const Outcome exactly = verified(file, {"--exactly", maximum});
    CHECK(exactly.code == 0);
    CHECK_THAT(exactly.out, Contains("upper=" + maximum + " lower=" + maximum + " "));
    for (const Words& claim : {Words{"--max", one_less}, Words{"--min", one_more}}) {
        const Outcome refused = verified(file, claim);
        CHECK(refused.code == 1);
        CHECK_THAT(refused.out, Contains("code=claim-not-proved"));
    }
    const Json said = Json::parse(verifier({"--json", file}).out).at(0);
    CHECK(said.at("claim").at("upper") == maximum);
    CHECK(said.at("claim").at("lower") == maximum);

    // A page shows such counts, too. What follows each collision says that there are too many.
    CHECK(dumbbell({"report", file, "--out", folder / "page.html"}).code == 0);
    CHECK_THAT(contents(folder / "page.html"), Contains("\"upper\":\"" + maximum + "\""));
    const Outcome orbit = dumbbell({"plot", "orbit", file, "--out", folder / "orbit.svg"});
    CHECK(orbit.code == 2);
    CHECK_THAT(orbit.err, Contains("collisions"));
}

TEST_CASE("one collision more or less than a maximum beyond 64 bits is rejected") {
    const TemporaryFolder folder;
    const std::string file = certificate(folder, "1e40"), text = contents(file);
    CAPTURE(text);
    const std::string less = with(with(text, "upper", "upper " + one_less), "lower", "lower " + one_less);
    write_sealed(file, less);  // the leaves count too many for it
    CHECK_THAT(verified(file, {}).out, Contains("REJECTED") && Contains("1 + a + b <= U"));
    write_sealed(file, moved_hint(less, "count", '1', '0'));
    CHECK_THAT(verified(file, {}).out, Contains("REJECTED"));

    const std::string more = with(with(text, "upper", "upper " + one_more), "lower", "lower " + one_more);
    write_sealed(file, more);
    CHECK_THAT(verified(file, {}).out, Contains("REJECTED") && Contains("V <= 1 + a + b"));
    write_sealed(file, moved_hint(more, "witness", '1', '2'));
    CHECK_THAT(verified(file, {}).out, Contains("REJECTED") && Contains("G for sigma X"));
}

TEST_CASE("certify stops soon at 10^100") {
    const TemporaryFolder folder;
    const Outcome late =
        dumbbell({"certify", "1e100", "--budget", "1s", "--json", "--out", folder / "late.dbc"});
    CHECK(late.code == 3);
    CHECK_THAT(late.err, Contains("not decided: allow more time"));
    CHECK(Json::parse(late.out).at("seconds") < 10);
}
