#include "critical/table.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "file/atomic_file.hpp"
#include "programs/cli/process.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::critical;
using namespace dumbbell_test;

namespace {

/// The table of q_c(first), ..., q_c(last), as `critical` writes it.
std::string table(long first, long last, int digits) {
    Report report;
    report.request.first = first;
    report.request.last = last;
    report.request.digits = digits;
    report.rows = enclose_ratios(report.request);
    return to_tsv(report);
}

const std::string good = table(3, 5, 7);

Report read_text(const std::string& text) {
    const TemporaryFolder folder;
    write_file(folder / "ratios.tsv", text);
    return read_table(folder / "ratios.tsv");
}

}  // namespace

TEST_CASE("a table of critical ratios is read, plain or compressed, and is certain") {
    const TemporaryFolder folder;
    AtomicFile(folder / "ratios.tsv.gz").commit(good);
    CHECK(is_table(folder / "ratios.tsv.gz"));
    for (const Report& read : {read_text(good), read_table(folder / "ratios.tsv.gz")}) {
        CHECK(read.request.first == 3);
        CHECK(read.request.last == 5);
        CHECK(read.request.digits == 7);
        REQUIRE(read.rows.size() == 3);
        CHECK(read.rows[1].n == 4);
        CHECK(read.rows[1].ratio->q_lo == parse_rational("4.603338"));
        CHECK(read.rows[1].ratio->q_hi > parse_rational("4.60333884"));
        CHECK(to_tsv(read) == good);
        CHECK(objection(read, never).empty());
    }
}

TEST_CASE("tables of any digits are read and are certain, as they are written") {
    for (const int digits : {1, 2, 3, 15, 60}) {
        for (const long first : scaled(1) < 20 ? std::vector{3L, 40L} : std::vector{3L, 40L, 900L}) {
            CAPTURE(digits, first);
            const Report read = read_text(table(first, first + 9, digits));
            CHECK(read.request.digits == digits);
            CHECK(objection(read, never).empty());
        }
    }
    const Report long_ones = read_text(table(20'000, scaled(1) < 20 ? 20'001 : 20'002, 15));
    CHECK(objection(long_ones, never).empty());
}

TEST_CASE("what is open in a table is read as that, and a table of q_c(3) alone does not tell its digits") {
    Report report;
    report.request.digits = 7;
    report.rows = {{6, {}}, {7, {}}};
    const Report read = read_text(to_tsv(report));
    CHECK_FALSE(read.rows[0].ratio);
    CHECK(read.request.digits == 0);
    CHECK(objection(read, never).empty());
    CHECK(read_text(table(3, 3, 7)).request.digits == 0);
}

TEST_CASE("a number that is not certain is objected to") {
    const auto objected = [](const std::string& from, const std::string& to) {
        return objection(read_text(replaced(good, from, to)), never);
    };
    CHECK(objected("4\t4.603338\t", "4\t4.603337\t") == "q_c(4) is not certain to lie where it says");
    CHECK(objected("4\t4.603338\t", "4\t4.603339\t") == "q_c(4) is not certain to lie where it says");
    CHECK(objected("4\t4.603338\t8.5e-7", "4\t4.603338\t8.4e-7") ==
          "q_c(4) is not certain to lie where it says");
    CHECK(objected("4\t4.603338\t8.5e-7", "4\t4.603338\t0").starts_with("q_c(4)"));
    CHECK(objected("4\t4.603338\t8.5e-7", "4\t4.603338\t9.0e-7").empty());  // true, if less than known
    CHECK_FALSE(objection(read_text(good), [] { return true; }).empty());
}

TEST_CASE("anything else is no table of critical ratios") {
    const TemporaryFolder folder;
    for (const char* text : {"", "3\t1\t0\t256\ttop\t1\n", "dumbbell-certificate 1\n", "# Critical"}) {
        write_file(folder / "file", text);
        CHECK(!is_table(folder / "file"));
    }
    CHECK(!is_table(folder / "missing"));
    CHECK(!is_table(folder.path()));
}

TEST_CASE("a table that `critical` would not write so is refused with its line") {
    const auto four = good.find("\n4\t") + 1, five = good.find("\n5\t") + 1;
    const std::string row = good.substr(four, five - four);
    const auto fields = [&](const std::string& changed) { return replaced(good, row, changed); };
    for (const std::string wrong : {"4\tx\t8.5e-7\t128\tcorner\t1\n",
                                    "4\t4.603338\t\t128\tcorner\t1\n",
                                    "4\t4.603338\t8.5e-7\t128\tmiddle\t1\n",
                                    "-4\t4.603338\t8.5e-7\t128\tcorner\t1\n",
                                    "4\t4.603338\t8.5e-7\t128\tcorner\n",
                                    "4\t4.603338\t8.5e-7\t128\tcorner\t2\n",
                                    "04\t4.603338\t8.5e-7\t128\tcorner\t1\n",
                                    "4\t4.6033388\t8.9e-8\t128\tcorner\t1\n",
                                    "4\t04.60333\t8.9e-6\t128\tcorner\t1\n",
                                    "4\t46/10\t8.5e-7\t128\tcorner\t1\n",
                                    "4\t10/3\t8.5e-7\t128\tcorner\t1\n",
                                    "4\t0\t8.5e-7\t128\tcorner\t1\n",
                                    "4\t0e5\t8.5e-7\t128\tcorner\t1\n",
                                    "4\t4.603338\t1e-6\t128\tcorner\t1\n",
                                    "4\t4.603338\t7\t128\tcorner\t1\n",
                                    "4\t4.603338\t8.5e-7\t52\tcorner\t1\n",
                                    "4\t4.603338\t8.5e-7\t16385\tcorner\t1\n",
                                    "4\t4.603338\t8.5e-7\t128\tcorner\t1 \n",
                                    "# remark\n",
                                    "5\topen\t-\t-\ttop\t2\n",
                                    "4\topen\t-\t128\tcorner\t1\n"}) {
        CAPTURE(wrong);
        CHECK_THROWS_WITH(read_text(fields(wrong)),
                          Contains("ratios.tsv") && (Contains("(line 5)") || Contains("(line 6)")));
    }
    CHECK_THROWS_WITH(read_text(replaced(good, "3\t1\t0\t", "3\t1\t0.5\t")), Contains("(line 4)"));
    CHECK_THROWS_WITH(read_text(replaced(good, "Every digit", "No digit")), Contains("(line 1)"));
    CHECK_THROWS_WITH(read_text(good + "\n"), Contains("(line 7)"));
    CHECK_THROWS_WITH(read_text(good.substr(0, good.size() - 1)), Contains("(line 6)"));
    CHECK_THROWS_AS(read_text(good.substr(0, good.find("3\t"))), InputError);
}
