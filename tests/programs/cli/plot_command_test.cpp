#include <tuple>

#include "catch.hpp"
#include "programs.hpp"
#include "rooms/wings/pictures/xml.hpp"

using namespace dumbbell_test;

namespace {

// One certificate of each kind, made once.
const TemporaryFolder& certificates() {
    static const TemporaryFolder folder;
    static const bool made = [] {
        REQUIRE(dumbbell({"certify", "10", "--out", "ten.dbc"}, folder.path()).code == 0);
        REQUIRE(dumbbell({"certify", "1:12", "--out", "stairs.dbc"}, folder.path()).code == 0);
        REQUIRE(dumbbell({"certify", "--coin", "--out", "coin.dbc"}, folder.path()).code == 0);
        REQUIRE(dumbbell({"trace", "10", "--phi", "0:3", "--phidot", "1", "--y", "2", "--ydot=-2:1",
                          "--subdivide", "--max-boxes", "300", "--out", "falling.dbc"},
                         folder.path())
                    .code == 0);
        REQUIRE(dumbbell({"adiabatic", "--delta", "0.01", "--phi-margin", "0.7", "--out", "adiabatic.dbc"},
                         folder.path())
                    .code == 0);
        return true;
    }();
    (void)made;
    return folder;
}

// The picture of `words`, drawn without a word.
std::string picture(Words words) {
    const TemporaryFolder folder;
    const std::string path = folder / "picture.svg";
    words.insert(words.begin(), "plot");
    words.insert(words.end(), {"--out", path});
    const Outcome result = dumbbell(words, certificates().path());
    CAPTURE(words, result.err);
    REQUIRE(result.code == 0);
    CHECK(result.out.empty());
    CHECK(result.err.empty());
    CHECK(folder.names() == Words{"picture.svg"});
    std::string svg = contents(path);
    CHECK(well_formed(svg));
    return svg;
}

// The one line on stderr of a picture that is refused; no file is left.
std::string refusal(Words words) {
    const TemporaryFolder folder;
    words.insert(words.begin(), "plot");
    words.insert(words.end(), {"--out", folder / "picture.svg"});
    const Outcome result = dumbbell(words, certificates().path());
    CAPTURE(words, result.err);
    CHECK(result.code == 2);
    CHECK(count_lines(result.err) == 1);
    CHECK(folder.names().empty());
    return result.err;
}

}  // namespace

TEST_CASE("every picture is drawn from a certificate of its kind, twice the same", "[wings]") {
    for (const Words& words : std::vector<Words>{{"orbit", "ten.dbc"},
                                                 {"orbit", "stairs.dbc", "--ratio", "9/2"},
                                                 {"orbit", "100"},
                                                 {"phase", "falling.dbc"}}) {
        CAPTURE(words);
        CHECK(picture(words) == picture(words));
    }
    CHECK(picture({"orbit", "ten.dbc"}) == picture({"orbit", "10"}));
    CHECK_THAT(picture({"orbit", "100"}), Contains("q = 100: an orbit with 10 collisions"));
    CHECK_THAT(picture({"orbit", "1/100"}), Contains("q = 100"));  // the masses are swapped
}

TEST_CASE("a certificate of another kind is refused with the command that makes the right one", "[wings]") {
    CHECK_THAT(refusal({"phase", "ten.dbc"}), Contains("dumbbell trace") && Contains("--subdivide"));
    CHECK_THAT(refusal({"phase", "adiabatic.dbc"}),
               Contains("adiabatic invariant") && Contains("dumbbell trace"));
    CHECK_THAT(refusal({"staircase", "falling.dbc"}), Contains("dumbbell certify LO:HI"));
    CHECK_THAT(refusal({"staircase", "ten.dbc"}), Contains("needs a range"));
    CHECK_THAT(refusal({"orbit", "adiabatic.dbc"}), Contains("dumbbell certify RATIO"));
    CHECK_THAT(refusal({"orbit", "falling.dbc"}), Contains("dumbbell certify RATIO"));
    CHECK_THAT(refusal({"orbit", "coin.dbc"}), Contains("scene body"));
}

TEST_CASE("a range needs --ratio, and one that it has, and nothing else takes it", "[wings]") {
    CHECK_THAT(refusal({"orbit", "stairs.dbc"}), Contains("--ratio"));
    CHECK_THAT(refusal({"orbit", "ten.dbc", "--ratio", "11"}), Contains("nothing about the mass ratio 11"));
    CHECK_THAT(refusal({"orbit", "stairs.dbc", "--ratio", "2:3"}), Contains("single"));
    CHECK_THAT(refusal({"orbit", "10", "--ratio", "10"}), Contains("one mass ratio"));
    CHECK_THAT(refusal({"orbit", "1:10"}), Contains("one mass ratio"));
    CHECK_THAT(refusal({"orbit", "1e9"}), Contains("too many collisions"));
    CHECK_THAT(refusal({"orbit", "nowhere.dbc"}), Contains("nowhere.dbc"));
}

TEST_CASE("what is not verified is not drawn, whatever the kind", "[wings]") {
    for (const auto& [word, file] : {std::pair{"orbit", "ten.dbc"}, std::pair{"phase", "falling.dbc"},
                                     std::pair{"staircase", "stairs.dbc"}}) {
        CAPTURE(word);
        std::string text = contents(certificates() / file);
        const std::size_t seal = text.rfind("sha256 ") + 7;
        text[seal] = text[seal] == '0' ? '1' : '0';
        write_file(certificates() / "forged.dbc", text);
        CHECK_THAT(refusal({word, "forged.dbc"}), Contains("not verified"));
    }
}

TEST_CASE("the pictures of docs/ are what the program draws from the shipped certificates", "[wings]") {
    const auto without_digits = [](std::string text) {  // another C library may round a length otherwise
        std::erase_if(text, [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-'; });
        return text;
    };
    const std::string root = DUMBBELL_PROJECT "/";
    for (const auto& [word, certificate, name] : {std::tuple{"staircase", "stairs-1-1e4.dbc.gz", "staircase"},
                                                  std::tuple{"orbit", "q-100.dbc", "orbit-100"}}) {
        CAPTURE(name);
        const std::string drawn = picture({word, root + "certificates/" + certificate});
        CHECK(without_digits(drawn) == without_digits(contents(root + "docs/pictures/" + name + ".svg")));
    }
}
