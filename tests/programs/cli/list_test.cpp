// --list FILE: what certify, law and trace say of one mass ratio, for the lines of a file.
#include <fcntl.h>
#include <sys/stat.h>

#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;
using Json = nlohmann::json;

namespace {

const std::string heading =
    "line\tgiven\tratio_lo\tratio_lo_decimal\tratio_hi\tratio_hi_decimal\tlower\tupper\terror\n";
const std::string abc_is_wrong = "'abc' is not a number: write it like 10, 4.6, 1e6 or 9/2";

Outcome listed(const std::string& lines, Words options = {}, const std::string& command = "certify") {
    const TemporaryFolder folder;
    write_file(folder / "list", lines);
    options.insert(options.begin(), {command, "--list", "list"});
    return dumbbell(options, folder.path());
}

std::vector<Json> json_lines(const Outcome& result) {
    std::vector<Json> all;
    for (const std::string& line : lines_of(result.out)) {
        all.push_back(Json::parse(line));
    }
    return all;
}

/// What a command prints but for the time that it took and what a list adds.
Json without(Json json, const Words& fields) {
    for (const std::string& field : fields) {
        json.erase(field);
    }
    return json;
}

const std::string not_complete =
    "NOT COMPLETE: lines of the list have no claim here; the same command goes on (dumbbell " DUMBBELL_VERSION
    " certify --list --gap 1e-6)\n";

}  // namespace

TEST_CASE("a list gives a table, a row for each piece, with exact ratios and decimals beside them") {
    const Outcome result = listed("10\n1:4\n0.3\n");
    CHECK(result.code == 0);
    CHECK(result.err.empty());
    CHECK(result.out == heading +
                            "1\t10\t10/1\t10\t10/1\t10\t4\t4\t\n"
                            "2\t1:4\t1/1\t1\t1/1\t1\t2\t2\t\n"
                            "2\t1:4\t1/1\t1\t1000001/1000000\t1.000001\t2\t3\t\n"
                            "2\t1:4\t1000001/1000000\t1.000001\t4/1\t4\t3\t3\t\n"
                            "3\t0.3\t10/3\t3.3333333333333333\t10/3\t3.3333333333333333\t3\t3\t\n");
}

TEST_CASE("comments, empty lines, a heading, further columns, quotes and foreign line ends are understood") {
    const Outcome result = listed("# mine\r\nratio,name\r\n\r\n\"10\",ten\r\n 20 ; x # why\r\n30\tz\n");
    CHECK(result.code == 0);
    CHECK(result.out == heading +
                            "4\t10\t10/1\t10\t10/1\t10\t4\t4\t\n"
                            "5\t20\t20/1\t20\t20/1\t20\t5\t5\t\n"
                            "6\t30\t30/1\t30\t30/1\t30\t6\t6\t\n");
}

TEST_CASE("a column in quotes is one column, and of a number of another spelling no part is taken for one") {
    const std::vector<std::string> wrong{
        "\"4,6\",x", "\"1,000\"", "\"1;5\"", "\"4\t6\"",  "4,6",        "4,6;10", "1,000.5\tx", "1,000,000",
        "1 000",     "1'000",     "=\"10\"", "=\"10,5\"", "+10",        "10%",    "\u221210",   "1\u00a0000",
        "10,x;5",    "\"10",      "10,\"a",  ",10",       "\"1\"\"0\"", "\"10\"5"};
    for (const std::string& line : wrong) {
        CAPTURE(line);
        const Outcome result = listed(line + "\n10,y\n");
        CHECK(result.code == 2);
        CHECK_THAT(result.err, Contains("bad: 1 of 2 lines; the first is line 1: "));
        CHECK_THAT(result.out, Contains("\n2\t10\t10/1\t"));
    }
    const std::string ten = "\t10\t10/1\t10\t10/1\t10\t4\t4\t\n";
    CHECK(listed(" \"10\" ,\"a, b # \"\"c\"\";\"\n10;4,5\n10, 4\n\"10\",4\n").out ==
          heading + "1" + ten + "2" + ten + "3" + ten + "4" + ten);
    // Under a heading with as many columns a comma between digits separates, as it does in every CSV.
    const Outcome headed = listed("q,N\n10,4\n10,4,6\n");
    CHECK(headed.out.find("2" + ten) == heading.size());
    CHECK_THAT(headed.out, Contains("\n3\t10,4,6\t\t\t\t\t\t\tone number or two columns?"));
}

