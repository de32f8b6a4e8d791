// Bad input: one clear line on stderr, exit 2, nothing on stdout, nothing written.
#include <algorithm>
#include <cctype>
#include <regex>

#include "catch.hpp"
#include "reference.hpp"

using namespace dumbbell_test;

TEST_CASE("reversed, incomplete and crossing ranges are refused, with what to do") {
    CHECK_THAT(refused({"certify", "5:3"}), Contains("smaller ratio first"));
    CHECK_THAT(refused({"certify", "0.5:2"}), Contains("write 1:2 ("));
    for (const char* range : {"1:", ":2", ":", "1:2:3", "1::2", "1-2", "1..2", "a:b", "0:5", "0:0"}) {
        CAPTURE(range);
        refused({"certify", range, "--out", "file.dbc"});
    }
}

TEST_CASE("the option --gap must be from 1e-300 to 0.01") {
    for (const char* gap :
         {"0", "9e-301", "1e-999", "2", "0.0101", "1", "-1", "nan", "inf", "", "x", "1e-3:1e-2", "0/1"}) {
        CAPTURE(gap);
        refused({"certify", "1:100", "--gap", gap, "--out", "file.dbc"});
    }
    CHECK_THAT(refused({"certify", "1:100", "--gap", "2"}), Contains("from 1e-300 to 0.01"));
}

TEST_CASE("the option --budget needs a unit") {
    for (const char* budget : {"5", "s", "-1s", "1d", "1 s", "nans", "1:2s", "1e9999s"}) {
        CAPTURE(budget);
        CHECK_THAT(refused({"certify", "10", "--budget", budget, "--out", "file.dbc"}), Contains("30s"));
    }
}

TEST_CASE("unknown sections, options and commands are refused") {
    CHECK_THAT(refused({"certify", "10", "--section", "golden", "--out", "file.dbc"}), Contains("golden"));
    CHECK_THAT(refused({"frobnicate", "10"}), Contains("frobnicate"));
    refused({"certify", "10", "-x"});
    refused({"certify"});
    refused({""});
}

TEST_CASE("a command or option that is nearly right is named, and the help that explains it", "[wings]") {
    CHECK_THAT(refused({"certfy", "10"}),
               Contains("no command 'certfy'; did you mean certify? see dumbbell --help"));
    CHECK_THAT(refused({"certify", "10", "--secton", "full"}),
               Contains("did you mean --section? see dumbbell certify --help"));
    CHECK_THAT(refused({"certify", "10", "--qiuet"}), Contains("did you mean --quiet? "));
    CHECK_THAT(refused({"plot", "stiarcase"}), Contains("did you mean staircase? see dumbbell plot --help"));
    CHECK_THAT(refused({"certify", "10", "--output", "x"}), Contains("did you mean --out? "));
    CHECK_THAT(refused({"certify", "10", "--frobnicate"}), !Contains("did you mean"));
    CHECK_THAT(refused({"mona-lisa"}), !Contains("did you mean"));
    CHECK_THAT(refused({"certify", "10", "--jobs", "0"}), Contains("see dumbbell certify --help"));
}

