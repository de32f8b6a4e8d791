// The option --junit: the report as a test reporter sees it.
#include "catch.hpp"
#include "programs/cli/process.hpp"
#include "run_program.hpp"

using dumbbell_test::TemporaryFolder;
using dumbbell_test::write_file;
using make::closed;
using make::has;
using make::mutated;
using make::Run;
using make::ten;
namespace fs = std::filesystem;

namespace {

/// A folder with certificates, in which the verifier runs.
struct Folder : TemporaryFolder {
    Folder() {
        write_file(*this / "ten.dbc", ten());
        write_file(*this / "bad.dbc", mutated(ten(), "upper 4", "upper 3"));
        write_file(*this / "foreign.dbc", mutated(ten(), "lemmas 1", "lemmas 9"));
    }
    [[nodiscard]] Run run(const std::string& arguments, const std::string& before = "") const {
        return make::run(arguments, "cd " + path() + " && " + before);
    }
    [[nodiscard]] std::string report() const { return dumbbell_test::contents(*this / "report.xml"); }
    /// Against tests/data/junit.xsd; where xmllint is not installed the text alone is compared.
    [[nodiscard]] bool valid() const {
        if (std::system("command -v xmllint >/dev/null") != 0) return true;
        return std::system(("xmllint --noout --schema " DUMBBELL_PROJECT "/tests/data/junit.xsd " + path() +
                            "/report.xml 2>/dev/null")
                               .c_str()) == 0;
    }
};

}  // namespace

TEST_CASE("the JUnit report has a test case for each file, with the reason if it is not verified") {
    const Folder folder;
    const Run r = folder.run("--junit report.xml --ratio 10 --max 4 ten.dbc bad.dbc foreign.dbc none.dbc");
    CHECK(r.code == 1);
    CHECK(r.out == folder.run("--ratio 10 --max 4 ten.dbc bad.dbc foreign.dbc none.dbc").out);
    const std::string report = folder.report();
    CHECK(folder.valid());
    CHECK(has(report, " tests=\"4\" failures=\"1\" errors=\"2\" "));
    CHECK(has(
        report,
        "<testcase name=\"ten.dbc demanded-ratio=10/1:10/1 max=4\" classname=\"dumbbell-verify\" time=\"0."));
    CHECK(has(report,
              "<failure type=\"REJECTED\" message=\"line=13 code=count not certified: 1 + a + b &lt;= U\">"));
    CHECK(has(report, "<error type=\"UNSUPPORTED\" message=\"line=3 unknown lemmas 9\">"));
    CHECK(has(report, "<error type=\"UNREADABLE\" message=\"No such file or directory\">"));
    CHECK(has(report, "\ns REJECTED line=13 code=count not certified: 1 + a + b &lt;= U file=bad.dbc\n"));
    CHECK(has(report, "<testcase name=\"none.dbc demanded-ratio=10/1:10/1 max=4\""));
}

TEST_CASE("the JUnit report of one file, of files that are verified, with --json and of a list") {
    const Folder folder;
    CHECK(folder.run("--junit=report.xml ten.dbc").code == 0);
    CHECK(folder.valid());
    CHECK(has(folder.report(), " tests=\"1\" failures=\"0\" errors=\"0\" "));
    CHECK(folder.run("--json --junit report.xml ten.dbc ten.dbc").out ==
          folder.run("--json ten.dbc ten.dbc").out);
    CHECK(folder.valid());
    CHECK(has(folder.report(), " tests=\"2\" failures=\"0\" errors=\"0\" "));
    write_file(folder / "claims.tsv", "ten.dbc\t--ratio 10 --max 4\nten.dbc\t--ratio 10 --exactly 4\n");
    CHECK(folder.run("--junit report.xml --claims claims.tsv").code == 1);
    CHECK(folder.valid());
    CHECK(has(folder.report(), "<testcase name=\"ten.dbc demanded-ratio=10/1:10/1 exactly=4\""));
    CHECK(has(folder.report(), " tests=\"2\" failures=\"1\" errors=\"0\" "));
}

TEST_CASE("any file name makes a valid JUnit report") {
    const Folder folder;
    for (const std::string name :
         {"<&>\"]]>", "a\tb\nc\rd", "\x01\x1b[2J\x7f", "\xff\xc0\xaf", "\xed\xa0\x80\xef\xbf\xbf\xef\xbf\xbe",
          "\xf4\x90\x80\x80\xe2\x82", "&#1;&amp;<![CDATA[", "  ", "\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80"}) {
        INFO(name);
        CHECK(folder.run("--junit report.xml -- '" + name + "' '" + name + "x'").code == 2);
        CHECK(folder.valid());
        CHECK(has(folder.report(), " tests=\"2\" failures=\"0\" errors=\"2\" "));
    }
    CHECK(has(folder.report(), "name=\"\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80\""));
}

