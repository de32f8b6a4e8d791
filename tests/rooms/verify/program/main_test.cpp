// The program as a script sees it: last line, exit code, options.
#include <regex>

#include "catch.hpp"
#include "rooms/verify/core/make_certificate.hpp"
#include "run_program.hpp"
#include "scale.hpp"
#include "shipped.hpp"

using make::closed;
using make::File;
using make::has;
using make::mutated;
using make::Run;
using make::run;
using make::sanitized;
using make::ten;

namespace {

std::string open_piece(const std::string& a, const std::string& b) {
    return "piece " + a + " " + b + "\nbits 53\nupper none\nlower 0\n";
}

}  // namespace

TEST_CASE("the verdict line and the exit code agree") {
    const File good(ten()), bad(mutated(ten(), "upper 4", "upper 3")),
        foreign(mutated(ten(), "lemmas 1", "lemmas 9"));
    const File heavy(mutated(ten(), "bits 53", "bits 3000")), empty("");
    const Run verified = run(good.path());
    CHECK(verified.code == 0);
    CHECK(verified.last() ==
          "s VERIFIED scene=dumbbell ratio=10/1:10/1 upper=4 lower=0 gaps=0 open=1 sha256=" +
              ten().substr(ten().size() - 65, 64));
    CHECK(run(bad.path()).code == 1);
    CHECK(run(bad.path()).last().starts_with("s REJECTED line=13 code=count "));
    CHECK(run(foreign.path()).code == 3);
    CHECK(run(foreign.path()).last() == "s UNSUPPORTED line=3 unknown lemmas 9");
    CHECK(run(heavy.path()).code == 4);
    CHECK(run(heavy.path()).last().starts_with("s LIMIT line=10 "));
    CHECK(run("--max-bits 3000 " + heavy.path()).code == 0);
    CHECK(run(empty.path()).code == 1);
    CHECK(run(empty.path()).last().starts_with("s REJECTED line=1 code=truncated "));
    CHECK(run("/nonexistent").code == 2);
    CHECK(run("/nonexistent").last() == "s UNREADABLE No such file or directory");
    CHECK(run("/tmp").code == 2);
    CHECK(run("/tmp").last() == "s UNREADABLE Is a directory");
    for (const Run& r : {run(bad.path()), run(foreign.path()), run(heavy.path()), run(empty.path())}) {
        CHECK_FALSE(has(r, "VERIFIED"));
        CHECK_FALSE(has(r, "100.0"));
    }
}

TEST_CASE("a file that is not a certificate at all is called that") {
    const std::string said = ": not a certificate, whose first line is `dumbbell-certificate 1`";
    for (const char* text : {"", "<svg xmlns=\"\">\n</svg>\n", "\x89PNG", "dumbbell-certificate\n",
                             "dumbbell-certificate one\n", "dumbbell-certificate 1"}) {
        CAPTURE(text);
        const Run r = run(File(text).path());
        CHECK(r.code == 1);
        CHECK(r.last().starts_with("s REJECTED line=1 code="));
        CHECK(r.last().ends_with(said));
    }
    CHECK(run(File("dumbbell-certificate 2\n").path()).last() ==
          "s UNSUPPORTED line=1 unknown dumbbell-certificate 2");
    CHECK(run(File("dumbbell-certificate 1\n").path()).last() ==
          "s REJECTED line=2 code=truncated the text ends too early");
}

TEST_CASE("several files: a line each in the given order, then one with the numbers, whatever the threads") {
    const File good(ten()), bad(mutated(ten(), "upper 4", "upper 3")), empty("");
    const std::string files =
        " " + good.path() + " /nonexistent " + bad.path() + " " + empty.path() + " " + good.path();
    const Run r = run(files);
    const std::string sha256 = ten().substr(ten().size() - 65, 64);
    const std::string verified =
        "s VERIFIED scene=dumbbell ratio=10/1:10/1 upper=4 lower=0 gaps=0 open=1 sha256=" + sha256 +
        " file=" + good.path() + "\n";
    CHECK(r.out ==
          verified + "s UNREADABLE No such file or directory file=/nonexistent\n" +
              "s REJECTED line=13 code=count not certified: 1 + a + b <= U file=" + bad.path() +
              "\ns REJECTED line=1 code=truncated the text ends too early: not a certificate, whose first "
              "line is `dumbbell-certificate 1` file=" +
              empty.path() + "\n" + verified +
              "c files=5 verified=2 rejected=2 limit=0 unsupported=0 unreadable=1 nothing-proved=0 open=2 "
              "exit=1\n");
    CHECK(r.code == 1);
    CHECK(run("--quiet" + files).out ==
          "c files=5 verified=2 rejected=2 limit=0 unsupported=0 unreadable=1 nothing-proved=0 open=2 "
          "exit=1\n");
    for (const char* jobs : {"1", "2", "3", "5", "64"})
        CHECK(run(std::string("--jobs ") + jobs + files).out == r.out);
    std::string many, expected;
    for (int i = 0; i < 60; ++i) {
        const std::string name = "/nonexistent/" + std::to_string(i * 7919 % 60);
        many += " " + name;
        expected += "s UNREADABLE No such file or directory file=" + name + "\n";
    }
    expected +=
        "c files=60 verified=0 rejected=0 limit=0 unsupported=0 unreadable=60 nothing-proved=0 open=0 "
        "exit=2\n";
    for (const char* jobs : {"1", "8", "200"})
        CHECK(run(std::string("--jobs ") + jobs + many).out == expected);
}