TEST_CASE("what is wrong is said in plain words, and in the order given", "[wings]") {
    CHECK_THAT(refused({"--foo"}), Contains("there is no option '--foo'; see dumbbell --help"));
    CHECK_THAT(refused({}), Contains("dumbbell needs a command: ") && Contains("certify"));
    CHECK_THAT(refused({"plot", "pie", "x"}),
               Contains("plot has no command 'pie'; see dumbbell plot --help"));
    CHECK_THAT(refused({"plot"}), Contains("plot needs a command: staircase, orbit"));
    for (const Words& words : {Words{"plot", "pie", "--help"}, Words{"help", "plot", "pie"}}) {
        CHECK_THAT(refused(words), Contains("plot has no command 'pie'; see dumbbell plot --help"));
    }
    CHECK_THAT(refused({"plot", "verify", "--help"}), Contains("plot has no command 'verify'; see"));
    CHECK_THAT(refused({"certfy", "--help"}),
               Contains("there is no command 'certfy'; did you mean certify?"));
    CHECK_THAT(refused({"plot", "orbit", "10", "--out", ".svg"}),
               Contains("ends in .svg ('.svg' has nothing before that)"));
    CHECK_THAT(refused({"critical", "10^18"}),
               Contains("one critical ratio at a time, up to N = 10^100: dumbbell law --count 10^18\n"));
    CHECK_THAT(refused({"certify", "10", "30", "20"}), Contains("not expected here: '30', '20'"));
    CHECK_THAT(refused({"certify", "10", "x", "--outt"}), Contains("not expected here: 'x', '--outt'"));
    CHECK_THAT(refused({"certify", "10", "--outt"}), Contains("there is no option '--outt' here"));
    CHECK_THAT(refused({"certify", "10", "--out", "a.dbc", "--out", "b.dbc"}),
               Contains("--out is given 2 times: give it once"));
    CHECK_THAT(refused({"certify", "10", "--out"}), Contains("--out needs a value"));
    CHECK_THAT(refused({"certify", "10", "--quiet", "--witness"}), Contains("exclude each other"));
    CHECK_THAT(refused({"certify", "1:100", "--gap", "abc"}), Contains("--gap: 'abc' is not a number"));
    CHECK_THAT(refused({"certify", "1:100", "--gap", "-1e-6"}), Contains("--gap: '-1e-6' is negative"));
    for (const char* ratio : {"-3", "-.5", "\u22123"}) {
        CHECK_THAT(refused({"certify", ratio}),
                   Contains("'" + std::string(ratio) + "' is negative: write a positive number"));
    }
    CHECK_THAT(refused({"certify", "-inf"}), Contains("'-inf' is not a number: write it like 10"));
    CHECK_THAT(refused({"certify", "4,61"}), Contains("'4,61' is not a number: write 4.61"));
    CHECK_THAT(refused({"certify", "10..20"}), Contains("'10..20' is not a number: write 10:20"));
    const auto refused_start = [](const char* option, const char* value) {
        Words words{"trace", "10", "--phi", "1/3", "--phidot", "1", "--y", "3", "--ydot", "-1/2"};
        *(std::find(words.begin(), words.end(), option) + 1) = value;
        return refused(words);
    };
    CHECK_THAT(refused_start("--ydot", "-.5"), Contains("--ydot: '-.5' is not a number: write -0.5"));
    CHECK_THAT(refused_start("--ydot", "\u22121/3"),
               Contains("--ydot: '\u22121/3' is not a number: write -1/3"));
    CHECK_THAT(refused_start("--phi", "-.5"), Contains("--phi: '-.5' is not a number: write -0.5"));
    CHECK_THAT(refused_start("--phi", "-.5pi"), Contains("--phi: '-.5' is not a number: write -0.5"));
    CHECK_THAT(refused_start("--phi", "\u2212\u03c0/3"),
               Contains("--phi: '\u2212\u03c0/3' is not an angle: write -pi/3"));
    CHECK_THAT(refused_start("--phi", "90\u00b0"), Contains("'90\u00b0' is not an angle: write 90deg"));
    CHECK_THAT(refused({"certify", "1:100", "--part", "abc"}), Contains("--part 'abc' is not a part"));
    CHECK_THAT(refused({"plot", "orbit", "0", "--out", "x.svg"}), Contains("greater than 0"));
    CHECK_THAT(refused({"plot", "orbit", "none.dbc", "--out", "x.svg"}), Contains("no such file"));
    for (const Words& words : {Words{}, Words{"plot"}, Words{"--foo"}, Words{"plot", "x"}}) {
        CHECK_THAT(refused(words), !Contains("ubcommand"));
    }
}

TEST_CASE("every option of every command is refused without its value, with a wrong one, or given twice") {
    static const std::regex range(".* \\(([0-9]+) to ([0-9]+)\\).*");
    for (const ListedCommand& command : listed_commands()) {
        const auto with = [&](Words words) {
            words.insert(words.begin(), command.words.begin(), command.words.end());
            return refused(words);
        };
        for (const ListedOption& option : command.options) {
            if (command.words == Words{"verify"} || option.is_argument() || option.value().empty()) {
                continue;
            }
            const std::string name = option.names().back(), value = option.value();
            CAPTURE(command.words, name);
            CHECK_THAT(with({name}), Contains(name + " needs a value"));
            CHECK_THAT(with({name + "="}), Contains(name + " needs a value"));
            CHECK_THAT(with({name, "1", name, "1"}), Contains(name));
            if (std::smatch found; std::regex_match(option.meaning, found, range)) {
                const std::string wrong = " is not from " + found[1].str() + " to " + found[2].str();
                for (const std::string& number : {std::string("-1"), found[2].str() + "0", std::string("1.5"),
                                                  std::string("x"), std::string()}) {
                    CHECK_THAT(with({name, number}), Contains(name + ": " + number + wrong));
                }
            } else if (std::islower(value.front()) != 0) {
                CHECK_THAT(with({name, "trumpet"}), Contains(name + ": trumpet not in {"));
            }
        }
    }
}

