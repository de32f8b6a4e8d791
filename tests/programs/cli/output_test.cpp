// Where --out leads: never over what is read, through links, to no device, to a name that says what it is;
// and what - means.
#include <sys/stat.h>

#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;
namespace fs = std::filesystem;

namespace {

// In the folder, a command that must be refused in one line, which is returned, before it says anything else.
std::string refused_in(const TemporaryFolder& folder, const Words& words) {
    const auto names = folder.names();
    const Outcome result = dumbbell(words, folder.path());
    CAPTURE(words, result.out, result.err);
    CHECK(result.code == 2);
    CHECK(result.out.empty());
    CHECK(count_lines(result.err) == 1);
    CHECK(folder.names() == names);
    return result.err;
}

const Words trace{"trace", "10",  "--phi",  "0.3:0.31", "--phidot",   "0",
                  "--y",   "3/2", "--ydot", "-1",       "--subdivide"};

Words with(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

// With the file as standard input.
Outcome fed(const std::string& file, const std::string& words, const std::string& folder = ".") {
    return run({"sh", "-c", "cat '" + file + "' | exec " DUMBBELL_BIN " " + words}, folder);
}

}  // namespace

TEST_CASE("an output that is an input is refused, whatever it is called", "[wings]") {
    const TemporaryFolder folder;
    const std::string file = certificate(folder, "1:20");
    const std::string before = contents(file);
    fs::create_symlink(file, folder / "soft.svg");
    fs::create_hard_link(file, folder / "hard.svg");
    fs::create_hard_link(file, folder / "hard.html");
    for (const char* name : {"soft.svg", "hard.svg", "./hard.svg"}) {
        for (const char* picture : {"staircase", "orbit"}) {
            const std::string said = refused_in(folder, {"plot", picture, file, "--out", name});
            CHECK_THAT(said, Contains("which is read") || Contains("ends in .svg"));
        }
    }
    CHECK_THAT(refused_in(folder, {"plot", "staircase", "hard.svg", "--out", "hard.svg"}),
               Contains("which is read"));
    CHECK_THAT(refused_in(folder, {"report", certificate(folder, "10"), file, "--out", "hard.html"}),
               Contains("which is read"));
    CHECK(run({"sh", "-c", "exec " DUMBBELL_BIN " plot staircase - --out hard.svg < hard.svg"}, folder.path())
              .code == 2);
    CHECK(contents(file) == before);
}

TEST_CASE("a name that does not say what is written is refused before any work", "[wings]") {
    const TemporaryFolder folder;
    const std::string stairs = certificate(folder, "1:20");
    const Words longest{"certify", "1:1000000", "--gap", "1e-9"};
    for (const char* name : {"x.png", "x.svg", "x", "x.dbc.xz", "x.gz", ".dbc", "x.tsv", "x.DBC"}) {
        CHECK_THAT(refused_in(folder, with(longest, {"--out", name})), Contains("ends in .dbc or .dbc.gz"));
        CHECK_THAT(refused_in(folder, with(trace, {"--out", name})), Contains("ends in .dbc or .dbc.gz"));
        CHECK_THAT(refused_in(folder, {"adiabatic", "--delta", "0.01", "--out", name}),
                   Contains("ends in .dbc"));
    }
    CHECK_THAT(refused_in(folder, {"critical", "3:1000", "--out", "x.dbc"}),
               Contains("ends in .tsv or .tsv.gz"));
    CHECK_THAT(refused_in(folder, {"plot", "staircase", stairs, "--out", "x.png"}), Contains("ends in .svg"));
    CHECK_THAT(refused_in(folder, {"report", stairs, "--out", "x.svg"}), Contains("ends in .html"));
}

TEST_CASE("an output through links is written where they lead, and they stay") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "sub");
    write_file(folder / "sub/old.dbc", "old");
    fs::create_symlink("sub/old.dbc", folder / "first");
    fs::create_symlink("first", folder / "second.dbc");
    fs::create_symlink("sub/new.dbc.gz", folder / "dangling");
    for (const char* name : {"second.dbc", "dangling"}) {
        REQUIRE(dumbbell({"certify", "10", "--out", name}, folder.path()).code == 0);
        CHECK(fs::is_symlink(folder / name));
        CHECK(verifier({folder / name}).code == 0);
    }
    CHECK(fs::is_symlink(folder / "first"));
    CHECK_THAT(contents(folder / "sub/old.dbc"), StartsWith("dumbbell-certificate 1\n"));
    CHECK_THAT(contents(folder / "sub/new.dbc.gz"), StartsWith("\x1f\x8b"));
    fs::create_symlink("circle.dbc", folder / "circle.dbc");
    CHECK_THAT(refused_in(folder, {"certify", "10", "--out", "circle.dbc"}), Contains("circle"));
}

TEST_CASE("below /dev and /proc nothing is written, also through links") {
    const TemporaryFolder folder;
    fs::create_symlink("/dev/stdout", folder / "link.dbc");
    fs::create_directory_symlink("/dev", folder / "devices");
    const fs::path stdout_before = fs::read_symlink("/dev/stdout");
    for (const char* name : {"/dev/stdout", "/dev/fd/1", "/dev/../dev/x.dbc", "/dev/null", "/proc/x.dbc",
                             "/proc/self/fd/1", "link.dbc", "devices/x.dbc"}) {
        CHECK_THAT(refused_in(folder, {"certify", "10", "--out", name}),
                   Contains("- stands for the standard output"));
    }
    // As root, with a file as standard output, it was the system's link that was replaced.
    const Outcome result =
        run({"sh", "-c", "exec " DUMBBELL_BIN " certify 10 --out /dev/stdout > file"}, folder.path());
    CHECK(result.code == 2);
    CHECK(fs::read_symlink("/dev/stdout") == stdout_before);
}

