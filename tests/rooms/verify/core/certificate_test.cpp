// Every rule of format.md, sections 1 to 3, has a file that breaks it and nothing else, here or in
// tests/attacks/false_claims.
#include <random>

#include "catch.hpp"
#include "make_certificate.hpp"
#include "verify/core/text.hpp"
#include "verify/program/verify.hpp"

using namespace dumbbell_verify;
using make::closed;
using make::File;
using make::hashed;
using make::mutated;
using make::replaced;
using make::ten;

namespace {

/// "verified", or the code of the failure, with its line if `with_line`.
std::string outcome_at_line(const std::string& bytes, bool with_line = false) {
    const Failure why = make::failure(bytes);
    return why.code + (with_line ? " " + std::to_string(why.line) : "");
}
std::string ten_with(const std::string& from, const std::string& to, bool with_line = false) {
    return outcome_at_line(mutated(ten(), from, to), with_line);
}

}  // namespace

TEST_CASE("the example is verified, plain and compressed") {
    CHECK(outcome_at_line(ten()) == "verified");
    CHECK(outcome_at_line(make::gzipped(ten())) == "verified");
}

TEST_CASE("truncation at every byte is refused, plain and compressed") {
    const std::string packed = make::gzipped(ten());
    for (std::size_t n = 0; n < ten().size(); ++n) {
        INFO(n);
        REQUIRE(outcome_at_line(ten().substr(0, n)) != "verified");
    }
    for (std::size_t n = 0; n < packed.size(); ++n)
        REQUIRE(outcome_at_line(packed.substr(0, n)) != "verified");
    CHECK(outcome_at_line("") == "truncated");
    CHECK(outcome_at_line(ten().substr(0, ten().size() - 1)) == "truncated");
    CHECK(outcome_at_line(packed.substr(0, packed.size() - 1)) == "gzip");
}

TEST_CASE("a changed byte is refused, wherever it is") {
    for (std::size_t n = 0; n < ten().size(); ++n) {
        std::string text = ten();
        text[n] = text[n] == '1' ? '2' : '1';
        if (text == ten()) continue;
        INFO(n);
        REQUIRE(outcome_at_line(text) != "verified");
    }
}

TEST_CASE("lines mixed up at random, with a correct trailer, end in a verdict and prove nothing new") {
    std::vector<std::string> lines;
    std::istringstream in(closed(make::header("113/10", "113/10", 1) +
                                 make::piece(mpq_class(113, 10), mpq_class(113, 10), 4, 0, "")));
    for (std::string line; std::getline(in, line) && !line.starts_with("total");) lines.push_back(line);
    std::mt19937 random(11);
    const auto some = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    for (int i = 0; i < 3000; ++i) {
        std::vector<std::string> mixed = lines;
        for (std::size_t n = 1 + some(3); n > 0; --n) {
            const std::size_t at = 7 + some(mixed.size() - 7);
            switch (some(4)) {
                case 0:
                    mixed.erase(mixed.begin() + static_cast<std::ptrdiff_t>(at));
                    break;
                case 1:
                    mixed.insert(mixed.begin() + static_cast<std::ptrdiff_t>(at),
                                 mixed[7 + some(mixed.size() - 7)]);
                    break;
                case 2:
                    std::swap(mixed[at], mixed[7 + some(mixed.size() - 7)]);
                    break;
                default:
                    mixed[at][some(mixed[at].size())] = "0123456789b/- "[some(14)];
            }
        }
        std::string body;
        for (const std::string& line : mixed) body += line + "\n";
        const std::string result = outcome_at_line(closed(body));
        INFO(body << result);
        if (result == "verified") {  // a higher bound, or another order of the same leaves
            REQUIRE(body.find("upper 1\n") == std::string::npos);
            REQUIRE(body.find("upper 2\n") == std::string::npos);
            REQUIRE(body.find("upper 3\n") == std::string::npos);
            REQUIRE(body.find("lower 0\n") != std::string::npos);
        }
    }
}

TEST_CASE("bytes: printable ASCII and line feeds only") {
    CHECK(outcome_at_line(replaced(ten(), "lemmas 1\n", "lemmas 1\r\n")) == "encoding");
    CHECK(outcome_at_line(replaced(ten(), "lemmas 1", "lemmas\t1")) == "byte");
    CHECK(outcome_at_line(replaced(ten(), "lemmas 1",
                                   "lemmas\xc2\xa0"
                                   "1")) == "byte");
    CHECK(outcome_at_line(replaced(ten(), "lemmas 1", std::string("lemmas 1\0", 9))) == "byte");
    CHECK(outcome_at_line(std::string(1 << 20, '\0')) == "byte");
    CHECK(outcome_at_line("\x7f") == "byte");
    CHECK(outcome_at_line("\xef\xbb\xbf" + ten()) == "encoding");
    CHECK(outcome_at_line(ten() + "\n") == "trailing");
    CHECK(outcome_at_line(ten() + ten()) == "trailing");
    CHECK(outcome_at_line(ten() + std::string(1, '\0')) == "trailing");
}

