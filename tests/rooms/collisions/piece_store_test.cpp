#include "collisions/piece_store.hpp"

#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "catch.hpp"
#include "collisions/certify.hpp"
#include "collisions/reader.hpp"
#include "collisions/writer.hpp"
#include "example.hpp"
#include "file/file_contents.hpp"
#include "file/sha256.hpp"
#include "rooms/not_root.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
namespace fs = std::filesystem;

namespace {

/// A place for a folder of pieces, removed at the end.
struct Folder {
    fs::path path = fs::temp_directory_path() / ("dumbbell-store-" + std::to_string(::getpid()));
    Folder() { fs::remove_all(path); }
    ~Folder() { fs::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
};

Claim claim(long hi) { return {.range = {1, hi}, .gap = Rational(1, 1000)}; }

fs::path only_piece(const Folder& place) {
    for (const auto& entry : fs::directory_iterator(place.path)) {
        if (entry.path().extension() == ".dbc") {
            return entry.path();
        }
    }
    throw std::runtime_error("no piece was kept");
}

}  // namespace

TEST_CASE("a kept piece is found again, by a later run too, and by its own bounds only") {
    const Folder place;
    const Piece piece = dumbbell_test::piece(5, 11, 4, 4);
    {
        const PieceStore store(place.path.string(), claim(100));
        CHECK_FALSE(store.find({5, 11, 4, 4}).has_value());
        store.keep(piece);
    }
    PieceStore store(place.path.string(), claim(100));
    const auto found = store.find({5, 11, 4, 4});
    REQUIRE(found.has_value());
    CHECK(found->cover.leaves() == piece.cover.leaves());
    CHECK(found->witness->eta == piece.witness->eta);
    CHECK_FALSE(store.find({5, 11, 5, 4}).has_value());
    CHECK_FALSE(store.find({5, 12, 4, 4}).has_value());
    store.remove();
    CHECK_FALSE(fs::exists(place.path));
}

TEST_CASE("what cannot be read is not called in use, damaged or another run's") {
    const Folder place;
    { PieceStore(place.path.string(), claim(100)).keep(dumbbell_test::piece(5, 11, 4, 4)); }
    const auto without = [&](const fs::path& hidden, const auto& open) {
        const fs::perms before = fs::status(hidden).permissions();
        fs::permissions(hidden, fs::perms::none);
        {
            const dumbbell_test::NotRoot user;
            CHECK_THROWS_WITH(open(), Contains("'" + hidden.string() + "': Permission denied"));
        }
        fs::permissions(hidden, before);
    };
    without(place.path, [&] { return PieceStore(place.path.string(), claim(100)); });
    without(place.path / "claim", [&] { return PieceStore(place.path.string(), claim(100)); });
    const PieceStore store(place.path.string(), claim(100));
    without(only_piece(place), [&] { return store.find({5, 11, 4, 4}); });
}

TEST_CASE("a piece whose file is not whole, or is another's, is not found") {
    const Folder place;
    const PieceStore store(place.path.string(), claim(100));
    store.keep(dumbbell_test::piece(5, 11, 4, 4));
    const fs::path file = only_piece(place);
    SECTION("truncated") { fs::resize_file(file, fs::file_size(file) - 1); }
    SECTION("empty") { fs::resize_file(file, 0); }
    SECTION("a changed byte") {
        std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
        stream.seekp(100);
        stream.put('#');
    }
    SECTION("a right checksum under what is no certificate") {
        const std::string text = "dumbbell-certificate 1\n";
        std::ofstream(file) << text << "sha256 " << sha256_hex(text) << '\n';
    }
    struct Notes : Observer {
        void note(const std::string& line) override { lines.push_back(line); }
        std::vector<std::string> lines;
    } said;
    CHECK_FALSE(store.find({5, 11, 4, 4}, said).has_value());
    CHECK(said.lines == std::vector{"'" + file.string() + "' is damaged: its piece is proved again"});
    CHECK_FALSE(store.find({5, 12, 4, 4}, said).has_value());
    CHECK(said.lines.size() == 1);  // what was never kept is not damaged
}

TEST_CASE("pieces under each other's names are not found") {
    const Folder place;
    const PieceStore store(place.path.string(), claim(100));
    store.keep(dumbbell_test::piece(5, 11, 4, 4));
    const fs::path first = only_piece(place);
    const fs::path aside = place.path.string() + "-first";
    fs::rename(first, aside);
    store.keep(dumbbell_test::piece(6, 7, 4, 4));
    const fs::path second = only_piece(place);
    SECTION("swapped") {
        fs::rename(second, first);
        fs::rename(aside, second);
        CHECK_FALSE(store.find({5, 11, 4, 4}).has_value());
        CHECK_FALSE(store.find({6, 7, 4, 4}).has_value());
    }
    SECTION("twice") {
        fs::copy_file(aside, first);
        fs::copy_file(aside, second, fs::copy_options::overwrite_existing);
        CHECK(store.find({5, 11, 4, 4}).has_value());
        CHECK_FALSE(store.find({6, 7, 4, 4}).has_value());
    }
    fs::remove(aside);
}

TEST_CASE("what a reader would wait for is in the way of a piece") {
    const Folder place;
    const PieceStore store(place.path.string(), claim(100));
    store.keep(dumbbell_test::piece(5, 11, 4, 4));
    const fs::path file = only_piece(place);
    fs::remove(file);
    REQUIRE(::mkfifo(file.c_str(), 0600) == 0);
    CHECK_THROWS_WITH(store.find({5, 11, 4, 4}), Contains(file.string()) && Contains("remove it"));
}

TEST_CASE("a damaged claim costs no piece, and takes none from another run") {
    const Folder place;
    const std::string claim_file = (place.path / "claim").string();
    { PieceStore(place.path.string(), claim(100)).keep(dumbbell_test::piece(5, 11, 4, 4)); }
    const std::string truth = file_contents(claim_file);
    for (const std::string& damage : {truth.substr(0, 20), std::string(), "x" + truth, truth + "more"}) {
        std::ofstream(claim_file) << damage;
        Claim section = claim(100);
        section.system.section = Section::full;
        for (const Claim& other : {claim(101), section}) {
            CHECK_THROWS_WITH(PieceStore(place.path.string(), other), Contains("another run"));
            CHECK(file_contents(claim_file) == damage);
        }
        const PieceStore store(place.path.string(), claim(100));
        CHECK(store.find({5, 11, 4, 4}).has_value());
        CHECK(file_contents(claim_file) == truth);
    }
    SECTION("nor does a lost one") {
        fs::remove(claim_file);
        CHECK_THROWS_WITH(PieceStore(place.path.string(), claim(101)), Contains("is in the way"));
        CHECK(PieceStore(place.path.string(), claim(100)).find({5, 11, 4, 4}).has_value());
        CHECK(file_contents(claim_file) == truth);
    }
    SECTION("a claim of another run without a piece is in nobody's way") {
        fs::remove(only_piece(place));
        { const PieceStore store(place.path.string(), claim(101)); }
        CHECK_FALSE(fs::exists(place.path));
    }
    SECTION("what is no piece is somebody's") {
        std::ofstream(place.path / GENERATE("thesis.tex", "stairs.dbc")) << "years of work";
        std::ofstream(claim_file) << "x";
        CHECK_THROWS_WITH(PieceStore(place.path.string(), claim(100)), Contains("another run"));
    }
    SECTION("a link is not followed") {
        const fs::path other = place.path.string() + "-other";
        std::ofstream(other) << truth;
        fs::remove(claim_file);
        fs::create_symlink(other, claim_file);
        CHECK_THROWS_WITH(PieceStore(place.path.string(), claim(100)), Contains("another run"));
        CHECK(file_contents(other.string()) == truth);
        fs::remove(other);
    }
}

TEST_CASE("a run that was killed while it made or removed its folder left nothing that is in the way") {
    const Folder place;
    fs::create_directory(place.path);
    { const PieceStore store(place.path.string(), claim(100)); }
    CHECK_FALSE(fs::exists(place.path));

    fs::create_directory(place.path);
    std::ofstream(place.path / "claim.dumbbell-tmp") << "dumbbell-par";
    {
        const PieceStore store(place.path.string(), claim(100));
        store.keep(dumbbell_test::piece(5, 11, 4, 4));
        std::ofstream(only_piece(place).string() + ".dumbbell-tmp") << "dumbbell-cert";
    }
    fs::remove(only_piece(place));  // the claim is removed last
    { const PieceStore store(place.path.string(), claim(100)); }
    CHECK_FALSE(fs::exists(place.path));
}

TEST_CASE("a folder of another claim, or in use, is refused, and an unused one disappears") {
    const Folder place;
    {
        const PieceStore store(place.path.string(), claim(100));
        CHECK_THROWS_WITH(PieceStore(place.path.string(), claim(100)), Contains("in use by another run"));
        store.keep(dumbbell_test::piece(5, 11, 4, 4));
    }
    Claim section = claim(100), gap = claim(100);
    section.system.section = Section::full;
    gap.gap = Rational(1, 1001);
    for (const Claim& other : {claim(101), section, gap}) {
        CHECK_THROWS_WITH(PieceStore(place.path.string(), other), Contains("another run"));
    }
    CHECK(fs::exists(only_piece(place)));
    fs::remove(only_piece(place));
    { const PieceStore store(place.path.string(), claim(100)); }
    CHECK_FALSE(fs::exists(place.path));
}

TEST_CASE("the beginning is what tiles the claim from its lower end, as far as behind a gap") {
    const Folder place;
    const PieceStore store(place.path.string(), claim(100));
    CHECK(store.beginning().empty());
    for (const auto& [lo, hi, upper, lower] :
         {std::tuple(1, 2, 3, 2), std::tuple(2, 5, 3, 3), std::tuple(5, 6, 4, 3), std::tuple(6, 7, 4, 4),
          std::tuple(8, 9, 5, 4)}) {
        store.keep(dumbbell_test::piece(lo, hi, upper, lower));
    }
    CHECK(store.beginning().empty());  // the piece for 1 alone is missing
    store.keep(dumbbell_test::piece(1, 1, 2, 2));
    const auto beginning = store.beginning();
    REQUIRE(beginning.size() == 4);
    CHECK(beginning.back().q_lo == 5);
    CHECK(beginning.back().q_hi == 6);
}

TEST_CASE("a run that had no time for the rest has the kept beginning, and one that has ends as in one go") {
    const Folder place;
    CertifyRequest request;
    request.claim.range = {1, 100};
    const auto bounds = [&] {
        std::vector<PlannedPiece> all;
        for (const ProvedPiece& proved : certify(request)) {
            all.push_back({proved.piece.q_lo, proved.piece.q_hi, as_long(proved.piece.upper.value_or(0)),
                           as_long(proved.piece.lower)});
        }
        return all;
    };
    const auto one_go = bounds();
    const PieceStore store(place.path.string(), request.claim);
    request.store = &store;
    CHECK(bounds() == one_go);
    REQUIRE(store.beginning().size() == one_go.size());
    for (const auto& entry : fs::directory_iterator(place.path)) {
        if (entry.path().extension() == ".dbc" &&
            read_certificate(entry.path().string()).pieces.front().lower > 7) {
            fs::remove(entry);
        }
    }
    request.budget = std::chrono::seconds(0);
    const auto kept = bounds();
    REQUIRE(kept.size() > 2);
    CHECK(std::equal(kept.begin(), kept.end() - 1, one_go.begin()));
    CHECK(kept.back() == PlannedPiece{kept[kept.size() - 2].q_hi, 100, 0, 0});
    CHECK((kept[kept.size() - 2].upper == 8 && kept[kept.size() - 2].lower == 7));
    request.budget.reset();
    CHECK(bounds() == one_go);
}
