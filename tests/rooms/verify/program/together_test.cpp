// Several files as one: never a verdict that a file with all their pieces does not get.
#include "verify/program/together.hpp"

#include <algorithm>
#include <deque>

#include "catch.hpp"
#include "make_together.hpp"
#include "rooms/verify/wings/starts/make_file.hpp"
#include "verify/program/summary.hpp"

using namespace dumbbell_verify;
using make::closed;
using make::Cuttable;
using make::File;
using make::header;
using make::piece;
using make::replaced;

namespace {

const std::string stairs_text = make::contents(make::shipped("stairs-1-100.dbc"));

Request settings_asking(const std::optional<std::pair<mpq_class, mpq_class>>& ratios = {},
                        const std::optional<mpz_class>& most = {},
                        const std::optional<mpz_class>& least = {}) {
    Request settings;
    settings.demand.ratios = ratios;
    settings.demand.most = most;
    settings.demand.least = least;
    return settings;
}

/// What is said of files with these texts, which are called A, B, C ...
std::string said_together(const std::vector<std::string>& texts, Request settings = {}) {
    settings.together = true;
    std::deque<File> files;
    std::vector<Job> jobs;
    for (const std::string& text : texts) jobs.push_back({files.emplace_back(text).path(), settings});
    std::vector<Result> results;
    for (const Job& one : jobs) results.push_back(examine(one));
    std::string line = verdict_line(together(jobs.front(), results));
    for (std::size_t i = 0; i < files.size(); ++i)
        for (std::size_t at = 0; (at = line.find(files[i].path())) != std::string::npos;)
            line.replace(at, files[i].path().size(), 1, static_cast<char>('A' + i));
    return line.substr(0, line.find(" sha256="));
}

/// What is said of one file, without its line and its SHA-256.
std::string said_of_one(const std::string& text, const Request& settings = {}) {
    const File file(text);
    const Job asked{file.path(), settings};
    Result result = examine(asked);
    result.why.line = 0;
    const std::string line = verdict_line(result);
    return line.substr(0, line.find(" sha256="));
}

/// n times 10^-300 behind x.
mpq_class just_behind(const mpq_class& x, int n) {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, 300);
    return x + n / mpq_class(power);
}
std::string one_piece_file(const mpq_class& a, const mpq_class& b) {
    return closed(header(make::fraction(a), make::fraction(b), 1) + piece(a, b, 4, 0, ""));
}

}  // namespace

TEST_CASE("together: a certificate cut between its pieces gets, in any order, the verdict of the whole") {
    std::mt19937 random(5);
    const Cuttable cuttable(stairs_text);
    for (int i = 0; i < 60; ++i) {
        std::vector<std::string> files = cuttable.at_random(random);
        std::shuffle(files.begin(), files.end(), random);
        const mpq_class lo(static_cast<unsigned long>(4 + random() % 420), 4),
            hi = lo + mpq_class(static_cast<unsigned long>(random() % 100), 4);
        Request asked = settings_asking({}, random() % 12, random() % 6);
        if (random() % 4 > 0) asked.demand.ratios.emplace(lo, hi);
        if (random() % 3 == 0) asked.demand.most.reset();
        if (random() % 3 == 0) asked.demand.least.reset();
        INFO(files.size() << " files, " << to_string(lo, hi));
        REQUIRE(said_together(files) == said_of_one(stairs_text));
        REQUIRE(said_together(files, asked) == said_of_one(stairs_text, asked));
    }
}

TEST_CASE("together: a hole is told, wherever it is, whatever is asked") {
    const Cuttable cuttable(stairs_text);
    std::vector<std::string> all;
    for (std::size_t i = 0; i < cuttable.pieces.size(); ++i) all.push_back(cuttable.with(i, 1));
    const Request first = settings_asking({{1, 1}}, 2, 2);
    REQUIRE(said_together(all, first).starts_with("s VERIFIED "));
    for (std::size_t hole = 1; hole + 1 < all.size(); ++hole) {
        std::vector<std::string> files = all;
        files.erase(files.begin() + static_cast<std::ptrdiff_t>(hole));
        REQUIRE(said_together(files).starts_with("s REJECTED code=chain a hole: "));
        REQUIRE(said_together(files, first) == said_together(files));
    }
    CHECK(said_together({one_piece_file(10, 11), one_piece_file(mpq_class(45, 4), mpq_class(45, 4))}) ==
          "s REJECTED code=chain a hole: A ends at 11/1, and B begins at 45/4");
}

