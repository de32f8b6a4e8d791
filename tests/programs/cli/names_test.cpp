// Names may hold anything. None reaches a terminal raw, of no command and of neither program; and a command
// that is printed can be pasted.
#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;

namespace {

// ESC, a line feed, CSI of both spellings, a byte that is no UTF-8, quotes and a blank.
const std::string hostile = "a\nb: tiles exactly\x1b[31m\xc2\x9b\x9b\xff 'c' $(d)";

// Its second line would be taken for a line of the program's.
void check_clean(const Words& words, const Outcome& result) {
    CAPTURE(words, result.code, result.out, result.err);
    for (const std::string& text : {"\n" + result.out, "\n" + result.err}) {
        CHECK(text.find('\x1b') == std::string::npos);
        CHECK(text.find('\x9b') == std::string::npos);
        CHECK(text.find('\xff') == std::string::npos);
        CHECK(text.find("\nb: tiles") == std::string::npos);
    }
}

// The command that the text offers after these words, as a shell runs it.
Outcome pasted(const std::string& text, const std::string& before, const std::string& folder) {
    const std::size_t at = text.find(before);
    REQUIRE(at != std::string::npos);
    const std::size_t from = at + before.size();
    const std::string line = text.substr(from, text.find('\n', from) - from);
    const std::string program = std::filesystem::path(DUMBBELL_BIN).parent_path().string();
    return run({"bash", "-c", "PATH=" + program + ":$PATH; " + line}, folder);
}

}  // namespace

TEST_CASE("no command of either program prints a name raw, whatever comes out", "[wings]") {
    const TemporaryFolder folder;
    const std::string& f = folder.path();
    const std::string stairs = hostile + ".dbc", box = hostile + "box.dbc";
    const Words trace{"trace", "10",  "--phi",  "0.3:0.31", "--phidot",   "0",
                      "--y",   "3/2", "--ydot", "-1",       "--subdivide"};
    std::vector<Words> commands{
        {"certify", "1:20", "--out", stairs},
        {"certify", "10", "--json", "--out", hostile + "10.dbc"},
        {"certify", "10", "--out", hostile + "/x.dbc"},
        {"certify", hostile},
        {"certify", "10", "--gap", hostile},
        {"critical", "3:4", "--out", hostile + ".tsv"},
        {"critical", "3:4", "--json", "--out", hostile + ".tsv"},
        {"certify", "3:4", "--part", hostile},
        {"join", stairs, stairs, "--range", "1:3", "--out", hostile + "j.dbc"},
        {"adiabatic", "--delta", "0.01", "--theorem", "lemma3.1", "--out", hostile + "a.dbc"},
        {"adiabatic", "--delta", "0.01", "--theorem", "lemma3.1", "--json", "--out", hostile + "a.dbc"},
        {"law", hostile},
        {"audit", stairs},
        {"audit", stairs, "--json"},
        {"audit", hostile + "a.dbc"},
        {"plot", "staircase", stairs, "--out", hostile + ".svg"},
        {"plot", "phase", stairs, "--out", hostile + ".svg"},
        {"plot", "orbit", hostile, "--out", "x.svg"},
        {"plot", hostile},
        {"report", stairs, "--out", hostile + ".html"},
        {"report", hostile, "--out", hostile + ".html"},
        {"report", stairs, "--out", hostile + ".svg"},
        {"verify", stairs},
        {"verify", stairs, hostile},
        {"verify", "--json", stairs, box},
        {"verify", "--quiet", stairs},
        {"verify", "--claims", hostile},
        {"verify", "--explain", hostile, stairs},
        {hostile},
        {"--" + hostile},
        {"help", hostile}};
    for (const Words& more : {Words{}, Words{"--json"}}) {
        commands.push_back(trace);
        commands.back().insert(commands.back().end(), {"--out", box});
        commands.back().insert(commands.back().end(), more.begin(), more.end());
    }
    for (const Words& words : commands) {
        check_clean(words, dumbbell(words, f));
    }
    // A picture is the same whatever its certificate is called.
    std::filesystem::copy_file(folder / stairs, folder / "plain.dbc");
    REQUIRE(dumbbell({"plot", "staircase", "plain.dbc", "--out", "plain.svg"}, f).code == 0);
    CHECK(contents(folder / hostile + ".svg") == contents(folder / "plain.svg"));
    const std::string xml = contents(folder / hostile + ".svg") + contents(folder / hostile + ".xml");
    CHECK(xml.find('\x1b') == std::string::npos);
    CHECK(xml.find('\xff') == std::string::npos);
    CHECK_THAT(contents(folder / hostile + ".html"), !Contains("\x1b"));
}

