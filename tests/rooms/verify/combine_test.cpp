// Parts that are put together: never a verdict that the file itself does not get.
#include "verify/program/combine.hpp"

#include <catch2/catch.hpp>

#include "make_parts.hpp"
#include "verify/program/version.hpp"

using namespace dumbbell_verify;
using make::closed;
using make::combined;
using make::File;
using make::replaced;
using make::shard;
using make::stairs_pieces;
using make::stairs_to_100;
using make::whole;

namespace {

/// The lines of all parts of a cut, one each.
std::string lines(const std::string& path, const std::vector<Pieces>& cut, unsigned precision = 0,
                  const std::string& scene = "dumbbell") {
    std::string text;
    for (const Pieces& part : cut) text += shard(path, part, precision, scene) + "\n";
    return text;
}
std::string plain(const std::string& path) {
    gzFile file = gzopen(path.c_str(), "rb");
    std::string text;
    char block[4096];
    for (int n = 0; (n = gzread(file, block, sizeof block)) > 0;)
        text.append(block, static_cast<std::size_t>(n));
    gzclose(file);
    return text;
}

/// What is said of the same file when its parts are put together.
std::string as_combined(const std::string& verdict) {
    return replaced(verdict, "s VERIFIED ", "s COMBINED ");
}

}  // namespace

TEST_CASE("combine: shipped certificates cut at random places get the verdict of the whole") {
    std::mt19937 random(5);
    for (const auto& [name, scene, n] : std::vector<std::tuple<std::string, std::string, std::uint64_t>>{
             {"stairs-1-1e4.dbc.gz", "dumbbell", 177},
             {"stairs-1-100.dbc", "dumbbell", 17},
             {"wedge-1-100.dbc", "wedge", 29},
             {"hybrid-1-100.dbc", "hybrid", 29},
             {"full-100.dbc.gz", "dumbbell", 1}}) {
        const std::string path = make::shipped(name), expected = as_combined(whole(path, scene));
        REQUIRE(expected.starts_with("s COMBINED "));
        for (int i = 0; i < 6; ++i) {
            std::vector<Pieces> cut = make::random_cut(n, random);
            const std::string parts = " parts=" + std::to_string(cut.size());
            std::shuffle(cut.begin(), cut.end(), random);
            std::string text = lines(path, cut, 0, scene);
            INFO(text);
            REQUIRE(combined(path, text, 0, scene) == expected + parts);
            REQUIRE(combined(path, text + text, 0, scene) == expected + parts);  // the same again
            if (n == 1) break;
            const std::uint64_t first = 1 + random() % n, last = first + random() % (n - first + 1);
            text += lines(path, {{first, last}}, 0, scene);  // one that overlaps
            REQUIRE(combined(path, text, 0, scene).starts_with(expected + " parts="));
        }
    }
}

TEST_CASE("combine: a hole is told, wherever it is") {
    const auto text = [](const std::vector<Pieces>& cut) {
        return combined(stairs_to_100, lines(stairs_to_100, cut));
    };
    const std::string start = "s REJECTED code=parts ", by = " not verified by any part";
    CHECK(text({}) == start + "pieces 1-17 are" + by);
    CHECK(text({{2, 17}}) == start + "piece 1 is" + by);
    CHECK(text({{1, 16}}) == start + "piece 17 is" + by);
    CHECK(text({{1, 4}, {8, 17}}) == start + "pieces 5-7 are" + by);
    CHECK(text({{8, 17}, {1, 4}, {2, 3}, {1, 2}}) == start + "pieces 5-7 are" + by);
    CHECK(text({{1, 4}, {6, 9}, {11, 15}}) == start + "piece 5 is" + by + "; 4 pieces in all");
    CHECK(text({{3, 3}}) == start + "pieces 1-2 are" + by + "; 16 pieces in all");
    for (std::uint64_t hole = 1; hole <= stairs_pieces; ++hole) {
        std::vector<Pieces> cut;
        for (std::uint64_t i = 1; i <= stairs_pieces; ++i)
            if (i != hole) cut.push_back({i, i});
        REQUIRE(text(cut) == start + "piece " + std::to_string(hole) + " is" + by);
    }
}

TEST_CASE("combine: lines of another file are refused, though it has as many pieces of the same ratios") {
    const std::string text = make::contents(stairs_to_100);
    const std::string body = text.substr(0, text.find("total split"));
    const std::string honest = lines(stairs_to_100, {{1, 9}, {10, 17}});
    const auto refused = [&](const std::string& other) {
        const File file(other);
        INFO(whole(file.path()));
        const std::string result = combined(file.path(), honest);
        INFO(result);
        return result.starts_with("s REJECTED code=parts PARTS:1: about another file, ");
    };
    CHECK_FALSE(refused(text));
    CHECK(combined(File(make::gzipped(text)).path(), honest) ==
          as_combined(whole(stairs_to_100)) + " parts=2");
    CHECK(refused(closed(replaced(body, "generator dumbbell", "generator dumbbel"))));
    CHECK(refused(closed(replaced(body, "count ", "count 1"))));   // a leaf that may be false
    CHECK(refused(closed(replaced(body, "bits 53", "bits 54"))));  // another precision
    CHECK(refused(closed(replaced(body, "upper 3", "upper 4"))));  // a weaker piece
    CHECK(refused(closed(replaced(body, "lower 3", "lower 2"))));
    CHECK(refused(plain(make::shipped("stairs-1-1e4.dbc.gz"))));
}