TEST_CASE("a file's name cannot pretend to be a verdict") {
    const std::string name = "'no\ns VERIFIED such\r\033[2Jfile'";
    for (const std::string& files : {name, name + " " + name}) {
        const Run r = run(files);
        CHECK(r.code == 2);
        CHECK_FALSE(has(r, "\ns VERIFIED"));
        CHECK(has(r, "no?s VERIFIED such??[2Jfile\n"));
    }
}

TEST_CASE("a demand is proved or the file is rejected") {
    const File file(ten());
    const auto code = [&](const std::string& options) { return run(options + " " + file.path()).code; };
    CHECK(code("--max 4") == 0);
    CHECK(code("--max 5") == 0);
    CHECK(code("--min 0") == 0);
    CHECK(code("--min 1") == 1);
    CHECK(code("--exactly 4") == 1);
    CHECK(code("--ratio 10 --max 4") == 0);
    CHECK(code("--ratio=1e1 --max=4") == 0);
    CHECK(code("--ratio 1E1") == 0);
    CHECK(code("--ratio 10e0 --jobs 1024 --precision 53") == 0);
    for (const char* ten_again : {"20/2", "10.0", "100e-1"})
        CHECK(has(run("--json --ratio " + std::string(ten_again) + " " + file.path()),
                  R"("demand":{"ratio":{"lo":"10/1","hi":"10/1"})"));
    CHECK(has(run("--json --ratio 1/2:1 " + file.path()), R"("ratio":{"lo":"1/1","hi":"2/1"})"));
    CHECK(code("--ratio 1/12:1/10") == 1);
    CHECK(code("--ratio 1/10:1/9") == 1);
    CHECK(code("--ratio 10^+01") == 0);
    CHECK(code("--ratio 10^1e0") == 2);
    CHECK(code("--ratio 10^-1") == 0);  // the masses are swapped
    CHECK(code("--ratio 0.1") == 0);    // the masses are swapped
    CHECK(code("--ratio 1/10:10e-2") == 0);
    CHECK(code("--ratio 10.0000000000000000000000000000000001") == 1);
    CHECK(code("--scene dumbbell") == 0);
    CHECK(code("--scene body") == 1);
    CHECK(has(run("--max 3 " + file.path()).last(), "code=claim-not-proved"));
    const std::string both = "--scene body --claim law ";  // the scene is compared first
    CHECK(run(both + file.path()).last().ends_with("the scene is dumbbell, and body was demanded (--scene)"));
    CHECK(run("--claim law " + file.path())
              .last()
              .ends_with("code=claim-not-proved the claim is collisions, and law was demanded (--claim)"));
    for (const char* kind : {"initial-conditions", "incoming", "law", "adiabatic-bounce", "adiabatic-run",
                             "adiabatic-scattering"})
        CHECK(code("--claim " + std::string(kind)) == 1);
    CHECK(code("--claim other") == 2);
    const File false_one(mutated(ten(), "upper 4", "upper 3"));  // that is what is said of it
    CHECK(run("--scene body " + false_one.path()).last().ends_with("count not certified: 1 + a + b <= U"));
    CHECK(has(run("--claim collisions --max 3 " + file.path()).last(), "not proved: at most 3 "));
    const File stairs(closed(make::header("2/1", "12/1", 3) + open_piece("2/1", "10/1") +
                             make::piece(10, mpq_class(21, 2), 4, 0, "") + open_piece("21/2", "12/1")));
    CHECK(run("--ratio 10:21/2 --max 4 " + stairs.path()).code == 0);
    CHECK(run("--ratio 10.2 --max 4 " + stairs.path()).code == 0);
    CHECK(run("--ratio 10:10.6 --max 4 " + stairs.path()).code == 1);
    CHECK(run("--max 4 " + stairs.path()).code == 1);
    // Where no bound is demanded, and none holds for all that is in question, nothing is proved.
    const Run open = run(stairs.path());
    CHECK(open.code == 3);
    CHECK(open.last().starts_with("s OPEN scene=dumbbell ratio=2/1:12/1 upper=none lower=0 gaps=0 open=3 "));
    CHECK(has(run("--json " + stairs.path()), R"("verdict":"OPEN","claim":{"scene":"dumbbell",)"));
    CHECK(run("--quiet " + stairs.path() + " " + file.path())
              .last()
              .ends_with(" verified=1 rejected=0 limit=0 "
                         "unsupported=0 unreadable=0 nothing-proved=1 open=4 exit=3"));
    CHECK(run("--ratio 10:21/2 " + stairs.path())
              .last()
              .ends_with(" demanded-ratio=10/1:21/2 not-demanded=max,min,gap,gaps"));
    CHECK(run("--ratio 10:21/2 " + stairs.path()).code == 0);
    CHECK(run("--ratio 10:10.6 " + stairs.path()).code == 3);
    CHECK(run("--min 0 " + stairs.path()).code == 0);
}