TEST_CASE("bad lines are named by number and do not stop the others, but with --strict the first one does") {
    const std::string lines = "10\nabc\n5:3\n1e101\n20\n", ten = "1\t10\t10/1\t10\t10/1\t10\t4\t4\t\n";
    const Outcome result = listed(lines);
    CHECK(result.code == 2);
    CHECK(result.err == "dumbbell: bad: 3 of 5 lines; the first is line 2: " + abc_is_wrong + "\n");
    CHECK_THAT(result.out,
               StartsWith(heading + ten + "2\tabc\t\t\t\t\t\t\t" + abc_is_wrong + "\n3\t5:3\t\t"));
    CHECK_THAT(result.out, EndsWith("5\t20\t20/1\t20\t20/1\t20\t5\t5\t\n"));
    CHECK(count_lines(result.out) == 6);
    const Outcome strict = listed(lines, {"--strict"});
    CHECK(strict.code == 2);
    CHECK(strict.out == heading + ten);
    CHECK(strict.err == "dumbbell: 'list', line 2: " + abc_is_wrong + "\n");
}

TEST_CASE("no field of a table is taken apart or for a quoted one, whatever a line has") {
    const Outcome result = listed("10\nx\"y\x1b\tz\n");
    CHECK_THAT(result.out, Contains("\n2\tx'y?\t\t\t\t\t\t\t'x'y?' is not a number"));
}

TEST_CASE("with --json a line is what the command prints of that ratio, on one line, with the line's number",
          "[wings]") {
    for (const std::string command : {"certify", "law"}) {
        CAPTURE(command);
        Words alone{command};
        const Outcome result = listed("10\nabc\n1/70\n", {"--json"}, command);
        CHECK(result.code == 2);
        const auto lines = json_lines(result);
        REQUIRE(lines.size() == 3);
        if (command == "law") {
            alone.emplace_back("--ratio");
        }
        alone.insert(alone.end(), {"1/70", "--json"});
        const Json expected = Json::parse(dumbbell(alone).out);
        CHECK(without(lines[2], {"seconds", "jobs", "line", "given"}) ==
              without(expected, {"seconds", "jobs"}));
        CHECK(lines[2].at("line") == 3);
        CHECK(lines[2].at("given") == "1/70");
        CHECK(lines[1] ==
              Json{{"schema", "dumbbell-list-1"}, {"line", 2}, {"given", "abc"}, {"error", abc_is_wrong}});
    }
}

TEST_CASE("law gives the same table", "[wings]") {
    const Outcome law = listed("70\n4.6034\n1:2\n", {}, "law");
    CHECK(law.code == 2);
    CHECK_THAT(law.out, StartsWith(heading + "1\t70\t70/1\t70\t70/1\t70\t9\t9\t\n") &&
                            Contains("\n3\t1:2\t\t\t\t\t\t\tthe law takes one mass ratio, for"));
}

TEST_CASE("lines that are not decided are counted, the first is named, and the exit code is 3", "[wings]") {
    const Outcome result = listed("10\n20\n", {"--budget", "0s"});
    CHECK(result.code == 3);
    CHECK(result.out == heading + "1\t10\t10/1\t10\t10/1\t10\t0\t\t\n2\t20\t20/1\t20\t20/1\t20\t0\t\t\n");
    CHECK(result.err == "dumbbell: not decided: 2 of 2 lines; the first is line 1\n");
    CHECK(listed("10\nabc\n", {"--budget", "0s"}).code == 2);
    CHECK(listed("4.6\n", {}, "law").code == 3);
}