TEST_CASE("combine: an edited file that keeps its old trailer is refused by reading it") {
    const std::string text = make::contents(stairs_to_100), honest = lines(stairs_to_100, {{1, 17}});
    for (const auto& [from, to, code] : std::vector<std::tuple<std::string, std::string, std::string>>{
             {"upper 3", "upper 2", ""},
             {"lower 2", "lower 3", ""},
             {"count ", "count 1", "code=sha256"},
             {"bits 53", "bits 60", "code=sha256"},
             {"scene dumbbell", "scene wedge", ""},
             {"section turning", "section full", ""},
             {"pieces 17", "pieces 16", ""},
             {"pieces 17", "pieces 18", ""},
             {"total open 0", "total open 1", "code=total"},
             {"sha256 f", "sha256 e", "code=sha256"}}) {
        const File file(replaced(text, from, to));
        const std::string result = combined(file.path(), honest);
        INFO(from << " -> " << to << ": " << result);
        CHECK(result.starts_with("s REJECTED line="));
        CHECK(result.find(code) != std::string::npos);
    }
    CHECK(combined(File(text + "\n").path(), honest).find("code=trailing") != std::string::npos);
    CHECK(combined(File(text.substr(0, text.size() - 1)).path(), honest).find("code=truncated") !=
          std::string::npos);
    CHECK(combined("/nonexistent", honest) == "s UNREADABLE No such file or directory");
}

TEST_CASE("combine: each value of a line must be what the file says of these pieces") {
    const std::string honest = shard(stairs_to_100, {1, 9}) + "\n",
                      rest = shard(stairs_to_100, {10, 17}) + "\n";
    REQUIRE(combined(stairs_to_100, honest + rest) == as_combined(whole(stairs_to_100)) + " parts=2");
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"pieces=1-9", "pieces=1-10"},
             {"pieces=1-9", "pieces=3-9"},
             {"pieces=1-9", "pieces=1-17"},
             {"pieces=1-9", "pieces=1-18"},
             {"pieces=1-9", "pieces=1-999999999999999999"},
             {"pieces=1-9", "pieces=18-19"},
             {"pieces=1-9", "pieces=9"},
             {"of=17", "of=9"},
             {"of=17", "of=017"},
             {"of=17", "of=18446744073709551633"},
             {"scene=dumbbell", "scene=wedge"},
             {"section=turning", "section=full"},
             {"ratio=1/1", "ratio=2/1"},
             {"ratio=1/1", "ratio=2/2"},
             {"ratio=1/1", "ratio=1"},
             {"upper=", "upper=1"},
             {"upper=", "upper=0"},
             {"upper=", "upper=none"},
             {"lower=2", "lower=1"},
             {"lower=2", "lower=3"},
             {"gaps=", "gaps=1"},
             {"open=0", "open=1"},
             {"open=0", "open=00"},
             {"open=0", "open=0\t"},
         }) {
        const std::string wrong = replaced(honest, from, to);
        const std::string result = combined(stairs_to_100, rest + wrong);
        INFO(wrong << result);
        CHECK(result.starts_with("s REJECTED code=parts PARTS:2: "));
        CHECK(combined(stairs_to_100, honest + rest + wrong).starts_with("s REJECTED code=parts PARTS:3: "));
    }
    CHECK(combined(stairs_to_100, replaced(honest, "lower=2", "lower=1")) ==
          "s REJECTED code=parts PARTS:1: lower=1, but the file has 2 for pieces 1-9");
    CHECK(combined(stairs_to_100, replaced(shard(stairs_to_100, {5, 5}), "pieces=5-5", "pieces=5")) ==
          "s REJECTED code=parts PARTS:1: pieces=5, but the file has 5-5 for piece 5");
    CHECK(combined(stairs_to_100, replaced(honest, "\n", " \n")) ==
          "s REJECTED code=parts PARTS:1: not as dumbbell-verify --shards prints it");
    CHECK(combined(stairs_to_100, replaced(honest, "pieces=1-9", "pieces=1-18")) ==
          "s REJECTED code=parts PARTS:1: pieces 1-18, but the file has only 17");
}

