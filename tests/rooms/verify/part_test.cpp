// A part of a file: its numbers, and its line.
#include "verify/program/part.hpp"

#include <catch2/catch.hpp>

#include "make_parts.hpp"
#include "verify/program/json.hpp"
#include "verify/program/version.hpp"

using namespace dumbbell_verify;

TEST_CASE("parts: the numbers of pieces have one spelling") {
    CHECK(parse_pieces("1-1") == Pieces{1, 1});
    CHECK(parse_pieces("7") == Pieces{7, 7});
    CHECK(parse_pieces("3-12") == Pieces{3, 12});
    CHECK(parse_pieces("1-999999999999999999") == Pieces{1, 999'999'999'999'999'999});
    CHECK(parse_pieces("999999999999999999") == Pieces{999'999'999'999'999'999, 999'999'999'999'999'999});
    for (const char* bad : {"",
                            "-",
                            "0",
                            "0-0",
                            "0-3",
                            "3-2",
                            "1-",
                            "-1",
                            "-1-2",
                            "1--2",
                            "1-2-3",
                            "01",
                            "1-02",
                            "+1",
                            "1-+2",
                            " 1",
                            "1 ",
                            "1- 2",
                            "1:2",
                            "1..2",
                            "1-x",
                            "a",
                            "1e1",
                            "0x1",
                            "1.0",
                            "1000000000000000000",
                            "1-1000000000000000000",
                            "1-18446744073709551616"}) {
        INFO(bad);
        CHECK(parse_pieces(bad) == Pieces{});
    }
    CHECK(parse_pieces(std::string_view("1-2\0", 4)) == Pieces{});
}

TEST_CASE("parts: what is said of one, as a line and as JSON, in full") {
    const make::File file(make::four_pieces());
    const std::string sha256 = make::four_pieces().substr(make::four_pieces().size() - 65, 64);
    CHECK(make::shard(file.path(), {1, 3}) ==
          "s PART pieces=1-3 of=4 scene=dumbbell section=turning ratio=10/1:12/1 upper=none lower=0 gaps=0 "
          "open=3 "
          "precision=none verifier=" +
              std::string(version) + " sha256=" + sha256);
    CHECK(
        make::shard(file.path(), {4, 4}, 80) ==
        "s PART pieces=4-4 of=4 scene=dumbbell section=turning ratio=12/1:12/1 upper=5 lower=0 gaps=0 open=1 "
        "precision=80 verifier=" +
            std::string(version) + " sha256=" + sha256);
    Job job = make::job_for(file.path());
    job.settings.check = job.settings.demand.keep = {2, 4};
    const Result result = examine(job);
    CHECK(result.why.verdict == Verdict::part);
    const std::string text = json(result), line = verdict_line(result);
    CHECK(
        text ==
        "{\"file\":\"" + file.path() +
            R"(","verdict":"PART","claim":null,"sha256":null,"schema":"dumbbell-verify-1",)"
            R"("demand":{"ratio":null,"max":null,"min":null},)"
            R"("part":{"first":2,"last":4,"of":4,"scene":"dumbbell","section":"turning",)"
            R"("ratio":{"lo":"21/2","hi":"12/1"},"upper":null,"lower":0,"gaps":0,"open":3,"precision":null,)"
            R"("verifier":")" +
            std::string(version) + R"(","sha256":")" + sha256 + R"(","line":")" + line +
            R"("},"parts":null,"leaves":{},"coverage":{},"work":null,"line":null,"code":null,"reason":null})");
    CHECK(block(result) == file.path() + "\n" + line + "\n");
    job.settings.precision = 80;
    CHECK(json(examine(job)).find(R"("precision":80,"verifier")") != std::string::npos);
}

TEST_CASE("parts: a job without pieces to check, and without lines of parts, verifies nothing") {
    const make::File file(make::four_pieces());
    CHECK(make::shard(file.path(), {}).starts_with("s LIMIT "));
    CHECK(make::shard(file.path(), {}).find("line=") == std::string::npos);
}
