// Parts of a range: certify --part, and join, which believes none of them.
#include <functional>

#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;

namespace {

/// The parts of the range, certified in files of the folder.
Words made_parts(const TemporaryFolder& folder, int of, const Words& options = {},
                 const char* range = "1:300") {
    Words files;
    for (int k = 1; k <= of; ++k) {
        files.push_back("part-" + std::to_string(k) + ".dbc");
        Words words{"certify", range,       "--part", std::to_string(k) + "/" + std::to_string(of),
                    "--out",   files.back()};
        words.insert(words.end(), options.begin(), options.end());
        REQUIRE(dumbbell(words, folder.path()).code == 0);
    }
    return files;
}

Outcome join(const TemporaryFolder& folder, Words files, const Words& options = {},
             const std::string& out = "whole.dbc") {
    files.insert(files.begin(), "join");
    files.insert(files.end(), {"--out", out});
    if (std::ranges::find(options, "--range") == options.end()) {
        files.insert(files.end(), {"--range", "1:300"});
    }
    files.insert(files.end(), options.begin(), options.end());
    return dumbbell(files, folder.path());
}

/// Joining ends with exit code 2, says this, prints nothing, and leaves the file that was there before.
std::string not_joined(const TemporaryFolder& folder, const Words& files, const Words& options = {},
                       const std::string& out = "whole.dbc") {
    write_file(folder / out, "as before");
    const Outcome result = join(folder, files, options, out);
    CAPTURE(result.out, result.err);
    CHECK(result.code == 2);
    CHECK(result.out.empty());
    CHECK(contents(folder / out) == "as before");
    return result.err;
}

}  // namespace

TEST_CASE("the parts of a range are joined to a certificate of the whole range, in any order") {
    const TemporaryFolder folder;
    const Words parts = made_parts(folder, 3);
    const Outcome joined = join(folder, {parts[2], parts[0], parts[1]}, {"--range", "1:300"});
    CAPTURE(joined.err);
    CHECK(joined.code == 0);
    CHECK(joined.err.empty());
    CHECK_THAT(joined.out, StartsWith("3 parts verified, together the mass ratios 1 to 300: sha256 "));
    CHECK(verifier({"--ratio", "1:300", "--max", "17", "--min", "2", folder / "whole.dbc"}).code == 0);
    REQUIRE(join(folder, parts, {}, "again.dbc").code == 0);
    CHECK(contents(folder / "again.dbc") == contents(folder / "whole.dbc"));
    CHECK_THAT(joined.out, Contains("sha256 " + last_line(contents(folder / "whole.dbc")).substr(7)));
    // The pieces that were cut stay two; all others are those of one go.
    const auto pieces = [](const std::string& text) {
        const std::size_t at = text.find("\npieces ") + 8;
        return std::stoi(text.substr(at));
    };
    CHECK(pieces(contents(folder / "whole.dbc")) == pieces(contents(certificate(folder, "1:300"))) + 2);
}

TEST_CASE("a part says which one it is, and keeps its own finished pieces") {
    const TemporaryFolder folder;
    const Words words{"certify", "1:300", "--part", "2/3"};
    CHECK_THAT(dumbbell(words).out, Contains("Part 2 of 3 of the mass ratios 1 : 300: those from "));
    Words quiet = words;
    quiet.emplace_back("--quiet");
    CHECK_THAT(dumbbell(quiet).out, StartsWith("Part 2 of 3 of the mass ratios 1 : 300: those from "));
    // A run that does nothing but for its time leaves a folder whose claim is the part's range.
    write_file(folder / "part.dbc.partial", "in the way");
    Words kept = words;
    kept.insert(kept.end(), {"--out", "part.dbc"});
    CHECK_THAT(dumbbell(kept, folder.path()).err, Contains("'part.dbc.partial' is in the way"));
}

TEST_CASE("parts are of ranges, and no more than there are steps") {
    CHECK_THAT(refused({"certify", "10", "--part", "1/2"}), Contains("a single mass ratio has no parts"));
    CHECK_THAT(refused({"certify", "1:300", "--part", "3/2"}), Contains("write K/N"));
    CHECK_THAT(refused({"certify", "1:300", "--part", "1/100"}), Contains("cut it into at most"));
}