TEST_CASE("together: without the first or the last file the claim is about what there is") {
    const Cuttable cuttable(stairs_text);
    const std::string most = cuttable.with(3, 14), least = cuttable.with(0, 14);
    CHECK(said_together({most}).find(" ratio=") != std::string::npos);
    CHECK(said_together({most}) == said_of_one(most));
    const Request asked = settings_asking({{1, 100}}, 10);
    for (const std::string& text : {most, least}) {
        CHECK(said_together({text}, asked)
                  .starts_with("s REJECTED code=claim-not-proved of the mass ratios 1/1:100/1 "));
        CHECK(said_together({text}, asked) == said_of_one(text, asked));
    }
    CHECK(said_together({stairs_text}, settings_asking({{1, 101}}, 10))
              .ends_with(" only 1/1:100/1 are covered"));
    CHECK(said_together({stairs_text}, settings_asking({{101, 102}}))
              .ends_with("nothing is said of the mass ratios 101/1:102/1, only of 1/1:100/1"));
}

TEST_CASE("together: an overlap is refused, and so is the same file twice") {
    const std::string overlap = "s REJECTED code=chain an overlap: ";
    CHECK(said_together({one_piece_file(10, 11), one_piece_file(mpq_class(21, 2), mpq_class(45, 4))}) ==
          overlap + "A ends at 11/1, and B begins at 21/2");
    CHECK(said_together({one_piece_file(mpq_class(21, 2), 11), one_piece_file(10, mpq_class(45, 4))}) ==
          overlap + "B ends at 45/4, and A begins at 21/2");
    CHECK(said_together({stairs_text, stairs_text}).starts_with(overlap));
    const std::string ten = make::ten();
    CHECK(said_together({ten, ten}) ==
          "s VERIFIED scene=dumbbell ratio=10/1:10/1 upper=4 lower=0 gaps=0 open=2");
    CHECK(said_together({one_piece_file(10, 11), ten, ten})
              .starts_with("s VERIFIED scene=dumbbell ratio=10/1:11/1 "));
}

TEST_CASE("together: ends that are 1e-300 apart are a hole or an overlap, and the same ends are neither") {
    const mpq_class end = just_behind(10, 1);
    const std::string first = one_piece_file(10, end);
    CHECK(said_together({first, one_piece_file(end, 11)})
              .starts_with("s VERIFIED scene=dumbbell ratio=10/1:11/1 "));
    CHECK(said_together({first, one_piece_file(just_behind(10, 2), 11)})
              .starts_with("s REJECTED code=chain a hole: A ends at "));
    CHECK(said_together({first, one_piece_file(10, 11)}).starts_with("s REJECTED code=chain an overlap: "));
    CHECK(said_together({one_piece_file(10, just_behind(10, 2)), one_piece_file(end, 11)})
              .starts_with("s REJECTED code=chain an overlap: A ends at "));
    const auto up_to = [&](const mpq_class& hi) {
        return said_together({first, one_piece_file(end, 11)}, settings_asking({{10, hi}}, 4));
    };
    CHECK(up_to(11).starts_with("s VERIFIED "));
    CHECK(up_to(just_behind(11, 1)).starts_with("s REJECTED code=claim-not-proved of the mass ratios "));
    CHECK(said_together({first, one_piece_file(end, 11)}, settings_asking({{just_behind(10, -1), 11}}, 4))
              .starts_with("s REJECTED code=claim-not-proved of the mass ratios "));
}

TEST_CASE("together: one false piece rejects all, whatever the cut, and the file and its line are named") {
    std::mt19937 random(3);
    const Cuttable honest(stairs_text);
    int gaps = 0;
    for (std::size_t i = 0; i < honest.pieces.size(); ++i) {
        const auto value = [&](const std::string& word) {
            const std::size_t at = honest.pieces[i].find("\n" + word + " ") + word.size() + 2;
            return honest.pieces[i].substr(at, honest.pieces[i].find('\n', at) - at);
        };
        const std::string upper = value("upper"), lower = value("lower");
        if (upper == lower) continue;
        ++gaps;
        for (const auto& [from, to] : {std::pair("\nupper " + upper, "\nupper " + lower),
                                       std::pair("\nlower " + lower, "\nlower " + upper)}) {
            Cuttable wrong = honest;
            wrong.pieces[i] = replaced(wrong.pieces[i], from, to);
            const std::string whole = said_of_one(wrong.with(0, wrong.pieces.size()));
            REQUIRE(whole.find(" not certified: ") != std::string::npos);
            for (int cuts = 0; cuts < 4; ++cuts) {
                const std::string line = said_together(wrong.at_random(random), settings_asking({{1, 1}}));
                INFO(line);
                REQUIRE(line.starts_with(whole.substr(0, whole.find(" not certified: "))));
                REQUIRE(line.find(": line ") != std::string::npos);
                REQUIRE(line.ends_with(whole.substr(whole.find(" not certified: "))));
            }
        }
    }
    CHECK(gaps == 8);
}

