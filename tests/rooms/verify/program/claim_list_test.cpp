// The option --claims: many certificates, each with its own claim.
#include "catch.hpp"
#include "run_program.hpp"

using make::closed;
using make::File;
using make::has;
using make::Run;
using make::run;
using make::ten;

namespace {

Run run_list(const std::string& rows, const std::string& options = "") {
    const File list(rows);
    return run(options + " --claims " + list.path());
}

}  // namespace

TEST_CASE("a list of claims: each row is proved by its file, or it is rejected") {
    const File file(ten());
    const std::string four = file.path() + "\t--ratio 10 --max 4",
                      three = file.path() + "\t--ratio=10 --max=3";
    const Run good = run_list("# certificate\tclaim\n\n" + four + "\n" + four + "\tmade by hand\tyes\n");
    CHECK(good.code == 0);
    CHECK(has(good.out, "\nc files=2 verified=2 rejected=0 "));
    const Run bad = run_list(four + "\n" + three + "\n" + file.path() + "x\t--ratio 10 --exactly 4");
    CHECK(bad.code == 1);
    CHECK(has(bad.out, " code=claim-not-proved not proved: at most 3 collisions"));
    CHECK(has(bad.out,
              "\nc files=3 verified=1 rejected=1 limit=0 unsupported=0 unreadable=1 nothing-proved=0 open=1 "
              "exit=1\n"));
    const Run least = run_list(file.path() + "\t--ratio 10 --min 1\n");  // such a claim is one, proved or not
    CHECK(has(least.out, " code=claim-not-proved not proved: at least 1 collisions"));
    CHECK(run_list(four + "\n").out.starts_with(file.path() + "\n  Proved: "));  // one file alone: in full
    CHECK(run_list(file.path() + "\t--coin --max 4\n").code == 1);
    CHECK(run_list(file.path() + "\t--claim initial-conditions --ratio 10 --max 4\n").code == 1);
    const Run json = run_list(four + "\n" + three + "\n", "--json --jobs 2 --precision 60");
    CHECK(has(json.out,
              "\"demand\":{\"ratio\":{\"lo\":\"10/1\",\"hi\":\"10/"
              "1\"},\"inertia\":null,\"rho\":null,\"max\":4,\"min\":null,"));
    CHECK(has(json.out,
              "\"demand\":{\"ratio\":{\"lo\":\"10/1\",\"hi\":\"10/"
              "1\"},\"inertia\":null,\"rho\":null,\"max\":3,\"min\":null,"));
}

TEST_CASE("a list of claims: names are those of the list's folder, and of the working folder without one") {
    const File file(ten());
    const std::filesystem::path path = file.path(), folder = path.parent_path();
    const File list(path.filename().string() + "\t--ratio 10 --max 4\n"), input("-\t--ratio 10 --max 4\n");
    CHECK(run("--claims " + list.path(), "cd / && ").code == 0);
    CHECK(run("--claims -", "cd / && cat " + list.path() + " | ").code == 2);
    CHECK(run("--claims " + input.path() + " <" + file.path(), "cd / && ").code == 0);
    const File lost("no.dbc\t--ratio 10 --max 4\n");
    CHECK(has(run("--claims " + lost.path()).out, (folder / "no.dbc").string() + "\ns UNREADABLE "));
}

TEST_CASE("a list of claims: a row that states none, or a list without rows, is wrong usage") {
    const std::string sound = "file\t--ratio 10 --max 4\n";
    for (const auto& [rows, message] : std::vector<std::pair<std::string, std::string>>{
             {"", ": no claim in this list"},
             {"# file\t--ratio 10 --max 4\n\n", ": no claim in this list"},
             {"file\n", ":1: needs a certificate, a tab and its claim"},
             {"file --ratio 10 --max 4\n", ":1: needs a certificate, a tab and its claim"},
             {sound + "\t--ratio 10 --max 4\n", ":2: needs a certificate, a tab and its claim"},
             {sound + "\nfile\t\n", ":3: needs a certificate, a tab and its claim"},
             {"file\t\tdumbbell certify 10\n", ":1: the claim needs --ratio or a body, and"},
             {"file\t--ratio 10\n", ":1: the claim needs --ratio or a body, and"},
             {"file\t--max 4\n", ":1: the claim needs --ratio or a body, and"},
             {"file\t--claim initial-conditions --ratio 10 --phi 1\n",
              ":1: the claim needs --ratio or a body, and"},
             {"file\t--claim incoming --decided 1\n", ":1: the claim needs --ratio or a body, and"},
             {"file\t--ratio 10 --max 4\t--min 4\n", ":1: a demand behind the second tab"},
             {"file\t--ratio 10 --max 4\t\"\xc2\xa0--min 4\n", ":1: a demand behind the second tab"},
             {"file\t--ratio 10 --min 0\n", ":1: the claim needs --ratio or a body, and"},
             {"file\t--ratio 10 --max\n", ":1: no value after --max"},
             {"file\t--ratio 10 --max 4 --max 5\n", ":1: --max is given twice"},
             {"file\t--ratio 10 --max 4 --json\n", ":1: `--json` states no claim"},
             {"file\t--ratio 10 --max 4 other\n", ":1: `other` states no claim"},
             {"file\t--ratio 10 --max 4  --min 2\n", ":1: `` states no claim"},
             {sound + "file\t--ratio 10 --max 4\r\n", ":2: the text has line ends of Windows (CR LF): "},
             {std::string("file\0\t--ratio 10 --max 4\n", 24), ":1: a name with a zero byte"},
         }) {
        INFO(rows);
        const Run r = run_list(rows);
        CHECK(r.code == 2);
        CHECK(r.out.empty());
        CHECK(has(r.err, message));
        CHECK(std::count(r.err.begin(), r.err.end(), '\n') == 1);
    }
    const File listed(sound);
    const Run twice = run("--claims " + listed.path() + " " + listed.path());
    CHECK(twice.code == 2);
    CHECK(has(twice.err, "--claims names the files: give no other FILE"));
    CHECK(has(run("--max 4 --claims " + listed.path()).err, "--claims and --max exclude each other"));
    CHECK(has(run_list("/nonexistent\t--claim law\n").out, "s UNREADABLE No such file"));  // a claim
    CHECK(
        has(run_list("/nonexistent\t--claim incoming --ratio 2 --decided 1\n").out, "s UNREADABLE No such"));
    CHECK(has(run("--ydot 4 --claims " + listed.path()).err, "--claims and --ydot exclude each other"));
    CHECK(run("--claims /").err == "dumbbell-verify: /: Is a directory\n");
    const File remarks("# none\n# at all\n");  // it is not the last row that is wrong
    CHECK(has(run("--claims " + remarks.path()).err, remarks.path() + ": no claim in this list"));
    CHECK(has(run_list(std::string((1 << 24) + 1, '#')).err, "at most 16 MiB"));
    CHECK(has(run_list(std::string(1 << 24, '#')).err, "no claim in this list"));
}