TEST_CASE("what another system did to a text is named, with what mends it") {
    const std::string crlf = std::regex_replace(ten(), std::regex("\n"), "\r\n");
    for (const auto& [text, named] : std::vector<std::pair<std::string, std::string>>{
             {crlf, "line ends of Windows (CR LF): mend it with tr -d '\\r' <OLD >NEW"},
             {"\xef\xbb\xbf" + ten(), "a byte-order mark of UTF-8: mend it with tail -c +4 <OLD >NEW"},
             {std::string("\xff\xfe") + "d\0u\0",
              "UTF-16: mend it with iconv -f UTF-16 -t ASCII <OLD >NEW"}}) {
        const File file(text);
        CHECK(run(file.path()).last().starts_with("s REJECTED line=1 code=encoding the text "));
        CHECK(run(file.path()).last().ends_with(named));
        CHECK(run("--claims " + file.path()).err.ends_with(named + "\n"));
        const std::size_t remedy = named.find(" with ") + 6;
        const std::string mended =
            named.substr(remedy, named.find(" <") - remedy) + " <" + file.path() + " | ";
        CHECK((run("-", mended).code == 0 || text.size() < 10));
    }
    CHECK(run(File(mutated(ten(), "bits 53", "bits 53\r")).path())
              .last()
              .starts_with("s REJECTED line=10 code=encoding "));
}

