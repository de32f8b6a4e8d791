#include "file/unpacked_text.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "file/atomic_file.hpp"
#include "programs/cli/process.hpp"

using namespace dumbbell_test;
using dumbbell::AtomicFile;
using dumbbell::InputError;
using dumbbell::UnpackedText;

namespace {

using Lines = std::vector<std::string>;

Lines lines_in(const std::string& bytes) {
    const TemporaryFolder folder;
    write_file(folder / "file", bytes);
    UnpackedText text(folder / "file");
    Lines lines;
    for (std::string_view line = text.next_line(); !line.empty(); line = text.next_line()) {
        lines.emplace_back(line);
    }
    CHECK(text.next_line().empty());
    return lines;
}

std::string packed(const std::string& text) {
    const TemporaryFolder folder;
    AtomicFile(folder / "file.gz").commit(text);
    return contents(folder / "file.gz");
}

// More than a block, also compressed.
std::string long_text() {
    std::string text;
    unsigned long random = 1;
    for (int i = 0; i < 20'000; ++i) {
        random = random * 6364136223846793005UL + 1442695040888963407UL;
        text += std::to_string(random) + "\n";
    }
    return text;
}

void is_damaged(const std::string& bytes, const std::string& how) {
    CHECK_THROWS_WITH(lines_in(bytes), Contains("file' is damaged: " + how));
}

}  // namespace

TEST_CASE("lines are read as they stand there, plain or compressed") {
    for (const Lines& lines : {Lines{}, Lines{"a\n", "\n", "b"}, Lines{std::string("a\0b\n", 4), "c\n"}}) {
        std::string text;
        for (const std::string& line : lines) {
            text += line;
        }
        CHECK(lines_in(text) == lines);
        CHECK(lines_in(packed(text)) == lines);
    }
    const std::string text = long_text(), small = packed(text);
    REQUIRE(small.size() > 100'000);
    CHECK(lines_in(text) == lines_in(small));
    CHECK(lines_in(text).size() == 20'000);
}

TEST_CASE("a line that is too long comes in parts") {
    const std::string most(UnpackedText::longest_line - 1, 'x');
    CHECK(lines_in(most + "\n" + most + "xy\n") == Lines{most + "\n", most + "x", "y\n"});
}

TEST_CASE("a compressed file is one member, whole, and nothing after it") {
    const std::string text = long_text(), whole = packed(text);
    for (const std::string& after : {std::string("x"), std::string("\0", 1), packed("more\n"), packed("")}) {
        is_damaged(whole + after, "bytes after the gzip member");
        is_damaged(packed("line\n") + after, "bytes after the gzip member");
    }
    const std::string one = packed("line\n");
    for (std::size_t length = 2; length < one.size(); ++length) {
        is_damaged(one.substr(0, length), "the compressed file is truncated");
    }
    is_damaged(whole.substr(0, whole.size() / 2), "the compressed file is truncated");
    for (const std::size_t at : {std::size_t(2), one.size() - 1, one.size() - 5}) {  // method, length, CRC-32
        std::string changed = one;
        changed[at] = static_cast<char>(changed[at] ^ 1);
        is_damaged(changed, "it cannot be unpacked");
    }
}