TEST_CASE("the JUnit report appears complete or not at all, and replaces nothing but a report") {
    const Folder folder;
    const auto before = folder.names();
    CHECK(folder.run("--junit ten.dbc bad.dbc").code == 2);  // --junit *.dbc destroys no certificate
    CHECK(dumbbell_test::contents(folder / "ten.dbc") == ten());
    fs::create_directory(folder / "report.xml");
    CHECK(folder.run("--junit report.xml ten.dbc").code == 2);
    fs::remove(folder / "report.xml");
    REQUIRE(std::system(("mkfifo " + folder.path() + "/report.xml").c_str()) == 0);
    CHECK(has(folder.run("--junit report.xml ten.dbc").err,
              "cannot write report.xml: it is not a regular file"));
    fs::remove(folder / "report.xml");
    CHECK(folder.run("--junit none/report.xml ten.dbc").code == 2);
    CHECK(folder.run("--junit none/report.xml ten.dbc").out.empty());  // before anything is verified
    fs::create_hard_link(folder / "ten.dbc", folder / "hard.xml");
    fs::create_symlink("ten.dbc", folder / "soft.xml");
    for (const std::string name : {"hard.xml", "soft.xml", "./soft.xml"})
        CHECK(has(folder.run("--junit " + name + " ten.dbc").err, "which is read"));
    // Whatever is read, by whatever option: a list, one of several files, the standard input.
    const std::string list = "ten.dbc\t--ratio 10 --max 4\n";
    write_file(folder / "read.xml", list);
    for (const std::string words : {"--claims read.xml", "--together ten.dbc read.xml", "- <read.xml"})
        CHECK(has(folder.run("--junit read.xml " + words).err, "which is read"));
    CHECK(has(folder.run("--junit read.xml - <read.xml").err, "it is the standard input, which is read"));
    CHECK(has(folder.run("--junit read.xml --claims read.xml").err, "it is read.xml, which is read"));
    CHECK(dumbbell_test::contents(folder / "read.xml") == list);
    CHECK(dumbbell_test::contents(folder / "ten.dbc") == ten());
    fs::remove(folder / "read.xml");
    fs::remove(folder / "hard.xml");
    fs::remove(folder / "soft.xml");
    fs::create_symlink("/dev/stdout", folder / "stdout.xml");
    CHECK(has(folder.run("--junit stdout.xml ten.dbc").err, "is not a file"));
    for (const std::string name : {"/proc/report.xml", "/dev/dumbbell_verify_report.xml"})
        CHECK(has(folder.run("--junit " + name + " ten.dbc").err, "is not a file"));
    fs::create_symlink("circle.xml", folder / "circle.xml");
    CHECK(has(folder.run("--junit circle.xml ten.dbc").err, "its links lead in a circle"));
    fs::remove(folder / "circle.xml");
    CHECK(std::system(("cd " + folder.path() +
                       " && " DUMBBELL_VERIFY_BIN " --junit report.xml ten.dbc >/dev/full 2>/dev/null")
                          .c_str()) != 0);
    fs::remove(folder / "stdout.xml");
    CHECK(folder.run("--junit report.xml --max x ten.dbc").code == 2);
    CHECK(folder.names() == before);

    // What it is made in, and what with: a new report has the usual rights.
    CHECK(folder.run("--junit report.xml ten.dbc", "umask 022; exec <&-; touch report.xml.tmp-$$; exec ")
              .code == 0);
    CHECK(fs::status(folder / "report.xml").permissions() == fs::perms(0644));
    fs::remove(folder / "report.xml");
    CHECK(folder.names() == before);
    if (fs::exists("/dev/shm")) {
        const std::string shared = "/dev/shm/dumbbell_verify_" + std::to_string(::getpid()) + ".xml";
        CHECK(folder.run("--junit " + shared + " ten.dbc").code == 0);
        CHECK(fs::remove(shared));
    }

    // No room: the verdict that is worse decides the exit code, and an old report stays as it was.
    const std::string no_room = "ulimit -f 1; ";
    write_file(folder / "report.xml", "old");
    fs::permissions(folder / "report.xml", fs::perms(0640));
    write_file(folder / "empty.dbc", "");
    const Run failed = folder.run("--junit report.xml empty.dbc", no_room);
    CHECK(failed.code == 1);
    CHECK(has(failed.out, "s REJECTED"));
    CHECK(has(failed.err, "dumbbell-verify: cannot write report.xml: File too large\n"));
    CHECK(folder.report() == "old");
    CHECK(folder.names() ==
          std::vector<std::string>{"bad.dbc", "empty.dbc", "foreign.dbc", "report.xml", "ten.dbc"});
    CHECK(folder.run("--junit report.xml empty.dbc").code == 1);
    CHECK(fs::status(folder / "report.xml").permissions() == fs::perms(0640));  // as before
    CHECK(folder.valid());
}