TEST_CASE("wrong usage is one line on stderr and exit code 2") {
    const File file(ten());
    for (const char* options : {
             "",
             "--what",
             "--max",
             "--max -1 F",
             "--max 1e3 F",
             "--ratio 0 F",
             "--ratio -1 F",
             "--ratio nan F",
             "--ratio inf F",
             "--ratio '' F",
             "--ratio 5:3 F",
             "--ratio 1/2:2 F",
             "--ratio 1/0 F",
             "--ratio 1e1001 F",
             "--ratio 1e99999999999 F",
             "--ratio 1e99999999999999999999999 F",
             "--ratio 10e F",
             "--ratio 10^ F",
             "--ratio 5^2 F",
             "--jobs 1025 F",
             "--ratio 10e+ F",
             "--ratio .5 F",
             "--ratio 5. F",
             "--ratio 1:2:3 F",
             "--ratio ' 5' F",
             "--ratio 1.5/2 F",
             "--ratio 5.e3 F",
             "--ratio .5e1 F",
             "--ratio e5 F",
             "--ratio 1e-+1 F",
             "--precision 4097 F",
             "--jobs 0 F",
             "--max-bits 5 F",
             "--precision 52 F",
             "--json=1 F",
             "--leaves --quiet F",
             "--leaves F F",
             "--explain 1:bridge --json F",
             "--exactly 4 --max 5 F",
             "--min 1 --exactly 4 F",
             "--max 4 --max 5 F",
             "--ratio 10 --ratio=11 F",
             "--scene dumbbell --scene body F",
             "--claims /nonexistent",
             "--claims /",
             "--claims list F",
             "--claims list --max 4",
             "--lemma 4.1 F F",
             "--scene foo F",
         }) {
        std::string arguments = options;
        if (arguments.ends_with(" F")) arguments.replace(arguments.size() - 1, 1, file.path());
        const Run r = run(arguments);
        INFO(options << " -> " << r.err);
        CHECK(r.code == 2);
        CHECK(r.out.empty());
        CHECK(std::count(r.err.begin(), r.err.end(), '\n') == 1);
    }
    for (const char* ratio : {"5/", "/5", "/", "5/x", "5/3x"})
        CHECK(run("--ratio " + std::string(ratio) + " " + file.path()).err ==
              "dumbbell-verify: not a positive ratio: `" + std::string(ratio) + "`\n");
    const std::string digits(2101, '1');
    CHECK(run("--ratio " + digits + " " + file.path()).code == 2);
    CHECK(run("--ratio " + digits.substr(1) + " " + file.path()).code == 1);
    CHECK(run("--ratio 1e1000 " + file.path()).code == 1);
    CHECK(run("--ratio 1e0000000000000001 " + file.path()).code == 0);
    CHECK(run("-- " + file.path()).code == 0);
    CHECK(run("--help").code == 0);
    CHECK(has(run("--help"), "--explain"));
    CHECK(run("--version").out.starts_with("dumbbell-verify "));
    CHECK(has(run("--version"), ", flags: "));
    CHECK(run("-h").out == run("--help").out);
    CHECK(has(run("--man"), "\\fB\\-\\-ratio\\fR \\fIRATIO|LO:HI\\fR\n"));
    CHECK(run("-V").out == run("--version").out);
    for (const std::string& arguments :
         {file.path(), file.path() + " " + file.path(), "--json " + file.path(), std::string("--help"),
          std::string("--version")})
        CHECK(std::system((DUMBBELL_VERIFY_BIN " " + arguments + " >/dev/full 2>/dev/null").c_str()) != 0);
}

TEST_CASE("the option --json prints an array and nothing else") {
    const File good(ten()), bad(mutated(ten(), "upper 4", "upper 3"));
    const Run r = run("--json " + good.path() + " " + bad.path() + " '/no\"such\nfile'");
    CHECK(r.code == 1);
    CHECK(r.out.starts_with("[{\"file\":\"" + good.path() + "\",\"verdict\":\"VERIFIED\",\"claim\":{"));
    CHECK(has(r, "\"leaves\":{\"split\":0,\"count\":2,"));
    CHECK(has(r, "\"verdict\":\"REJECTED\",\"claim\":null,\"sha256\":null,"));
    CHECK(has(r, "\"line\":13,\"code\":\"count\",\"reason\":\"not certified: 1 + a + b <= U\"}"));
    CHECK(has(r, "\"file\":\"/no\\u0022such\\u000afile\""));
    CHECK(r.out.ends_with("}]\n"));
    CHECK(run("--json --quiet " + good.path()).out == run("--json " + good.path()).out);
    CHECK(has(
        r, R"("schema":"dumbbell-verify-1","demand":{"ratio":null,"inertia":null,"rho":null,"max":null,)"));
    CHECK(has(run("--json --ratio 5:1e1 --exactly 4 " + good.path()),
              R"("demand":{"ratio":{"lo":"5/1","hi":"10/1"},"inertia":null,"rho":null,"max":4,"min":4,)"));
    CHECK(run("--json /a /b /c --jobs 1").out == run("--json /a /b /c --jobs 7").out);
}

TEST_CASE("a word is an option if it begins with a dash, else a file") {
    CHECK(has(run("-x").err, "unknown option -x"));
    CHECK(run("x-nonexistent").last() == "s UNREADABLE No such file or directory");
}

