// The lines `s PART` in a file of anything.
#include "verify/program/part_lines.hpp"

#include <catch2/catch.hpp>

#include "make_certificate.hpp"
#include "verify/program/version.hpp"

using namespace dumbbell_verify;
using make::File;
using make::replaced;

namespace {

const std::string& line() {
    static const std::string text =
        "s PART pieces=2-5 of=9 scene=dumbbell section=turning ratio=10/1:21/2 upper=4 lower=3 gaps=2 open=0 "
        "precision=none verifier=" +
        std::string(version) + " sha256=" + std::string(64, 'a');
    return text;
}

/// "2-5 7-7 ": the pieces of all lines; or the word of the failure and its text, with PARTS for the name.
std::string pieces_of_lines(const std::string& bytes) {
    const File file(bytes);
    std::string found;
    try {
        PartLines lines(file.path());
        while (const PartLine* part = lines.next())
            found += std::to_string(part->pieces.first) + "-" + std::to_string(part->pieces.last) + " ";
        return found;
    } catch (const Failure& failure) {
        CHECK(failure.line == 0);
        return failure.code + " " + replaced(failure.text, file.path(), "PARTS");
    }
}
const std::string refused = ": not as dumbbell-verify --shards prints it: `";

}  // namespace

TEST_CASE("lines of parts: other lines are skipped, whatever they are") {
    CHECK(pieces_of_lines("").empty());
    CHECK(pieces_of_lines(line()) == "2-5 ");
    CHECK(pieces_of_lines(line() + "\n" + line() + "\n") == "2-5 2-5 ");
    CHECK(pieces_of_lines("file.dbc\n\n  count 3 line(s)\ns\nsPART\nS PART\n s PART\nc files=2\n" + line() +
                          "\n") == "2-5 ");
    CHECK(pieces_of_lines(std::string("\0\0s PART\n", 9) + "\xff\xfe\n\r\n\x1f\x8b\n" + line()) == "2-5 ");
    CHECK(pieces_of_lines("\xef\xbb\xbf" + line()).empty());  // skipped means: a hole
    CHECK(pieces_of_lines(replaced(line(), "2-5", "7") + "\n" + line()) == "7-7 2-5 ");
}

TEST_CASE("lines of parts: any other line of a verdict is an error that names it") {
    for (const char* other :
         {"s VERIFIED scene=dumbbell", "s REJECTED line=3 code=count", "s LIMIT out of memory", "s PART",
          "s PART ", "s PARTS pieces=1-1", "s part", "s ", "s  PART"}) {
        INFO(other);
        CHECK(pieces_of_lines(line() + "\n\n" + other + "\n") ==
              "unreadable PARTS:3" + refused + other + "`");
    }
}

TEST_CASE("lines of parts: each field in its place, once, with a value, and nothing after it") {
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"pieces=2-5", "pieces=5-2"},
             {"pieces=2-5", "pieces=0-5"},
             {"pieces=2-5", "pieces=2-1000000000000000000"},
             {"pieces=2-5", "pieces=2-18446744073709551617"},
             {"pieces=2-5", "pieces=02-5"},
             {"pieces=2-5", "pieces="},
             {"pieces=2-5", "pieces"},
             {"pieces=2-5 ", ""},
             {"pieces=2-5", "pieces=2-5 pieces=2-5"},
             {"pieces=2-5 of=9", "of=9 pieces=2-5"},
             {"of=9", "Of=9"},
             {"of=9", " of=9"},
             {"of=9", "of="},
             {"of=9", "of=9\t"},
             {"precision=none", "precision=0"},
             {"precision=none", "precision=52"},
             {"precision=none", "precision=4097"},
             {"precision=none", "precision=0060"},
             {"precision=none", "precision=18446744073709551676"},
             {"precision=none", "precision=None"},
             {" verifier=" + std::string(version), ""},
             {"sha256=a", "sha256="},
             {"sha256=a", "sha256=aa"},
             {"sha256=a", "sha256=A"},
             {"sha256=a", "sha256=g"},
             {"sha256=a", std::string("sha256=\0", 8)},
         }) {
        const std::string wrong = replaced(line(), from, to);
        INFO(wrong);
        const std::string result = pieces_of_lines(wrong);
        if (to != "of=9\t") CHECK(result.starts_with("unreadable PARTS:1" + refused));
    }
    for (const char* tail : {"x", " file=a.dbc", "\r", " parts=2"}) {
        INFO(tail);
        CHECK(pieces_of_lines(line() + tail + "\n").starts_with("unreadable PARTS:1" + refused));
    }
    CHECK(pieces_of_lines(replaced(line(), "precision=none", "precision=53")) == "2-5 ");
    CHECK(pieces_of_lines(replaced(line(), "precision=none", "precision=4096")) == "2-5 ");
}