TEST_CASE("together: an open piece leaves no upper bound, and proves none") {
    const auto open = [](const std::string& a, const std::string& b) {
        return closed(header(a, b, 1) + "piece " + a + " " + b + "\nbits 53\nupper none\nlower 0\n");
    };
    const std::string known = one_piece_file(10, 11), unknown = open("11/1", "12/1");
    CHECK(said_together({known, unknown}) ==
          "s OPEN scene=dumbbell ratio=10/1:12/1 upper=none lower=0 gaps=0 open=2 widest-gap=2.00e-1");
    CHECK(said_together({known, unknown}, settings_asking({{10, 11}})).starts_with("s VERIFIED "));
    CHECK(said_together({known, unknown}, settings_asking({{11, 11}})).starts_with("s VERIFIED "));
    CHECK(said_together({known, unknown}, settings_asking({{10, 11}}, 4)).starts_with("s VERIFIED "));
    for (const mpq_class& hi : {just_behind(11, 1), mpq_class(12)})
        CHECK(said_together({unknown, known}, settings_asking({{10, hi}}, 1000))
                  .starts_with(
                      "s REJECTED code=claim-not-proved not proved: at most 1000 collisions for every "));
    CHECK(said_together({known, unknown}, settings_asking({}, 1000))
              .starts_with("s REJECTED code=claim-not-proved "));
    // At an end that two files share, either may prove it.
    CHECK(said_together({open("9/1", "10/1"), known}, settings_asking({{10, 11}}, 4))
              .starts_with("s VERIFIED "));
    CHECK(said_together({open("10/1", "10/1"), known}, settings_asking({{10, 11}}, 4))
              .starts_with("s VERIFIED "));
    CHECK(said_together({open("9/1", "10/1"), known}, settings_asking({{just_behind(10, -1), 11}}, 4))
              .starts_with("s REJECTED "));
}

TEST_CASE("together: what none of the files proves by itself is not proved by all") {
    const std::string low = one_piece_file(10, 11), high = one_piece_file(11, mpq_class(45, 4));
    CHECK(said_together({low, high}, settings_asking({}, 4)).starts_with("s VERIFIED "));
    CHECK(said_together({low, high}, settings_asking({}, 3)) ==
          "s REJECTED code=claim-not-proved not proved: at most 3 collisions for every mass ratio in "
          "10/1:45/4");
    CHECK(said_together({low, high}, settings_asking({}, {}, 1)) ==
          "s REJECTED code=claim-not-proved not proved: at least 1 collisions for every mass ratio in "
          "10/1:45/4");
}

TEST_CASE("together: the worst file decides, and says why") {
    const std::string good = one_piece_file(10, 11), bad = replaced(good, "upper 4", "upper 3"),
                      foreign = make::mutated(good, "lemmas 1", "lemmas 9"),
                      heavy = make::mutated(good, "bits 53", "bits 3000");
    CHECK(said_together({good, foreign}) == "s UNSUPPORTED B: line 3: unknown lemmas 9");
    CHECK(said_together({foreign, heavy, good}).starts_with("s LIMIT B: line 10: see --max-bits"));
    CHECK(said_together({foreign, heavy, bad})
              .starts_with("s REJECTED code=count C: line 13: not certified: "));
    CHECK(said_together({good, ""})
              .starts_with("s REJECTED code=truncated B: line 1: the text ends too early"));
    const std::string coin = make::contents(make::shipped("coin.dbc"));
    CHECK(said_together({coin}).starts_with("s VERIFIED scene=body "));
    CHECK(said_together({stairs_text, coin})
              .starts_with(
                  "s REJECTED code=chain several scenes: A is about the scene dumbbell, B is about the "
                  "scene body"));
    const std::string line = said_together({stairs_text, coin}, settings_asking({}, 20));
    CHECK(line.starts_with("s REJECTED code=claim-not-proved B: line "));
    CHECK(line.ends_with(": the scene is body, and dumbbell was demanded (--scene)"));
}

TEST_CASE("together: files about something else are refused before they are read") {
    const std::string other =
        ": --together is about ranges of mass ratios, and this file is about something else";
    CHECK(said_together({make::falling()}) == "s UNREADABLE A: line 6" + other);
    CHECK(said_together({stairs_text, make::falling()}) == "s UNREADABLE B: line 6" + other);
    CHECK(said_together({stairs_text, make::contents(make::shipped("law.dbc.gz"))}).ends_with(other));
    Request law;
    law.claim = "law";
    CHECK(said_together({stairs_text}, law).find("the claim is collisions, and law was demanded (--claim)") !=
          std::string::npos);
}

TEST_CASE("together: the heavy mass is said to touch once only if each file proves it") {
    const std::string full = make::contents(make::shipped("full-100.dbc.gz"));
    CHECK(said_together({full}).ends_with(" heavy-at-most=1"));
    CHECK(said_together({full, full}).ends_with(" heavy-at-most=1"));
    CHECK(said_together({stairs_text, full}) == said_of_one(stairs_text));
}