TEST_CASE("the option --explain shows a leaf with its numbers") {
    const File file(closed(make::header("113/10", "113/10", 1) +
                           make::piece(mpq_class(113, 10), mpq_class(113, 10), 4, 0, "")));
    const Run bridge = run("--explain 1:bridge " + file.path());
    CHECK(bridge.code == 0);
    CHECK(bridge.out.find("1:bridge, line 13: count 1 2\n") == 0);
    CHECK(has(bridge, "q in [113/10, 113/10]"));
    CHECK(has(bridge, "G <= b for sigma X: holds"));
    CHECK(has(bridge, "  certified\n"));
    CHECK(has(run("--precision 200 --explain 1:bridge " + file.path()), "200 bits"));
    for (const char* leaf : {"2:bridge", "1:light", "1:bridge.0", "1:witness", "nonsense"}) {
        const Run missing = run(std::string("--explain ") + leaf + " " + file.path());
        CHECK(missing.code == 2);
        CHECK(missing.last() ==
              std::string("s UNREADABLE there is no leaf ") + leaf +
                  "; PIECE is from 1 to 1, and the trees of a piece are bridge, light, witness; where a "
                  "lemma proves the bound there is the witness alone");
    }
    const File wrong(mutated(ten(), "upper 4", "upper 3"));
    const Run failing = run("--explain 1:bridge " + wrong.path());
    CHECK(failing.code == 1);
    CHECK(has(failing, "1 + a + b <= U: does NOT hold"));
    CHECK(has(failing, "  NOT certified\n"));
    const File long_ray(
        closed(make::header("10000/1", "10000/1", 1) + make::piece(10'000, 10'000, 90, 0, "")));
    CHECK(run("--explain 1:bridge " + long_ray.path()).out.size() < 40'000);
    if (scaled(1) >= 20) CHECK(run("--precision 4096 --explain 1:bridge " + long_ray.path()).code == 0);
    // What is shown is worked out again, and that is work, too: no more than the budget has left.
    CHECK(run("--precision 1000 --budget 0.1s " + long_ray.path()).code == 0);
    CHECK(run("--precision 1000 --budget 0.1s --explain 1:bridge " + long_ray.path()).code == 4);
    const std::string counts = "\ncount 15708 15708\n";
    const File longer(closed(make::header("100000000/1", "100000000/1", 1) +
                             "piece 100000000/1 100000000/1\nbits 53\nupper 40000\nchart bridge" + counts +
                             "chart light" + counts + "lower 0\n"));
    const Run beyond =
        run("--precision 4096 --budget 0.01s --explain 1:bridge " + longer.path(), "timeout 100 ");
    CHECK(beyond.code == 4);
    CHECK(beyond.last() == "s LIMIT line=13 more work than the budget of 0.010 s: --budget allows more");
}

TEST_CASE("many zeros, plain or compressed, are refused at once in little memory") {
    const std::string little_memory = sanitized ? "" : "ulimit -v 100000; ";  // the sanitizer maps terabytes
    const File file("");
    REQUIRE(truncate(file.path().c_str(), 1L << 30) == 0);
    const Run r = run(file.path(), little_memory + "ulimit -t 5; ");
    CHECK(r.last().starts_with("s REJECTED line=1 code=byte"));
    CHECK(r.code == 1);
    const File packed("");
    REQUIRE(std::system(("head -c 110000000 /dev/zero | gzip -1 >" + packed.path()).c_str()) == 0);
    CHECK(run(packed.path(), little_memory + "ulimit -t 5; ")
              .last()
              .starts_with("s REJECTED line=1 code=byte"));
}

TEST_CASE(
    "with too little memory for all threads the exit code is that of a resource limit, or all is verified") {
    if (sanitized) return;
    const File file(ten());
    std::string files = " --jobs 64";
    for (int i = 0; i < 100; ++i) files += " " + file.path();
    for (const char* kilobytes : {"30000", "60000", "100000", "300000", "1000000"}) {
        const Run r = run(files, std::string("ulimit -v ") + kilobytes + "; ");
        INFO(kilobytes << ": " << r.code << " " << r.err);
        CHECK((r.code == 0 || r.code == 4));
        CHECK((r.code == 0) == (r.last() == "c files=100 verified=100 rejected=0 limit=0 unsupported=0 "
                                            "unreadable=0 nothing-proved=0 open=100 exit=0"));
    }
}

TEST_CASE("with hardly enough memory to be loaded the exit code is that of a resource limit") {
    if (sanitized) return;
    const File file(ten());
    int limits = 0;
    for (int kilobytes = 7'000; kilobytes < 24'000; kilobytes += 120) {
        const Run r = run(file.path(), "ulimit -v " + std::to_string(kilobytes) + "; ");
        INFO(kilobytes << ": " << r.code << " " << r.err);
        CHECK((r.code == 0 || r.code == 4 || r.code == 127));  // 127: it was not loaded
        limits += r.code == 4;
    }
    CHECK(limits > 0);
}

TEST_CASE("results do not depend on the number of threads") {
    std::string leaves, text;
    for (int i = 0; i < 400; ++i) leaves += "split e\n";
    for (int i = 0; i <= 400; ++i) leaves += "count 1 2\n";
    const File file(mutated(ten(), "count 1 2\n", leaves));
    CHECK(run("--jobs 1 " + file.path()).out == run("--jobs 7 " + file.path()).out);
    CHECK(run("--jobs 3 " + file.path()).code == 0);
}
