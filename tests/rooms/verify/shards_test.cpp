// A part is verified if its own leaves are right and the whole file is well-formed.
#include <catch2/catch.hpp>

#include "make_parts.hpp"

using namespace dumbbell_verify;
using make::closed;
using make::combined;
using make::File;
using make::hashed;
using make::mutated;
using make::replaced;
using make::shard;
using make::stairs_pieces;
using make::stairs_to_100;
using make::whole;

namespace {

/// The text with something in the piece of this number replaced, and a trailer that fits.
std::string changed(const std::string& text, std::uint64_t number, const std::string& from,
                    const std::string& to) {
    std::size_t at = 0;
    for (std::uint64_t i = 0; i < number; ++i) at = text.find("\npiece ", at + 1);
    const std::size_t end = std::min(text.find("\npiece ", at + 1), text.find("\ntotal "));
    const std::string piece = text.substr(at, end - at);
    return closed(text.substr(0, at) + replaced(piece, from, to) +
                  text.substr(end, text.find("total ") - end));
}
std::uint64_t value(const std::string& text, std::uint64_t number, const std::string& word) {
    std::size_t at = 0;
    for (std::uint64_t i = 0; i < number; ++i) at = text.find("\npiece ", at + 1);
    return std::stoull(text.substr(text.find("\n" + word + " ", at) + word.size() + 2));
}

/// The file is rejected for the given piece, by exactly the parts that have it, and never put together.
void check_rejected_for(const std::string& text, std::uint64_t number, std::mt19937& random) {
    const File file(text);
    const std::string verdict = whole(file.path());
    INFO(number << " " << verdict);
    REQUIRE(verdict.starts_with("s REJECTED line="));
    REQUIRE(verdict.find(" not certified: ") != std::string::npos);
    for (int i = 0; i < 5; ++i) {
        std::string lines;
        Pieces hole;
        for (const Pieces& part : make::random_cut(stairs_pieces, random)) {
            const std::string line = shard(file.path(), part);
            INFO(part.first << "-" << part.last << " " << line);
            REQUIRE(line.starts_with("s PART ") == !part.have(number));
            if (part.have(number)) {
                REQUIRE(line == verdict);
                hole = part;
            } else {
                lines += line + "\n";
            }
        }
        const std::string result = combined(file.path(), lines);
        REQUIRE(result.starts_with("s REJECTED code=parts piece"));
        REQUIRE(result.find(std::to_string(hole.first)) != std::string::npos);
    }
}

}  // namespace

TEST_CASE("shards: one false leaf or witness is rejected by exactly the part that has it, whatever the cut") {
    const std::string text = make::contents(stairs_to_100);
    std::mt19937 random(3);
    int gaps = 0;
    for (std::uint64_t i = 1; i <= stairs_pieces; ++i) {
        const std::uint64_t upper = value(text, i, "upper"), lower = value(text, i, "lower");
        if (upper == lower) continue;
        ++gaps;
        const std::string u = std::to_string(upper), l = std::to_string(lower);
        check_rejected_for(changed(text, i, "\nupper " + u, "\nupper " + l), i, random);
        check_rejected_for(changed(text, i, "\nlower " + l, "\nlower " + u), i, random);
    }
    CHECK(gaps == 8);
}

TEST_CASE("shards: the false claim across a critical ratio is rejected by the part that has it") {
    const std::string path = DUMBBELL_PROJECT "/tests/attacks/false_claims/across-gap.dbc",
                      verdict = whole(path);
    REQUIRE(verdict.starts_with("s REJECTED line=22 code=count "));
    int rejected = 0;
    for (std::uint64_t i = 1; i <= 3; ++i) {
        const std::string line = shard(path, {i, i});
        CHECK((line == verdict || line.starts_with("s PART pieces=" + std::to_string(i) + "-")));
        rejected += line == verdict ? 1 : 0;
    }
    CHECK(rejected == 1);
    CHECK(shard(path, {1, 3}) == verdict);
}

