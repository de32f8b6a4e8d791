// The options --shards and --combine as a script sees them: last line, exit code, messages.
#include <unistd.h>

#include <catch2/catch.hpp>

#include "make_initial.hpp"
#include "make_parts.hpp"
#include "programs/cli/process.hpp"
#include "run_program.hpp"

using make::File;
using make::has;
using make::Run;
using make::run;
using make::stairs_to_100;

namespace {

const std::string tall = make::shipped("stairs-1-1e4.dbc.gz");

}  // namespace

TEST_CASE("parts of a file: each is one run, the lines of all are the verdict") {
    const File parts(""), again("");
    CHECK(run("--shards 1-9 " + tall + " >>" + parts.path() +
              " && " DUMBBELL_VERIFY_BIN " --quiet --jobs 1 --shards=10-177 " + tall + " >>" + parts.path() +
              "; cat " + parts.path())
              .code == 0);
    const Run all = run("--combine " + parts.path() + " " + tall), whole = run(tall);
    CHECK(all.code == 0);
    // Not the word of a check: a script that looks for it must not be content with lines that anyone can
    // type.
    const auto combined = [](const std::string& text) {
        return make::replaced(text, "s VERIFIED ", "s COMBINED ");
    };
    CHECK(all.last() == combined(whole.last()) + " parts=2");
    CHECK(all.out == combined(whole.out.substr(0, whole.out.size() - 1)) + " parts=2\n");
    CHECK_FALSE(has(all.out, "VERIFIED"));
    const std::string report = parts.path() + ".xml";
    CHECK(run("--junit " + report + " --combine " + parts.path() + " --ratio 10 --max 4 " + tall).code == 0);
    CHECK(has(dumbbell_test::contents(report),
              " ratio=10/1:10/1 max=4 COMBINED, the lines of its parts trusted\" "));
    std::filesystem::remove(report);
    CHECK(run("--quiet --combine " + parts.path() + " --ratio 1:1e4 --max 90 " + tall).out ==
          all.last() + "\n");
    CHECK(run("--quiet --combine " + parts.path() + " --ratio 10 --exactly 4 --claim collisions " + tall)
              .code == 0);
    CHECK(run("--combine " + parts.path() + " --max 89 " + tall).code == 1);
    CHECK(run("--combine " + parts.path() + " --scene wedge " + tall).code == 1);
    const Run json = run("--json --combine " + parts.path() + " " + tall);
    CHECK(has(json.out, "\"verdict\":\"COMBINED\",\"claim\":{\"scene\":\"dumbbell\","));
    CHECK(has(json.out, "\"part\":null,\"parts\":2,\"leaves\":{\"split\":521,"));
    const Run other = run("--combine " + parts.path() + " " + stairs_to_100);
    CHECK(other.code == 1);
    CHECK(has(other.last(), "s REJECTED code=parts " + parts.path() + ":2: about another file"));
}

TEST_CASE("parts of a file: nothing that is printed of a part looks like a verdict of the whole") {
    const std::string report = std::filesystem::temp_directory_path() /
                               ("dumbbell_verify_parts" + std::to_string(::getpid()) + ".xml");
    for (const char* options :
         {"", "--quiet ", "--json ", "--precision 60 ", "--scene dumbbell --claim collisions "}) {
        const Run part = run(std::string(options) + "--shards 1-17 --junit " + report + " " + stairs_to_100);
        INFO(part.out << part.err);
        CHECK(part.code == 0);
        CHECK_FALSE(has(part.out, "VERIFIED"));
        CHECK_FALSE(has(part.out, "100.0"));
        const std::string xml = make::contents(report);
        CHECK_FALSE(has(xml, "VERIFIED"));
        CHECK(has(xml, "<testcase name=\"" + stairs_to_100 + " pieces=1-17\""));
        CHECK(has(xml, "tests=\"1\" failures=\"0\" errors=\"0\""));
    }
    std::filesystem::remove(report);
    CHECK(run("--quiet --shards 3 " + stairs_to_100).out.starts_with("s PART pieces=3-3 of=17 "));
    CHECK(run("--shards 3 " + stairs_to_100).out.starts_with(stairs_to_100 + "\ns PART pieces=3-3 of=17 "));
}

TEST_CASE("parts of a file: threads change nothing") {
    CHECK(run("--jobs 1 --shards 20-120 " + tall).out == run("--jobs 7 --shards 20-120 " + tall).out);
}

