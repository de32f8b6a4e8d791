#include <catch2/catch.hpp>

#include "programs.hpp"

using namespace dumbbell_test;
using Catch::Matchers::Contains;

TEST_CASE("plot staircase draws a certificate, plain or compressed, and says nothing") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell({"certify", "1:100", "--out", "stairs.dbc"}, folder.path()).code == 0);
    REQUIRE(dumbbell({"certify", "1:100", "--out", "stairs.dbc.gz"}, folder.path()).code == 0);
    const Outcome plain = dumbbell({"plot", "staircase", "stairs.dbc", "--out", "one.svg"}, folder.path());
    CHECK(plain.code == 0);
    CHECK(plain.out.empty());
    CHECK(plain.err.empty());
    CHECK(dumbbell({"plot", "staircase", "stairs.dbc.gz", "--out", "two.svg"}, folder.path()).code == 0);
    CHECK(contents(folder / "one.svg") == contents(folder / "two.svg"));
    CHECK_THAT(contents(folder / "one.svg"), Contains("<svg") && Contains("class=\"proved\" d=") &&
                                                 Contains("class=\"paper\" d=") && Contains("</svg>"));
}

TEST_CASE("the certificate of a single ratio is no staircase: one line, exit 2, no picture") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell({"certify", "10", "--out", "ten.dbc"}, folder.path()).code == 0);
    const Outcome result = dumbbell({"plot", "staircase", "ten.dbc", "--out", "ten.svg"}, folder.path());
    CHECK(result.code == 2);
    CHECK(count_lines(result.err) == 1);
    CHECK(folder.names() == Words{"ten.dbc"});
}

TEST_CASE("a damaged certificate does not replace an older picture") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell({"certify", "1:10", "--out", "stairs.dbc"}, folder.path()).code == 0);
    write_file(folder / "stairs.svg", "old");
    const std::string text = contents(folder / "stairs.dbc");
    write_file(folder / "half.dbc", text.substr(0, text.size() / 2));
    CHECK(dumbbell({"plot", "staircase", "half.dbc", "--out", "stairs.svg"}, folder.path()).code == 2);
    CHECK(contents(folder / "stairs.svg") == "old");
}

TEST_CASE("the picture of a wedge names its scene and does not show the dumbbell's bound") {
    const TemporaryFolder folder;
    for (const std::string scene : {"wedge", "hybrid"}) {
        CAPTURE(scene);
        REQUIRE(dumbbell({"certify", "1:10", "--scene", scene, "--out", "stairs.dbc"}, folder.path()).code ==
                0);
        REQUIRE(dumbbell({"plot", "staircase", "stairs.dbc", "--out", "stairs.svg"}, folder.path()).code ==
                0);
        const std::string svg = contents(folder / "stairs.svg");
        CHECK_THAT(svg,
                   Contains("scene " + scene) && !Contains("dumbbell") && !Contains("the paper's bound"));
    }
}