TEST_CASE("an output without a name is refused by each command that has one", "[wings]") {
    for (Words words :
         {Words{"certify", "10"}, Words{"critical", "4"}, Words{"adiabatic"}, Words{"trace", "10"},
          Words{"plot", "staircase", "x.dbc"}, Words{"report", "x.dbc"}}) {
        CAPTURE(words);
        words.insert(words.end(), {"--out", ""});
        CHECK_THAT(refused(words), Contains("--out: the file name is empty; see dumbbell " + words[0]));
    }
}

TEST_CASE("too few open files are no internal error") {
    // Some are open already where the tests run: so each number until there are enough.
    for (int most = 3, code = 127; code != 0 && most < 100; ++most) {
        const TemporaryFolder folder;
        const Outcome result = run({"sh", "-c",
                                    "ulimit -n " + std::to_string(most) +
                                        "; exec " DUMBBELL_BIN " certify 1:10 --quiet --out ten.dbc"},
                                   folder.path());
        CAPTURE(most, result.err);
        code = result.code;
        REQUIRE((code == 0 || code == 2 || code == 127));  // 127: not even the program's libraries
        if (code == 2) {
            CHECK(count_lines(result.err) == 1);
            CHECK_THAT(result.err, StartsWith("dumbbell: cannot ") && EndsWith(": Too many open files\n"));
        }
    }
}

TEST_CASE("an output that cannot be written is known before the search, named, with the cause") {
    CHECK_THAT(refused({"certify", "10", "--out", "no/such/folder/file.dbc"}),
               Contains("cannot create 'no/such/folder/file.dbc': there is no folder 'no/such/folder'\n"));
    CHECK_THAT(refused({"certify", "10", "--out", "."}), Contains("directory"));
    CHECK_THAT(refused({"certify", "10", "--out", "/"}), Contains("directory"));
    refused({"certify", "10", "--out", "/proc/file.dbc"});
    refused({"certify", "10", "--out", std::string(300, 'x')});
    // If it were not known before, this would search for a long time.
    refused({"certify", "1:1000000", "--gap", "1e-9", "--out", "no/such/folder/file.dbc"});
}

TEST_CASE("a ratio beyond 10^100, or a range beyond 10^36, is refused") {
    const std::string just_beyond = "1" + std::string(99, '0') + "1";
    for (const char* ratio : {just_beyond.c_str(), "1e101", "1e300", "1e-1000"}) {
        CHECK_THAT(refused({"certify", ratio, "--out", "file.dbc"}), Contains("beyond 10^100, the greatest"));
    }
    CHECK_THAT(refused({"certify", "1e-101"}), Contains("says: dumbbell law --ratio 1e101\n"));
    CHECK_THAT(refused({"certify", just_beyond}), Contains("says: dumbbell law --ratio RATIO\n"));
    for (const char* range : {"1:1000000000000000000000000000000000001", "1:1e37"}) {
        CHECK_THAT(refused({"certify", range, "--out", "file.dbc"}), Contains("beyond 10^36, the greatest"));
    }
    CHECK_THAT(refused({"certify", "1e37", "--section", "full"}), Contains("beyond 10^36, the greatest"));
}

TEST_CASE("a range of more than a million steps is refused with advice") {
    for (const char* range : {"2:2e12", "1e16:1e17", "1e35:1e36"}) {
        CHECK_THAT(refused({"certify", range, "--out", "file.dbc"}), Contains("in parts"));
    }
}

TEST_CASE("plot refuses what is no certificate over a range", "[wings]") {
    for (const Words& words : {Words{"plot", "staircase"}, Words{"report"}}) {
        const std::string out = words[0] == "plot" ? "x.svg" : "x.html";
        const auto of = [&](const char* file) {
            Words whole = words;
            whole.insert(whole.end(), {file, "--out", out});
            return refused(whole);
        };
        CHECK_THAT(of("missing.dbc"), Contains("'missing.dbc': no such file"));
        CHECK_THAT(of("."), Contains("'.': it is a directory"));
    }
    refused({"plot", "staircase", DUMBBELL_BIN, "--out", "stairs.svg"});
    refused({"plot", "staircase", "missing.dbc"});
    refused({"plot", "staircase"});
}

TEST_CASE("the exit code is the same where the message cannot be written") {
    for (const char* arguments : {" certify ten", " no-such-command", " law no-such-file"}) {
        CAPTURE(arguments);
        const Outcome result =
            run({"sh", "-c", std::string("exec " DUMBBELL_BIN) + arguments + " 2>/dev/full"});
        CHECK(result.code == 2);
        CHECK(result.out.empty());
    }
}