TEST_CASE("a missing part is named with the command that makes it") {
    const TemporaryFolder folder;
    const Words parts = made_parts(folder, 4);
    const std::string inside = not_joined(folder, {parts[0], parts[3]}, {"--gap", "1e-6"});
    CHECK_THAT(inside, StartsWith("dumbbell: missing: the mass ratios ") &&
                           Contains("to make them: dumbbell certify ") &&
                           Contains(" --gap 1e-6 --out missing-1.dbc\n"));
    CHECK(count_lines(inside) == 1);
    // The command closes the hole, as it is, and without --gap is the same.
    CHECK(not_joined(folder, {parts[0], parts[3]}) == inside);
    const std::string command = inside.substr(inside.find("dumbbell certify ") + 9);
    REQUIRE(run({"sh", "-c", DUMBBELL_BIN " " + command}, folder.path()).code == 0);
    CHECK(join(folder, {parts[0], "missing-1.dbc", parts[3]}).code == 0);

    const std::string at_end = not_joined(folder, {parts[0], parts[1], parts[2]});
    CHECK_THAT(at_end,
               Contains("missing: the mass ratios ") && Contains(":300 --gap 1e-6 --out missing-2.dbc\n"));
    const std::string ends = not_joined(folder, {parts[1], parts[2]}, {"--range", "1:300"});
    CHECK(count_lines(ends) == 2);
    CHECK_THAT(not_joined(folder, parts, {"--range", "1:200"}), Contains("reaches beyond --range"));
}

TEST_CASE("a wrong part is named, with the command that makes it again, and nothing is written", "[wings]") {
    const TemporaryFolder folder;
    const Words parts = made_parts(folder, 3);
    const std::string file = folder / parts[1], good = contents(file);
    const std::string again = " --gap 1e-6 --out " + parts[1] + "\n";

    SECTION("one leaf claims fewer collisions than there are") {
        std::string text = good;
        const auto leaf = text.find("\ncount ");
        write_sealed(file, text.replace(leaf, text.find('\n', leaf + 1) - leaf, "\ncount 0 0"));
        const std::string err = not_joined(folder, parts);
        CHECK_THAT(err, StartsWith("dumbbell: 'part-2.dbc' is not verified: s REJECTED") && Contains(again));
        CHECK(count_lines(err) == 1);
    }
    SECTION("it is cut off") {
        write_file(file, good.substr(0, good.size() / 2));
        CHECK_THAT(not_joined(folder, parts), Contains("'part-2.dbc' is not verified") && Contains(again));
    }
    SECTION("it is empty, or garbage, or missing") {
        for (const char* text : {"", "garbage\n", "dumbbell-certificate 1\n", "\x1f\x8b garbage"}) {
            write_file(file, text);
            const std::string err = not_joined(folder, parts);
            CHECK_THAT(err, Contains("'part-2.dbc'") && Contains("missing: the mass ratios "));
            CHECK(count_lines(err) == 2);
        }
        std::filesystem::remove(file);
        CHECK_THAT(not_joined(folder, parts), Contains("no such file") && Contains("missing: "));
    }
    SECTION("its head claims a range that is none") {
        const std::size_t at = good.find("\nratio ") + 7;
        for (const char* range : {"0/1 5/1", "5/1 4/1", "1/0 5/1", "x y"}) {
            write_file(file, std::string(good).replace(at, good.find('\n', at) - at, range));
            CHECK_THAT(not_joined(folder, parts), Contains("missing: the mass ratios "));
        }
    }
    SECTION("it is none about mass ratios") {
        REQUIRE(dumbbell({"adiabatic", "--theorem", "lemma3.1", "--delta", "0.1", "--out", parts[1]},
                         folder.path())
                    .code == 0);
        CHECK_THAT(not_joined(folder, parts), Contains("is about the adiabatic invariant"));
    }
    SECTION("all parts are garbage") {
        for (const std::string& part : parts) {
            write_file(folder / part, "garbage\n");
        }
        CHECK(count_lines(not_joined(folder, parts)) == 4);
    }
}