TEST_CASE("a read-only file is not replaced") {
    const TemporaryFolder folder;
    const std::string kept = folder / "kept.dbc";
    write_file(kept, "mine");
    REQUIRE(::chmod(kept.c_str(), 0444) == 0);
    const Outcome result = dumbbell({"certify", "10", "--out", kept});
    CHECK(result.code == 2);
    CHECK_THAT(result.err, Contains("it is read-only; give another name"));
    CHECK(contents(kept) == "mine");
}

TEST_CASE("the output - has the data alone, and what is said goes to stderr", "[wings]") {
    const TemporaryFolder folder;
    for (const Words& words : {Words{"certify", "10"}, Words{"certify", "1:20"}, Words{"critical", "3:5"},
                               trace, Words{"adiabatic", "--delta", "0.01", "--theorem", "lemma3.1"}}) {
        CAPTURE(words);
        const bool is_table = words[0] == "critical";
        const std::string file = folder / (is_table ? "file.tsv" : "file.dbc");
        const Outcome named = dumbbell(with(words, {"--out", file}));
        const Outcome streamed = dumbbell(with(words, {"--out", "-"}), folder.path());
        REQUIRE(named.code == 0);
        CHECK(streamed.code == 0);
        CHECK(streamed.out == contents(file));
        CHECK(!streamed.err.empty());
        CHECK_THAT(refused_in(folder, with(words, {"--out", "-", "--json"})),
                   Contains("give --out a file name"));
    }
    const std::string stairs = certificate(folder, "1:20");
    for (const Words& words :
         {Words{"plot", "staircase", stairs}, Words{"report", stairs, "--no-verifier"}}) {
        const std::string file = folder / (words[0] == "plot" ? "x.svg" : "x.html");
        REQUIRE(dumbbell(with(words, {"--out", file})).code == 0);
        const Outcome streamed = dumbbell(with(words, {"--out", "-"}));
        CHECK(streamed.out == contents(file));
        CHECK(streamed.err.empty());
    }
    CHECK(!fs::exists(folder / "-"));
    CHECK(!fs::exists(folder / "-.partial"));
}

TEST_CASE("the file - is the standard input, for each command that reads one", "[wings]") {
    const TemporaryFolder folder;
    const std::string stairs = certificate(folder, "1:20");
    REQUIRE(dumbbell({"plot", "staircase", stairs, "--out", folder / "named.svg"}).code == 0);
    const Outcome plotted = fed(stairs, "plot staircase - --out fed.svg", folder.path());
    CAPTURE(plotted.err);
    CHECK(plotted.code == 0);
    CHECK(contents(folder / "fed.svg") == contents(folder / "named.svg"));
    const Outcome audit = fed(stairs, "audit -");
    CHECK(audit.code == 0);
    CHECK_THAT(audit.out, StartsWith("-: tiles exactly"));
    CHECK(fed(stairs, "report - --out page.html", folder.path()).code == 0);
    CHECK_THAT(contents(folder / "page.html"), Contains(R"("verify_file":"-")"));
    for (const char* command : {"audit -", "plot orbit - --out x.svg", "report - --out x.html"}) {
        const Outcome nothing = fed("/dev/null", command, folder.path());
        CAPTURE(command, nothing.err);
        CHECK(nothing.code == 2);
        CHECK(count_lines(nothing.err) == 1);
        CHECK_THAT(nothing.err, Contains("'-'") && !Contains("/dev/stdin"));
    }
    const Outcome closed = run({"sh", "-c", "exec " DUMBBELL_BIN " audit - <&-"});
    CHECK(closed.code == 2);
    CHECK(closed.err == "dumbbell: cannot read the standard input: Bad file descriptor\n");
}

TEST_CASE("whatever could not be printed is no success, in every command", "[wings]") {
    const TemporaryFolder folder;
    const std::string stairs = certificate(folder, "1:20");
    for (const char* words :
         {"certify 10", "certify 1:1000", "critical 4", "trace 10 --phi 1/3 --phidot 1 --y 3 --ydot -1/2",
          "adiabatic --delta 0.01 --theorem lemma3.1", "generate man", "certify 10 --out -"}) {
        const Outcome result =
            run({"sh", "-c", "exec " DUMBBELL_BIN " " + std::string(words) + " > /dev/full"});
        CAPTURE(words, result.err);
        CHECK(result.code == 2);
        CHECK_THAT(result.err, Contains("cannot write the output"));
    }
    for (const std::string& words :
         {"audit " + stairs, "audit --json " + stairs, "law " + stairs, "verify " + stairs,
          "plot staircase --out - " + stairs, "report --out - " + stairs, std::string("help"),
          std::string("--help"), std::string("--version")}) {
        const Outcome result = run({"sh", "-c", "exec " DUMBBELL_BIN " " + words + " > /dev/full"});
        CAPTURE(words, result.err);
        CHECK(result.code == 2);
        CHECK(count_lines(result.err) == 1);
    }
}

TEST_CASE("no file that is opened gets the number of a standard stream that is closed") {
    const Outcome result =
        run({"timeout", "60", "sh", "-c",
             DUMBBELL_BIN " certify 1e16 --section full <&- >&- 2>&- & "
                          "cd /proc/$!/fd; "
                          "until [ \"$(readlink 0 1 2 | uniq -c | tr -d ' ')\" = 3/dev/null ]; do :; done; "
                          "kill $!"});
    CHECK(result.code == 0);
}