TEST_CASE("combine: no byte of the lines can be changed or left out") {
    const std::string honest = lines(stairs_to_100, {{1, 9}, {10, 17}});
    for (std::size_t i = 0; i < honest.size(); ++i) {
        INFO(i);
        const bool last = i + 1 == honest.size();
        REQUIRE(combined(stairs_to_100, std::string(honest).erase(i, 1)).starts_with("s COMBINED ") == last);
        for (const char byte : {'0', '1', '9', ' ', '-', '=', 'n', '\n', '\r', '\0', '\xff'}) {
            if (honest[i] == byte) continue;
            std::string changed = honest;
            changed[i] = byte;
            REQUIRE_FALSE(combined(stairs_to_100, changed).starts_with("s COMBINED "));
        }
    }
}

TEST_CASE("combine: a precision that is demanded must have been demanded of each part") {
    const std::string loose = lines(stairs_to_100, {{1, 9}}), least = lines(stairs_to_100, {{1, 9}}, 53),
                      more = lines(stairs_to_100, {{10, 17}}, 200);
    const std::string verdict = as_combined(whole(stairs_to_100)) + " parts=2";
    CHECK(combined(stairs_to_100, loose + more) == verdict);
    CHECK(combined(stairs_to_100, least + more, 53) == verdict);
    CHECK(combined(stairs_to_100, loose + more, 53) ==
          "s REJECTED code=parts PARTS:1: pieces 1-9 checked without --precision 53");
    CHECK(combined(stairs_to_100, more + least, 54) ==
          "s REJECTED code=parts PARTS:2: pieces 1-9 checked without --precision 54");
    CHECK(combined(stairs_to_100, least + more, 201).starts_with("s REJECTED code=parts PARTS:1: "));
    CHECK(combined(stairs_to_100, lines(stairs_to_100, {{1, 17}}, 60) + loose, 60)
              .starts_with("s REJECTED code=parts PARTS:2: "));
}

TEST_CASE("combine: lines of another version are unsupported, other lines with a verdict unreadable") {
    const std::string all = lines(stairs_to_100, {{1, 17}}), now = "verifier=" + std::string(version);
    CHECK(combined(stairs_to_100, all + replaced(all, now, "verifier=9.9"))
              .starts_with("s UNSUPPORTED PARTS:2: "));
    CHECK(combined(stairs_to_100, all + whole(stairs_to_100) + "\n").starts_with("s UNREADABLE PARTS:2: "));
    CHECK(combined(stairs_to_100, all + "s REJECTED line=4 code=count\n")
              .starts_with("s UNREADABLE PARTS:2: "));
    CHECK(combined(stairs_to_100, replaced(all, "\n", "\r\n")).starts_with("s UNREADABLE PARTS:1: "));
    CHECK(combined(stairs_to_100, all + "dumbbell-verify: resource limit\n") ==
          as_combined(whole(stairs_to_100)) + " parts=1");
}

TEST_CASE("combine: open pieces stay open, and a claim is judged as of the whole") {
    const File file(make::four_pieces());
    const std::string all = lines(file.path(), {{1, 2}, {3, 4}});
    CHECK(combined(file.path(), all) == as_combined(whole(file.path())) + " parts=2");
    CHECK(combined(file.path(), all).find(" upper=none lower=0 gaps=0 open=4 ") != std::string::npos);
    const File parts(all);
    const auto asked = [&](const mpq_class& lo, const mpq_class& hi, std::uint64_t most,
                           const std::string& scene) {
        Job job = make::job_for(file.path(), scene);
        job.parts = parts.path();
        job.settings.check = {};
        job.settings.demand.keep = all_pieces;
        job.settings.demand.ratios.emplace(lo, hi);
        job.settings.demand.most = most;
        return make::last_line(job);
    };
    CHECK(asked(10, 10, 4, "dumbbell").starts_with("s COMBINED "));
    CHECK(asked(10, mpq_class(21, 2), 4, "dumbbell").starts_with("s COMBINED "));
    CHECK(asked(10, 10, 3, "dumbbell").find(" code=claim-not-proved not proved: at most 3 ") !=
          std::string::npos);
    CHECK(asked(10, 11, 4, "dumbbell").find(" code=claim-not-proved not proved: at most 4 ") !=
          std::string::npos);
    CHECK(asked(10, 13, 5, "dumbbell").find(" code=claim-not-proved of the mass ratios ") !=
          std::string::npos);
    CHECK(asked(10, 10, 4, "wedge")
              .ends_with(" code=claim-not-proved the scene is dumbbell, and wedge was demanded (--scene)"));
}

TEST_CASE(
    "combine: a hundred thousand lines, the same ones again and again, are as many parts as they name") {
    const File file(make::four_pieces());
    std::string all;
    for (std::uint64_t first = 1; first <= 4; ++first)
        for (std::uint64_t last = first; last <= 4; ++last) all += shard(file.path(), {first, last}) + "\n";
    std::string many;
    while (many.size() < 20'000'000) many += all;
    CHECK(combined(file.path(), many) == as_combined(whole(file.path())) + " parts=10");
}