TEST_CASE("a part of another range, twice, or overlapping, is refused") {
    const TemporaryFolder folder;
    const Words parts = made_parts(folder, 2);
    CHECK_THAT(not_joined(folder, {parts[0], parts[1], parts[0]}),
               Contains("'part-1.dbc' and 'part-1.dbc' overlap"));
    REQUIRE(dumbbell({"certify", "2:3", "--out", "more.dbc"}, folder.path()).code == 0);
    CHECK_THAT(not_joined(folder, {parts[0], parts[1], "more.dbc"}),
               Contains("'part-1.dbc' and 'more.dbc' overlap"));
    REQUIRE(dumbbell({"certify", "400:410", "--out", "far.dbc"}, folder.path()).code == 0);
    CHECK_THAT(not_joined(folder, {parts[0], parts[1], "far.dbc"}, {"--range", "1:410"}),
               Contains("missing: the mass ratios 300 to 400;"));
}

TEST_CASE("parts of another section are refused in one line") {
    const TemporaryFolder folder;
    const Words parts = made_parts(folder, 2);
    REQUIRE(dumbbell({"certify", "300:310", "--section", "full", "--out", "other.dbc"}, folder.path()).code ==
            0);
    const std::string err = not_joined(folder, {parts[0], parts[1], "other.dbc"});
    CHECK(count_lines(err) == 1);
    CHECK_THAT(err, Contains("are of different claims") && Contains("--section full"));
}

TEST_CASE("parts of the full section are joined") {
    const TemporaryFolder folder;
    const Words parts = made_parts(folder, 2, {"--section", "full", "--gap", "0.01"}, "1:20");
    REQUIRE(join(folder, parts, {"--range", "1:20"}).code == 0);
    CHECK(verifier({"--ratio", "1:20", folder / "whole.dbc"}).code == 0);
}

TEST_CASE("parts with open pieces are joined only with --open, and never with exit code 0") {
    const TemporaryFolder folder;
    Words parts = made_parts(folder, 2);
    Outcome open =
        dumbbell({"certify", "1:300", "--part", "2/2", "--budget", "0s", "--out", parts[1]}, folder.path());
    REQUIRE(open.code == 3);
    Outcome refused = join(folder, parts);
    CHECK(refused.code == 3);
    CHECK(refused.out.empty());
    CHECK_THAT(refused.err,
               Contains("'part-2.dbc' leaves 1 of 1 open; to make it again: dumbbell certify ") &&
                   Contains("add --open"));
    CHECK_FALSE(std::filesystem::exists(folder / "whole.dbc"));
    const Outcome joined = join(folder, parts, {"--open"});
    CHECK(joined.code == 3);
    CHECK_THAT(verifier({folder / "whole.dbc"}).out, Contains("\ns OPEN "));
}

TEST_CASE("an input is never replaced, and what is joined can go to the standard output") {
    const TemporaryFolder folder;
    const Words parts = made_parts(folder, 2);
    const std::string before = contents(folder / parts[0]);
    CHECK_THAT(join(folder, parts, {}, parts[0]).err, Contains("would replace 'part-1.dbc'"));
    CHECK(contents(folder / parts[0]) == before);
    const Outcome printed = join(folder, parts, {"--quiet"}, "-");
    CHECK(printed.code == 0);
    CHECK_THAT(printed.out, StartsWith("dumbbell-certificate 1\n"));
    CHECK_THAT(printed.err, StartsWith("2 parts verified, together the mass ratios 1 to 300: sha256 "));
    CHECK_THAT(join(folder, parts, {}, "whole.tsv").err, Contains("the name of a certificate ends in .dbc"));
    std::filesystem::copy_file(folder / parts[1], folder / "-");
    CHECK_THAT(not_joined(folder, {parts[0], "-"}), Contains("none can be -, the standard input"));
    CHECK(join(folder, {parts[0], "./-"}).code == 0);
    CHECK_THAT(refused({"join", "x.dbc", "--out", "y.dbc"}), Contains("--range is required"));
}

TEST_CASE("a signal ends join and its verifiers, and nothing is written") {
    const TemporaryFolder folder;
    const std::string stairs = DUMBBELL_PROJECT "/certificates/stairs-1-1e6.dbc.gz";
    for (const int signal : {SIGINT, SIGTERM}) {
        Process process(with_program({"join", stairs, "--range", "1:1e6", "--out", "whole.dbc"}),
                        folder.path());
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        process.send(signal);
        const Outcome outcome = process.wait();
        if (outcome.code != 0) {  // else it was done before
            CHECK(outcome.signal == signal);
            CHECK(folder.names().empty());
        }
    }
}