TEST_CASE("shards: what is wrong without any leaf is rejected by every part") {
    const std::string text = make::contents(stairs_to_100);
    const std::string body = text.substr(0, text.find("total split"));
    std::vector<std::string> wrong{
        text + "\n",
        text + "x",
        text.substr(0, text.size() - 1),
        body,
        replaced(text, "sha256 f", "sha256 e"),
        hashed(body + replaced(make::totals(body), "total open 0", "total open 1")),
        hashed(body + replaced(make::totals(body), "total count ", "total count 1")),
        replaced(text, "generator dumbbell", "generator dumbbel"),
        mutated(text, "ratio 1/1 100/1", "ratio 1/1 101/1"),
        mutated(text, "pieces 17", "pieces 18"),
        make::gzipped(text) + "x",
        make::gzipped(text).substr(0, 700),
    };
    for (const std::uint64_t i : {1, 2, 9, 17}) {
        const std::string u = std::to_string(value(text, i, "upper")),
                          l = std::to_string(value(text, i, "lower"));
        wrong.push_back(changed(text, i, "\nlower " + l, "\nlower 1" + u));  // lower above upper
        wrong.push_back(changed(text, i, "\nbits ", "\nbits 0"));
        wrong.push_back(changed(text, i, "\nbits 53", "\nbits 52"));
        wrong.push_back(changed(text, i, "\nwitness bridge", "\nwitness light"));
        wrong.push_back(changed(text, i, "\nlower ", "\nlower 0\nlower "));
        wrong.push_back(changed(text, i, "\npiece 1", "\npiece 2"));  // the chain
        if (i > 1) {
            wrong.push_back(changed(text, i, "\ncount ", "\ncounted "));
            wrong.push_back(changed(text, i, "\ncount ", "\nsplit e\ncount "));
            wrong.push_back(changed(text, i, "\nchart light", "\nchart bridge"));
        }
    }
    for (const std::string& bytes : wrong) {
        const File file(bytes);
        const std::string verdict = whole(file.path());
        INFO(verdict);
        REQUIRE(verdict.starts_with("s REJECTED line="));
        REQUIRE(verdict.find("not certified") == std::string::npos);
        for (const Pieces& part : {Pieces{1, 1}, Pieces{2, 8}, Pieces{9, 9}, Pieces{17, 17}, Pieces{1, 17}})
            REQUIRE(shard(file.path(), part) == verdict);
        REQUIRE(combined(file.path(), "") == verdict);
    }
}

TEST_CASE("shards: the piece that needs too high a precision stops only the part that has it") {
    const File file(mutated(make::four_pieces(), "bits 53\nupper none", "bits 3000\nupper none"));
    CHECK(whole(file.path()).starts_with("s LIMIT "));
    CHECK(shard(file.path(), {1, 1}).starts_with("s PART "));
    CHECK(shard(file.path(), {1, 2}) == whole(file.path()));
    CHECK(shard(file.path(), {3, 4}).starts_with("s PART "));
}

TEST_CASE("shards: pieces that the file has not are told by the header, before any leaf") {
    const File cut_off(make::four_pieces().substr(0, make::four_pieces().find("piece ")));
    CHECK(shard(cut_off.path(), {5, 5}) == "s UNREADABLE line=8 there is no piece 5: the file has 4 pieces");
    CHECK(shard(cut_off.path(), {1, 999'999'999'999'999'999}) ==
          "s UNREADABLE line=8 there is no piece 999999999999999999: the file has 4 pieces");
    CHECK(shard(cut_off.path(), {4, 4}).find("code=truncated") != std::string::npos);
    CHECK(shard(make::shipped("q-10.dbc"), {1, 2}) ==
          "s UNREADABLE line=8 there is no piece 2: the file has 1 piece");
}

TEST_CASE("shards: every scene and section, and its scene must be asked for") {
    CHECK(shard(make::shipped("wedge-1-100.dbc"), {3, 4}, 0, "wedge")
              .starts_with("s PART pieces=3-4 of=29 scene=wedge "));
    CHECK(shard(make::shipped("wedge-1-100.dbc"), {3, 4})
              .ends_with(" code=claim-not-proved the scene is wedge, and dumbbell was demanded (--scene)"));
    CHECK(shard(make::shipped("full-100.dbc.gz"), {1, 1}).find(" scene=dumbbell section=full ") !=
          std::string::npos);
}