TEST_CASE("the output does not depend on the number of threads, and many lines come in their order") {
    std::string lines;
    for (int i = 0; i < 2000; ++i) {
        lines += i % 7 == 0 ? "1:" + std::to_string(2 + i % 50) + "\n" : std::to_string(1 + i % 90) + ".5\n";
    }
    const Outcome one = listed(lines, {"--jobs", "1"});
    CHECK(one.code == 0);
    CHECK(listed(lines, {"--jobs", "5"}).out == one.out);
}

TEST_CASE("with --out a folder keeps the certificates, and the verifier takes its list of claims") {
    const TemporaryFolder folder;
    write_file(folder / "list", "10\nabc\n10:20\n20:30\n");
    const Outcome result =
        dumbbell({"certify", "--list", "list", "--out", "proofs", "--json"}, folder.path());
    CHECK(result.code == 2);
    CHECK(run({"ls", folder / "proofs"}).out == "000001.dbc\n000003.dbc\n000004.dbc\nclaims.tsv\n");
    CHECK(contents(folder / "proofs/claims.tsv") ==
          not_complete +
              "000001.dbc\t--ratio 10 --exactly 4\n"
              "000003.dbc\t--ratio 10:20 --max 5 --min 4 --gap 9.16e-7 --gaps 1\n"
              "000004.dbc\t--ratio 20:30 --max 6 --min 5 --gap 9.05e-7 --gaps 1\n");
    const auto lines = json_lines(result);
    CHECK(lines[0].at("out") == "proofs/000001.dbc");
    CHECK(last_line(contents(folder / "proofs/000001.dbc")) ==
          "sha256 " + lines[0].at("sha256").get<std::string>());
    const Outcome refused = verifier({"--claims", "proofs/claims.tsv"}, folder.path());
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err,
               Contains("claims.tsv:1: ") && Contains("not `NOT COMPLETE: lines of the list have no claim"));
    CHECK(verifier({"--ratio", "20:30", "--max", "6", "proofs/000004.dbc"}, folder.path()).code == 0);
    REQUIRE(dumbbell({"certify", "10", "--out", "ten.dbc"}, folder.path()).code == 0);
    CHECK(contents(folder / "proofs/000001.dbc") == contents(folder / "ten.dbc"));
}

TEST_CASE("an open certificate claims nothing") {
    const TemporaryFolder folder;
    write_file(folder / "list", "10\n");
    CHECK(dumbbell({"certify", "--list", "list", "--out", "b", "--budget", "0s"}, folder.path()).code == 3);
    CHECK(contents(folder / "b/claims.tsv") == not_complete);
}

TEST_CASE("a list that was killed, or had a bad line, goes on with what is missing, and ends as in one go") {
    const TemporaryFolder folder;
    write_file(folder / "list", "10\n20:30\n40\n50\n");
    const Words command{"certify", "--list", "list", "--out", "proofs"};
    const Outcome once = dumbbell({"certify", "--list", "list", "--out", "once"}, folder.path());
    REQUIRE(once.code == 0);
    REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
    const int writer = ::open((folder / "pipe").c_str(), O_RDWR | O_CLOEXEC);
    REQUIRE(::write(writer, "10\n20:30\n40\n", 12) == 12);
    Process process(with_program({"certify", "--list", "pipe", "--out", "proofs"}), folder.path());
    CHECK(process.until([&] { return std::filesystem::exists(folder / "proofs/000003.dbc"); }));
    CHECK_THAT(dumbbell(command, folder.path()).err, Contains("'proofs' is in use by another run"));
    process.kill();
    CHECK(process.wait().signal == SIGKILL);
    REQUIRE(::close(writer) == 0);
    CHECK(verifier({"--claims", "proofs/claims.tsv"}, folder.path()).code == 2);
    // What is whole is not proved again, even if it says what is not true: that is for the verifier to find.
    const std::string kept = contents(folder / "proofs/000001.dbc"), third = folder / "proofs/000003.dbc";
    write_sealed(folder / "proofs/000001.dbc",
                 replaced(replaced(kept, "upper 4", "upper 5"), "lower 4", "lower 5"));
    write_file(third, contents(third).substr(0, 200));
    CHECK_THAT(dumbbell({"certify", "--list", "list", "--out", "proofs", "--gap", "1e-7"}, folder.path()).err,
               Contains("'proofs' has files"));
    std::filesystem::copy(folder / "proofs", folder / "again");
    CHECK_THAT(dumbbell({"certify", "--list", "list", "--out", "again"}, folder.path()).out,
               StartsWith(heading + "1\t10\t10/1\t10\t10/1\t10\t5\t5\t\n"));
    write_file(folder / "proofs/000001.dbc", kept);
    CHECK(dumbbell(command, folder.path()).out == once.out);
    CHECK(run({"diff", "-r", folder / "once", folder / "proofs"}).code == 0);
}