TEST_CASE("a command that is printed can be pasted, whatever the file is called", "[wings]") {
    const TemporaryFolder folder;
    for (const std::string& name : {std::string("a b/it's $HOME"), std::string("-x"), hostile}) {
        CAPTURE(name);
        std::filesystem::create_directories(std::filesystem::path(folder / name).parent_path());
        const std::string file = name + ".dbc";
        const Outcome certified = dumbbell({"certify", "10", "--out", "./" + file}, folder.path());
        REQUIRE(certified.code == 0);
        CHECK(pasted(certified.out, "Check it:    ", folder.path()).code == 0);
        const Outcome traced = dumbbell({"trace", "10", "--phi", "0.3:0.31", "--phidot", "0", "--y", "3/2",
                                         "--ydot", "-1", "--subdivide", "--out=" + file},
                                        folder.path());
        REQUIRE(traced.code == 0);
        const Outcome checked = pasted(traced.out, "Check it:    ", folder.path());
        CHECK(checked.code == 0);
        CHECK_THAT(checked.out, Contains(" demanded-ydot=-1/1:-1/1") && !Contains("not-demanded="));
        const Outcome precise =
            dumbbell({"trace", "10", "--phi", "1:1.001", "--phidot", "1:1.001", "--y", "2", "--ydot=-1",
                      "--subdivide", "--max-boxes", "8", "--digits", "1000", "--out=" + file},
                     folder.path());
        CHECK(pasted(precise.out, "Check it:    ", folder.path()).code == 0);
        CHECK(dumbbell({"plot", "phase", "./" + file, "--out", "phase.svg"}, folder.path()).code == 0);
        const Outcome bounded = dumbbell(
            {"adiabatic", "--delta", "0.01", "--theorem", "lemma3.1", "--out=" + file}, folder.path());
        REQUIRE(bounded.code == 0);
        CHECK(pasted(bounded.out, "Check it:    ", folder.path()).code == 0);
    }
}

TEST_CASE("a file is read as it is named, whatever a parser or a format could make of the name", "[wings]") {
    const TemporaryFolder folder;
    const std::string sound = contents(DUMBBELL_PROJECT "/certificates/q-10.dbc");
    std::string damaged = sound;
    damaged.replace(damaged.find("count 1 2"), 9, "count 0 2");
    for (const char* other : {"good.dbc", "a", "b", "good", "dbc"}) {
        write_file(folder / other, sound);
    }
    for (const std::string name :
         {"[good.dbc]", "[a,b]", "[[a]]", "[", "a,b", "{0}", "%s%n", "\x01[a]", "@a", "*.dbc", "\\a"}) {
        CAPTURE(name);
        write_file(folder / name, damaged);
        for (const Words& words : {Words{"audit", name}, Words{"audit", "good.dbc", name}, Words{"law", name},
                                   Words{"report", name, "--out", "r.html"}}) {
            CHECK(dumbbell(words, folder.path()).code != 0);
        }
        CHECK(verifier({name}, folder.path()).code == 1);
        write_file(folder / name, sound);
        CHECK(dumbbell({"audit", name}, folder.path()).code == 0);
        CHECK(dumbbell({"audit", "good.dbc", name}, folder.path()).code == 0);
        CHECK(dumbbell({"report", name, "--out", "r.html"}, folder.path()).code == 0);
        CHECK(dumbbell({"verify", name}, folder.path()).code == 0);
        CHECK(verifier({name}, folder.path()).code == 0);
        CHECK(dumbbell({"certify", "10", "--out", name + ".dbc"}, folder.path()).code == 0);
        CHECK(contents(folder / (name + ".dbc")) == sound);
    }
}
