// A long `certify LO:HI --out FILE` keeps its finished pieces in FILE.partial and goes on from there.
#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;

namespace {

const Words request{"certify", "1:30000", "--gap", "1e-12", "--out", "stairs.dbc"};

/// Kills the run as soon as this number of files is in its folder of finished pieces; false if it had ended
/// before.
bool killed_with(std::size_t files, const TemporaryFolder& folder) {
    Process process(with_program(request), folder.path());
    process.until([&] { return kept(folder / "stairs.dbc.partial") >= files; });
    process.kill();
    return process.wait().signal == SIGKILL;
}

/// Leaves some finished pieces; begins again if the run had ended before it was killed.
void leave_pieces(const TemporaryFolder& folder) {
    while (!killed_with(12, folder)) {
        std::filesystem::remove(folder / "stairs.dbc");
    }
}

}  // namespace

TEST_CASE("each finished piece is a certificate of its own") {
    const TemporaryFolder folder;
    leave_pieces(folder);
    int pieces = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "stairs.dbc.partial")) {
        if (entry.path().extension() == ".dbc") {
            ++pieces;
            CHECK(verifier({entry.path().string()}).code == 0);
        }
    }
    CHECK(pieces >= 5);
}

TEST_CASE("with other arguments it stops, and the finished pieces stay") {
    const TemporaryFolder folder;
    leave_pieces(folder);
    const std::size_t before = kept(folder / "stairs.dbc.partial");
    for (const Words& other :
         {Words{"certify", "100", "--out", "stairs.dbc"},
          Words{"certify", "1:30001", "--gap", "1e-12", "--out", "stairs.dbc"},
          Words{"certify", "1:30000", "--gap", "1e-11", "--out", "stairs.dbc"},
          Words{"certify", "1:30000", "--gap", "1e-12", "--out", "stairs.dbc", "--section", "full"}}) {
        const Outcome refused = dumbbell(other, folder.path());
        CHECK(refused.code == 2);
        CHECK_THAT(refused.err, Contains("'stairs.dbc.partial' holds the finished pieces of another run"));
    }
    CHECK(kept(folder / "stairs.dbc.partial") == before);
    Words same = request;
    same.insert(same.end(), {"--jobs", "1", "--json"});
    CHECK(dumbbell(same, folder.path()).code == 0);
}

TEST_CASE("what is no folder of finished pieces is left alone") {
    const TemporaryFolder folder;
    const std::string place = folder / "stairs.dbc.partial";
    write_file(place, "mine");
    Outcome refused = dumbbell(request, folder.path());
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err, Contains("is in the way"));
    CHECK(contents(place) == "mine");
    std::filesystem::remove(place);
    std::filesystem::create_directory(place);
    write_file(place + "/letter", "mine");
    refused = dumbbell(request, folder.path());
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err, Contains("is in the way"));
    CHECK(contents(place + "/letter") == "mine");
    CHECK(folder.names() == Words{"stairs.dbc.partial"});
}

TEST_CASE("two runs do not share a folder of finished pieces") {
    const TemporaryFolder folder;
    const Process first(with_program({"certify", "1:1000000", "--gap", "1e-9", "--out", "stairs.dbc"}),
                        folder.path());
    REQUIRE(first.until([&] { return kept(folder / "stairs.dbc.partial") >= 2; }));
    first.send(SIGSTOP);
    const Outcome second =
        dumbbell({"certify", "1:1000000", "--gap", "1e-9", "--out", "stairs.dbc"}, folder.path());
    CHECK(second.code == 2);
    CHECK_THAT(second.err, Contains("in use by another run"));
}

TEST_CASE("a budget that ends early keeps the finished pieces for the next call") {
    const TemporaryFolder undisturbed;
    REQUIRE(dumbbell(request, undisturbed.path()).code == 0);
    const TemporaryFolder folder;
    Words limited = request;
    limited.insert(limited.end(), {"--budget", "0.05s"});
    const Outcome open = dumbbell(limited, folder.path());
    if (open.code == 3 && std::filesystem::exists(folder / "stairs.dbc.partial")) {
        CHECK_THAT(open.err, Contains("goes on with the finished pieces in 'stairs.dbc.partial'"));
    }
    REQUIRE(dumbbell(request, folder.path()).code == 0);
    CHECK(contents(folder / "stairs.dbc") == contents(undisturbed / "stairs.dbc"));
    CHECK(folder.names() == Words{"stairs.dbc"});
}