TEST_CASE("trace --subdivide keeps its certificates in the same way", "[wings]") {
    const TemporaryFolder folder;
    write_file(folder / "list", "10\n20\n");
    const Outcome result = dumbbell({"trace", "--list", "list", "--phi", "0:0.5", "--phidot", "0", "--y", "3",
                                     "--ydot", "-1", "--subdivide", "--max-boxes", "20", "--out", "boxes"},
                                    folder.path());
    CHECK(count_lines(result.out) == 3);
    CHECK(run({"ls", folder / "boxes"}).out == "000001.dbc\n000002.dbc\n");
    CHECK(verifier({"boxes/000001.dbc", "boxes/000002.dbc"}, folder.path()).code == 0);
}

TEST_CASE("a list that is not there, has no ratio, or whose options contradict one another is refused",
          "[wings]") {
    CHECK_THAT(refused({"certify", "--list", "none"}), Contains("cannot read 'none': no such file"));
    CHECK_THAT(refused({"certify", "--list", "."}), Contains("it is a directory"));
    CHECK_THAT(refused({"certify", "--list", "-"}), Contains("'-' has no mass ratio: write one"));
    CHECK_THAT(refused({"certify", "10", "--list", "x"}), Contains("--list and RATIO exclude each other"));
    CHECK_THAT(refused({"certify", "--list", "-", "--gap", "2"}), Contains("--gap 2 is out of range"));
    CHECK_THAT(refused({"certify", "--list", "-", "--out", "-"}), Contains("give a new folder"));
    CHECK_THAT(refused({"certify", "10", "--strict"}), Contains("--strict requires --list"));
    CHECK_THAT(refused({"certify"}), Contains("certify needs RATIO, --list FILE, or a body"));
    CHECK_THAT(refused({"law", "--jobs", "2"}), Contains("--jobs requires --prove or --list"));
    CHECK_THAT(refused({"trace", "--list", "-", "--phi", "1"}), Contains("--phidot is required"));
    const TemporaryFolder folder;
    write_file(folder / "list", "10\n");
    const Outcome result = dumbbell({"certify", "--list", "list", "--out", "."}, folder.path());
    CHECK(result.code == 2);
    CHECK_THAT(result.err, Contains("'.' has files: with --list give a new or an empty folder"));
    CHECK(folder.names() == Words{"list"});
}

TEST_CASE("answers come while the list does, and a signal ends the wait for its next line") {
    const TemporaryFolder folder;
    REQUIRE(::mkfifo((folder / "list").c_str(), 0600) == 0);
    for (const int signal : {SIGINT, SIGTERM}) {
        const int writer = ::open((folder / "list").c_str(), O_RDWR | O_CLOEXEC);
        REQUIRE(::write(writer, "10\n20", 5) == 5);
        Process process(with_program({"certify", "--list", "list", "--out", "proofs", "--jobs", "2"}),
                        folder.path());
        CHECK(process.until([&] { return std::filesystem::exists(folder / "proofs/000001.dbc"); }));
        process.send(signal);
        const Outcome result = process.wait();
        CHECK(result.signal == signal);
        CHECK_THAT(result.out, StartsWith(heading + "1\t10\t"));
        CHECK_THAT(result.err, Contains("what is printed is about the lines up to 1"));
        CHECK(contents(folder / "proofs/claims.tsv") ==
              not_complete + "000001.dbc\t--ratio 10 --exactly 4\n");
        REQUIRE(::close(writer) == 0);
        std::filesystem::remove_all(folder / "proofs");
    }
}
