#include "base/printable.hpp"

#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "catch.hpp"

using dumbbell::one_line;
using dumbbell::printable;
using dumbbell::shell_file;

namespace {

// What bash makes of a word on its command line.
std::string read_by_shell(const std::string& word) {
    const std::string inner = "printf '%s|' " + word;
    std::string quoted = "'";
    for (const char c : inner) {
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(
        ::popen(("bash -c " + quoted + "'").c_str(), "r"), ::pclose);
    if (!pipe) {
        throw std::runtime_error("no shell");
    }
    std::array<char, 1000> block{};
    return {block.data(), std::fread(block.data(), 1, block.size(), pipe.get())};
}

}  // namespace

TEST_CASE("what is no printable character cannot reach a terminal") {
    CHECK(printable("host-1", 10) == "host-1");
    CHECK(printable("a\x1b[31m\nb\xff", 10) == "a?[31m?b?");
    CHECK(printable("abcdef", 6) == "abcdef");
    CHECK(printable("abcdefg", 6) == "abcdef...");
}

TEST_CASE("a name stays readable in any alphabet, and is one line without control characters") {
    CHECK(one_line("Gr\xc3\xb6\xc3\x9f"
                   "e \xe5\x9c\xb0 \xf0\x9f\x8e\xb1") ==
          "Gr\xc3\xb6\xc3\x9f"
          "e \xe5\x9c\xb0 \xf0\x9f\x8e\xb1");
    CHECK(one_line("a\nb\tc\x7f\x1f\x1b[0m") == "a?b?c???[0m");
    CHECK(one_line("\xc2\x9b"
                   "31m") == "??31m");          // CSI, as UTF-8
    CHECK(one_line("\x9b\xff\xc3") == "???");   // no UTF-8
    CHECK(one_line("\xc2\xa0") == "\xc2\xa0");  // the first that is none of C1
    CHECK(one_line("") == "");
}

TEST_CASE("a quoted word is what the shell reads, and shows no control character") {
    CHECK(shell_file("stairs-1.dbc") == "stairs-1.dbc");
    CHECK(shell_file("a path/x.dbc") == "'a path/x.dbc'");
    CHECK(shell_file("") == "''");
    for (const char* word : {"plain", "a b", "it's", "$HOME", "`x`", "a\\b", "\"", "*", "~", "a\nb",
                             "\x1b[31m'\\", "tab\t", "\xc2\x9bm", "\xff",
                             "Gr\xc3\xb6\xc3\x9f"
                             "e",
                             "1\n2'3\\4 5",
                             "\x1b"
                             "7"}) {
        CAPTURE(word, shell_file(word));
        CHECK(read_by_shell(shell_file(word)) == std::string(word) + "|");
        CHECK(one_line(shell_file(word)) == shell_file(word));
    }
}

TEST_CASE("the name of a file is no option, and a lone dash stays one") {
    CHECK(shell_file("-x.dbc") == "./-x.dbc");
    CHECK(shell_file("--help me") == "'./--help me'");
    CHECK(shell_file("-") == "-");
    CHECK(shell_file("x.dbc") == "x.dbc");
}