TEST_CASE("parts of a file: what fails has the usual line and exit code") {
    const std::string false_claims = DUMBBELL_PROJECT "/tests/attacks/false_claims/";
    const Run bad = run("--shards 2 " + false_claims + "across-gap.dbc");
    CHECK(bad.code == 1);
    CHECK(bad.last().starts_with("s REJECTED line=22 code=count "));
    const Run beyond = run("--shards 5-18 " + stairs_to_100);
    CHECK(beyond.code == 2);
    CHECK(beyond.last() == "s UNREADABLE line=8 there is no piece 18: the file has 17 pieces");
    const File starts(make::falling());
    for (const std::string& options : {std::string("--shards 1 "), "--combine " + starts.path() + " "})
        for (const std::string& file : {starts.path(), false_claims + "starts-less.dbc"}) {
            const Run r = run(options + file);
            INFO(r.out);
            CHECK(r.code == 2);
            CHECK(r.last() ==
                  "s UNREADABLE line=6 a file with this claim has no pieces: it is verified as a whole only");
        }
    const File heavy(make::mutated(make::four_pieces(), "bits 53\nupper none", "bits 3000\nupper none"));
    CHECK(run("--shards 2 " + heavy.path()).code == 4);
    CHECK(run("--shards 2 --max-bits 3000 " + heavy.path()).code == 0);
    CHECK(run("--shards 1 /nonexistent").code == 2);
    CHECK(run("--shards 1 " + make::shipped("wedge-1-100.dbc")).code == 1);
    CHECK(run("--shards 1 --scene wedge " + make::shipped("wedge-1-100.dbc")).code == 0);
}

TEST_CASE("parts of a file: lines that do not fit have an exit code each") {
    const std::string line = run("--quiet --shards 1-17 " + stairs_to_100).out;
    const auto code = [&](const std::string& lines, const std::string& options = "") {
        const File parts(lines);
        const Run r = run(options + " --combine " + parts.path() + " " + stairs_to_100);
        INFO(r.out << r.err);
        CHECK((r.code == 0) == r.last().starts_with("s COMBINED "));
        return r.code;
    };
    CHECK(code(line) == 0);
    CHECK(code("") == 1);
    CHECK(code(line, "--precision 53") == 1);
    CHECK(code(make::replaced(line, "lower=2", "lower=3")) == 1);
    CHECK(code(make::replaced(line, "verifier=", "verifier=9")) == 3);
    CHECK(code(line.substr(0, line.size() - 2)) == 2);
    CHECK(code(make::replaced(line, "\n", "\r\n")) == 2);
    CHECK(code(line + "s REJECTED line=1 code=truncated the text ends too early\n") == 2);
    CHECK(run("--combine /nonexistent " + stairs_to_100).last() ==
          "s UNREADABLE /nonexistent: No such file or directory");
    CHECK(run("--combine /nonexistent " + stairs_to_100).code == 2);
    CHECK(run("--combine " + stairs_to_100 + " " + stairs_to_100).code == 1);  // no line of a part is in it
    const File parts(line);
    const std::string gibibyte = "(cat " + parts.path() + "; yes) | timeout 1000 ";
    const Run endless = run("--combine /dev/stdin " + stairs_to_100, gibibyte);
    CHECK(endless.code == 4);
    CHECK(endless.last() == "s LIMIT /dev/stdin has more than 1 GiB");
}

TEST_CASE("parts of a file: wrong usage is one line on stderr") {
    for (const char* options : {
             "--shards F",
             "--shards 0 F",
             "--shards 3-2 F",
             "--shards 1- F",
             "--shards 1-2,4 F",
             "--shards '' F",
             "--shards 1000000000000000000 F",
             "--shards 1 --shards 2 F",
             "--shards 1 F F",
             "--shards 1",
             "--shards 1 --ratio 10 F",
             "--shards 1 --max 4 F",
             "--shards 1 --min 4 F",
             "--shards 1 --exactly 4 F",
             "--shards 1 --explain 1:bridge F",
             "--shards 1 --claims F",
             "--shards 1 --lemma 4.1 F F",
             "--shards 1 --combine F F",
             "--combine F",
             "--combine F F F",
             "--combine F --combine F F",
             "--combine F --explain 1:bridge F",
             "--combine F --claims F",
             "--combine F --lemma 4.1 F F",
             "--combine F --max-bits 3000 F",
         }) {
        std::string arguments = options;
        for (std::size_t at = 0; (at = arguments.find(" F", at)) != std::string::npos; ++at)
            arguments.replace(at, 2, " " + stairs_to_100);
        const Run r = run(arguments);
        INFO(options << " -> " << r.out << r.err);
        CHECK(r.code == 2);
        CHECK(r.out.empty());
        CHECK(std::count(r.err.begin(), r.err.end(), '\n') == 1);
    }
}