TEST_CASE("lines: one space between fields, none elsewhere, none empty, none long") {
    CHECK(ten_with("lemmas 1", "lemmas  1") == "line");
    CHECK(ten_with("lemmas 1", " lemmas 1") == "line");
    CHECK(ten_with("lemmas 1", "lemmas 1 ") == "line");
    CHECK(ten_with("lemmas 1\n", "lemmas 1\n\n") == "line");
    CHECK(ten_with("lemmas 1", "lemmas 1 " + std::string(5000, '1')) == "line");
    CHECK(outcome_at_line(std::string(100'000, 'x')) == "line");
}

TEST_CASE("gzip: one member and nothing after it") {
    const std::string packed = make::gzipped(ten());
    CHECK(outcome_at_line(packed + "x") == "gzip");
    CHECK(outcome_at_line(packed + std::string(10, '\0')) == "gzip");
    CHECK(outcome_at_line(packed + packed) == "gzip");
    CHECK(outcome_at_line(packed + make::gzipped("")) == "gzip");
    CHECK(outcome_at_line(make::gzipped(packed)) == "byte");
    CHECK(outcome_at_line(make::gzipped(ten() + "\n")) == "trailing");
    std::string damaged = packed;
    damaged[damaged.size() - 6] = static_cast<char>(damaged[damaged.size() - 6] ^ 1);  // the CRC
    CHECK(outcome_at_line(damaged) == "gzip");
    CHECK(outcome_at_line("\x1f\x8b") == "gzip");
    std::string leaves;  // more than a block when unpacked
    for (int i = 0; i < 390; ++i) leaves += "split e\nsplit eta\n";
    for (int i = 0; i <= 780; ++i) leaves += "count 1 2\n";
    std::string many;
    for (int i = 0; i < 8; ++i) many += (i < 7 ? "split e\n" : "") + leaves;
    const std::string large = make::gzipped(mutated(ten(), "count 1 2\n", many));
    for (std::size_t size = (1 << 16) - 1; size < (1 << 16) + 12; ++size) {  // wherever a block ends
        std::string commented = large;
        commented[3] = static_cast<char>(commented[3] | 0x10);
        commented.insert(10, std::string(size - large.size() - 1, '.') + '\0');
        INFO(size);
        REQUIRE(commented.size() == size);
        REQUIRE(outcome_at_line(commented) == "verified");
        REQUIRE(outcome_at_line(commented + "x") == "gzip");
    }
    CHECK(outcome_at_line("\x1f") == "byte");
}

TEST_CASE("what this program does not know is unsupported, what is misspelled is rejected", "[wings]") {
    CHECK(ten_with("certificate 1", "certificate 2", true) == "unsupported 1");
    CHECK(ten_with("certificate 1", "certificate 01", true) == "number 1");
    CHECK(ten_with("certificate 1", "certificate one", true) == "number 1");
    CHECK(ten_with("dumbbell-certificate", "Dumbbell-certificate", true) == "syntax 1");
    for (const char* lemmas : {"2", "0", "other", "a-1"})
        CHECK(ten_with("lemmas 1", "lemmas " + std::string(lemmas), true) == "unsupported 3");
    CHECK(ten_with("lemmas 1", "lemmas -1", true) == "word 3");
    CHECK(ten_with("lemmas 1", "lemmas 01", true) == "number 3");
    CHECK(ten_with("scene dumbbell", "scene torus", true) == "unsupported 4");
    CHECK(ten_with("scene dumbbell", "scene Dumbbell", true) == "word 4");
    CHECK(ten_with("scene dumbbell", "scene 7", true) == "word 4");
    CHECK(ten_with("section turning", "section heavy", true) == "unsupported 5");
    CHECK(ten_with("claim collisions", "claim heavy", true) == "unsupported 6");
    CHECK(ten_with("claim collisions", "claim law", true) == "syntax 7");
    CHECK(ten_with("section turning\nclaim collisions", "section full\nclaim law", true) == "unsupported 6");
    CHECK(outcome_at_line(
              mutated(ten(), "section turning\nclaim collisions", "section none\nclaim collisions-by-law"),
              true) == "unsupported 6");  // written before 0.1
    CHECK(ten_with("claim collisions", "claim 7", true) == "word 6");
    CHECK(ten_with("generator test", "generator Test", true) == "word 2");
    CHECK(ten_with("generator test", "generator te~t", true) == "word 2");
    CHECK(ten_with("generator test", "generator " + std::string(33, 'a'), true) == "word 2");
    CHECK(ten_with("generator test 1.0", "generator test", true) == "syntax 2");
    CHECK(ten_with("lemmas 1\nscene dumbbell\n", "scene dumbbell\nlemmas 1\n", true) == "syntax 3");
}

TEST_CASE("ratios have one spelling, and 1 <= LO <= HI") {
    for (const char* bad : {"10", "10/", "/1", "010/1", "10/01", "20/2", "10/0", "0/1", "-10/1", "10/1/1",
                            "1e1/1", "10.0/1", "+10/1"}) {
        INFO(bad);
        CHECK(ten_with("ratio 10/1 10/1", std::string("ratio ") + bad + " 10/1", true) == "number 7");
    }
    CHECK(ten_with("ratio 10/1 10/1", "ratio 1/2 10/1", true) == "number 7");
    CHECK(ten_with("ratio 10/1 10/1", "ratio 11/1 10/1", true) == "number 7");
    CHECK(ten_with("ratio 10/1 10/1", "ratio " + std::string(2101, '9') + "/1 10/1", true) == "number 7");
    CHECK(ten_with("ratio 10/1 10/1", "ratio 10/1", true) == "syntax 7");
}

TEST_CASE("numbers have one spelling, counts at most 2100 digits and others 18") {
    for (const std::string& bad :
         std::vector<std::string>{"01", "-1", "+1", "1.0", "x", "0x1", "1" + std::string(2100, '0')}) {
        INFO(bad);
        CHECK(ten_with("upper 4", "upper " + bad, true) == "number 11");
    }
    CHECK(ten_with("pieces 1", "pieces 0", true) == "number 8");
    CHECK(ten_with("pieces 1", "pieces 1000000000000000000", true) == "number 8");
    CHECK(ten_with("pieces 1", "pieces 2") == "syntax");
}

TEST_CASE("a piece has bits, an upper bound or none, a cover, a lower bound not above it") {
    CHECK(ten_with("bits 53", "bits 52") == "number");
    CHECK(ten_with("bits 53", "bits 4097") == "number");
    CHECK(ten_with("bits 53", "bits 2049") == "limit");
    CHECK(ten_with("bits 53", "bits 200") == "verified");
    CHECK(ten_with("bits 53\n", "") == "syntax");
    CHECK(ten_with("upper 4", "upper some") == "number");
    CHECK(ten_with("upper 4", "upper none") == "syntax");  // a cover where none may be
    CHECK(ten_with("lower 0", "lower 5") == "number");
    CHECK(ten_with("lower 0", "lower 1") == "syntax");  // no witness
    CHECK(ten_with("lower 0\n", "lower 0\nwitness bridge 1b-1 1b-1 0 0\n") == "syntax");
    CHECK(ten_with("chart bridge", "chart light") == "syntax");
    CHECK(ten_with("chart bridge\ncount 1 2\n", "") == "syntax");
    CHECK(ten_with("chart light", "chart light light") == "syntax");
}

TEST_CASE("tree lines: known opcodes of the chart, axes of the chart, all hints, whole trees") {
    CHECK(ten_with("count 1 2", "meets") == "opcode");
    CHECK(ten_with("count 1 2", "meets-reversed") == "opcode");
    CHECK(ten_with("count 1 2", "equal-masses") == "opcode");
    CHECK(ten_with("count 1 2", "witness 1 2") == "opcode");
    CHECK(ten_with("count 1 2", "trust me") == "opcode");
    CHECK(ten_with("count 1 2", "count 1") == "syntax");
    CHECK(ten_with("count 1 2", "count 1 2 3") == "syntax");
    CHECK(ten_with("count 1 2", "count 1 -2") == "number");
    CHECK(ten_with("count 1 2", "split lambda\ncount 1 2\ncount 1 2") == "syntax");
    CHECK(ten_with("count 1 2", "split e e\ncount 1 2\ncount 1 2") == "syntax");
    CHECK(ten_with("count 1 2", "split\ncount 1 2\ncount 1 2") == "syntax");
    CHECK(ten_with("count 1 2", "split e\ncount 1 2\ncount 1 2") == "verified");
    CHECK(ten_with("count 1 2", "split q\ncount 1 2\ncount 1 2") == "split");  // of width 0
}

TEST_CASE("400 splits of one axis may lie above a node, 401 not") {
    const auto chain = [](int n) {
        std::string tree;
        for (int i = 0; i < n; ++i) tree += "split e\n";
        tree += "count 1 2";
        for (int i = 0; i < n; ++i) tree += "\ncount 1 2";
        return mutated(ten(), "count 1 2", tree);
    };
    CHECK(outcome_at_line(chain(400)) == "verified");
    CHECK(outcome_at_line(chain(401)) == "depth");
    const std::string bushy = chain(250), tree = bushy.substr(bushy.find("split e"), 250 * 18 + 10);
    CHECK(ten_with("count 1 2\n", "split e\n" + tree + tree) == "verified");
    std::string all;
    for (int i = 0; i < 400; ++i) all += "split e\nsplit eta\n";
    std::string leaves = "count 1 2";
    for (int i = 0; i < 800; ++i) leaves += "\ncount 1 2";
    CHECK(ten_with("count 1 2", all + leaves) == "verified");
    std::string endless;
    for (int i = 0; i < 1'000'000; ++i) endless += "split e\n";
    CHECK(outcome_at_line(make::header("10/1", "10/1", 1) +
                          "piece 10/1 10/1\nbits 53\nupper 4\nchart bridge\n" + endless) == "depth");
}

TEST_CASE("dyadics have one spelling") {
    const std::string text = mutated(ten(), "lower 0\n", "lower 1\nwitness bridge 1b-1 1b-1 0 0\n");
    CHECK(outcome_at_line(text) == "verified");
    for (const char* bad :
         {"2b-2", "1b-01", "01b-1", "1b-0", "1", "b1", "1b", "-1b-1", "1b--1", "1b+1", "1b4097", "1b-4097",
          "1b9999", "1b-9999", "1b-00001", "1b1b1", "0b1", "0b-1", "0.5"}) {
        INFO(bad);
        CHECK(outcome_at_line(mutated(text, "1b-1 1b-1", std::string(bad) + " 1b-1")) == "number");
    }
    CHECK(outcome_at_line(mutated(text, "1b-1 1b-1", "1b-1 " + std::string(1251, '1') + "b-4096")) ==
          "number");
    CHECK(outcome_at_line(mutated(text, "1b-1 1b-1", "1b-1 " + std::string(1250, '1') + "b-4096")) ==
          "witness");  // eta > q
    CHECK(outcome_at_line(mutated(text, "1b-1 1b-1", "1b-1 1b4096")) == "witness");
    const std::string longest = mpz_class((mpz_class(1) << 4095) + 1).get_str() + "b-4096";  // besides 1/2
    CHECK(outcome_at_line(mutated(text, "1b-1 1b-1", longest + " " + longest)) == "verified");
    // eta > 0 is beyond doubles, not beyond MPFR.
    CHECK(outcome_at_line(mutated(text, "1b-1 1b-1", "1b-1 1b-4096")) == "verified");
    CHECK(outcome_at_line(mutated(text, "witness bridge", "witness light")) == "syntax");
    CHECK(outcome_at_line(mutated(text, "witness bridge 1b-1 1b-1 0 0", "witness bridge 1b-1 1b-1 0")) ==
          "syntax");
}

TEST_CASE("totals and SHA-256 must be there and right") {
    const std::string body = ten().substr(0, ten().find("total split"));
    CHECK(outcome_at_line(body) == "truncated");
    CHECK(outcome_at_line(hashed(body)) == "syntax");
    const std::string all = ten().substr(0, ten().find("sha256 "));
    for (const auto& [from, to, code] : {std::tuple{"total count 2", "total count 3", "total"},
                                         {"total count 2", "total count 02", "number"},
                                         {"total outside 0\n", "", "total"},
                                         {"total outside", "total inside", "total"}})
        CHECK(outcome_at_line(hashed(replaced(all, from, to))) == code);
    CHECK(outcome_at_line(all + "sha256 " + std::string(64, '0') + "\n") == "sha256");
    std::string capital = ten();
    for (std::size_t i = capital.size() - 65; i < capital.size(); ++i)
        if (capital[i] >= 'a') capital[i] = static_cast<char>(capital[i] - 32);
    CHECK(outcome_at_line(capital) == "sha256");
}

TEST_CASE("the first failing line of the file is reported, whatever the threads do") {
    std::string leaves;
    for (int i = 0; i < 60; ++i) leaves += "split e\n";
    for (int i = 0; i < 61; ++i) leaves += i == 20 || i == 40 ? "outside\n" : "count 1 2\n";
    std::string text = mutated(ten(), "count 1 2\n", leaves);
    for (const unsigned jobs : {1U, 2U, 8U}) {
        for (const bool cut : {false, true}) {  // a later syntax error does not hide the leaf
            const File file(cut ? text.substr(0, text.size() - 100) : text);
            Request settings;
            settings.jobs = jobs;
            try {
                verify(file.path(), settings);
                FAIL("verified");
            } catch (const Failure& failure) {
                CHECK(failure.line == 13 + 60 + 20);
                CHECK(failure.code == "outside");
            }
        }
    }
}