TEST_CASE("lines of parts: one that is cut off is none, wherever it is cut") {
    for (std::size_t n = 2; n < line().size(); ++n) {
        INFO(n);
        const std::string result = pieces_of_lines(line().substr(0, n));
        const std::size_t at = line().find("verifier=");
        const bool version_cut = n >= at + 8 && n < at + 9 + version.size();
        REQUIRE(result.starts_with(version_cut ? "unsupported " : "unreadable "));
    }
    CHECK(pieces_of_lines(line().substr(0, 1)).empty());
}

TEST_CASE("lines of parts: of another version of the verifier, whatever else they say") {
    const std::string now = "verifier=" + std::string(version),
                      told = ", this is " + std::string(version) +
                             ": verify these pieces again with this "
                             "one, by --shards";
    CHECK(pieces_of_lines("\n" + replaced(line(), now, "verifier=0.0.1")) ==
          "unsupported PARTS:2: printed by dumbbell-verify 0.0.1" + told);
    CHECK(pieces_of_lines(replaced(line(), now, now + "0")).starts_with("unsupported PARTS:1: "));
    CHECK(pieces_of_lines("s PART verifier=2.0 shard=3\n") ==
          "unsupported PARTS:1: printed by dumbbell-verify 2.0" + told);
    CHECK(pieces_of_lines("s PART verifier= x\n")
              .starts_with("unsupported PARTS:1: printed by dumbbell-verify ,"));
    CHECK(pieces_of_lines(replaced(line(), now, now + " verifier=9")).starts_with("unsupported PARTS:1: "));
}

TEST_CASE("lines of parts: no file, a folder, a line without end, a file without end") {
    const auto opened = [](const std::string& path) {
        try {
            PartLines lines(path);
            while (lines.next()) {
            }
            return std::string("read");
        } catch (const Failure& failure) {
            return failure.code + " " + failure.text;
        }
    };
    CHECK(opened("/nonexistent") == "unreadable /nonexistent: No such file or directory");
    CHECK(opened("/tmp") == "unreadable /tmp: Is a directory");
    CHECK(opened("/dev/null") == "read");
    CHECK(opened("/dev/zero") == "unreadable /dev/zero:1: a line of more than 16384 bytes");
    CHECK(pieces_of_lines(std::string(16384, 'x') + "\n" + line()) == "2-5 ");
    CHECK(pieces_of_lines(line() + "\n" + std::string(16385, 'x')) ==
          "unreadable PARTS:2: a line of more than 16384 bytes");
    CHECK(pieces_of_lines("s PART " + std::string(1 << 20, ' ')) ==
          "unreadable PARTS:1: a line of more than 16384 bytes");
}

TEST_CASE("lines of parts: a line that lies across the end of a block is read as one") {
    for (std::size_t before = (1 << 16) - line().size() - 3; before < (1 << 16) + 2; before += 7) {
        std::string text;
        while (text.size() + 1001 < before) text += std::string(1000, '.') + "\n";
        text += std::string(before - text.size() - 1, '.') + "\n" + line() + "\n";
        INFO(before);
        REQUIRE(pieces_of_lines(text) == "2-5 ");
    }
}
