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
