#include "file/incoming_lines.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.hpp"
#include "catch.hpp"
#include "temporary_folder.hpp"

using namespace dumbbell_test;
using dumbbell::IncomingLines;
using dumbbell::InputError;

namespace {

using Texts = std::vector<std::string>;

Texts lines_from(const std::string& text) {
    const TemporaryFolder folder;
    write_file(folder / "list", text);
    IncomingLines lines(folder / "list");
    Texts all;
    while (const auto line = lines.next()) {
        all.push_back(*line);
        CHECK(lines.number() == std::ssize(all));
    }
    CHECK(!lines.next());
    return all;
}

}  // namespace

TEST_CASE("lines come without their ends, those of Unix and of Windows, the last one also without an end") {
    CHECK(lines_from("").empty());
    CHECK(lines_from("\n") == Texts{""});
    CHECK(lines_from("10\n\n20") == Texts{"10", "", "20"});
    CHECK(lines_from("10\r\n20\r\n") == Texts{"10", "20"});
    CHECK(lines_from(std::string("1\0x\n", 4)) == Texts{std::string("1\0x", 3)});
}

TEST_CASE("a byte-order mark is left out where a text begins, and only there") {
    CHECK(lines_from("\xef\xbb\xbf"
                     "10\n20\n") == Texts{"10", "20"});
    CHECK(lines_from("10\n\xef\xbb\xbf"
                     "20\n") == Texts{"10",
                                      "\xef\xbb\xbf"
                                      "20"});
}

TEST_CASE("of a line that is too long only the beginning is kept, and the next line is whole") {
    const std::string most(IncomingLines::longest_line, 'x');
    CHECK(lines_from(most + "\n20\n") == Texts{most, "20"});
    CHECK(lines_from(most + std::string(200'000, 'y') + "\n20\n") == Texts{most, "20"});
}

TEST_CASE("a list that cannot be read is named, with the reason") {
    const TemporaryFolder folder;
    CHECK_THROWS_MATCHES(IncomingLines(folder / "none"), InputError,
                         Message("cannot read '" + (folder / "none") + "': no such file"));
    CHECK_THROWS_MATCHES(IncomingLines(folder.path()), InputError,
                         Message("cannot read '" + folder.path() + "': it is a directory"));
}

TEST_CASE("a pipe is read as it comes, and nobody waits for it longer than is wanted") {
    const TemporaryFolder folder;
    REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
    IncomingLines lines(folder / "pipe");
    const int writer = ::open((folder / "pipe").c_str(), O_WRONLY | O_CLOEXEC);
    REQUIRE(::write(writer, "10\n2", 4) == 4);
    CHECK(lines.next() == "10");
    CHECK(!lines.next([] { return true; }));
    REQUIRE(::close(writer) == 0);
}
