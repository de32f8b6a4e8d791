#include "staircase/critical_table.hpp"

#include <catch2/catch.hpp>

#include "base/error.hpp"
#include "file/atomic_file.hpp"
#include "programs/cli/process.hpp"
#include "staircase/critical_report.hpp"

using namespace dumbbell;
using namespace dumbbell::staircase;
using namespace dumbbell_test;
using Catch::Matchers::Contains;

namespace {

const std::string good =
    "# Critical mass ratios q_c(N), where the maximum steps\n# N\tq_c\tradius\tbits\torbit\tflight\n"
    "3\t1\t0\t256\ttop\t1\n4\t4.603338\t3.3e-7\t256\tcorner\t1\n";

CriticalTable read_text(const std::string& text) {
    const TemporaryFolder folder;
    write_file(folder / "ratios.tsv", text);
    CHECK(is_critical_table(folder / "ratios.tsv"));
    return read_critical_table(folder / "ratios.tsv");
}

}  // namespace

TEST_CASE("a table of critical ratios is read, plain or compressed") {
    const CriticalTable table = read_text(good);
    REQUIRE(table.rows.size() == 2);
    CHECK(table.rows[1].n == 4);
    CHECK(table.rows[1].q_c == "4.603338");
    CHECK(table.rows[1].radius == "3.3e-7");
    CHECK(table.rows[1].orbit == "corner");
    CHECK(table.digits() == 7);
    const TemporaryFolder folder;
    AtomicFile(folder / "ratios.tsv.gz").commit(good);
    CHECK(is_critical_table(folder / "ratios.tsv.gz"));
    CHECK(read_critical_table(folder / "ratios.tsv.gz").sha256 == table.sha256);
}

TEST_CASE("what `critical` writes begins as a table that is recognised") {
    const TemporaryFolder folder;
    write_file(folder / "ratios.tsv", to_tsv(CriticalReport{}));
    CHECK(is_critical_table(folder / "ratios.tsv"));
}

TEST_CASE("anything else is no table of critical ratios") {
    const TemporaryFolder folder;
    for (const char* text : {"", "3\t1\t0\t256\ttop\t1\n", "dumbbell-certificate 1\n", "# Critical"}) {
        write_file(folder / "file", text);
        CHECK(!is_critical_table(folder / "file"));
    }
    CHECK(!is_critical_table(folder / "missing"));
    CHECK(!is_critical_table(folder.path()));
}

TEST_CASE("a table with a line that is none, cut off or empty is refused with its line") {
    for (const auto& [from, to] :
         std::vector<std::pair<std::string, std::string>>{{"4.603338", "x"},
                                                          {"3.3e-7", ""},
                                                          {"corner", "middle"},
                                                          {"4\t4.6", "-4\t4.6"},
                                                          {"\tcorner\t1", "\tcorner"}}) {
        CAPTURE(to);
        CHECK_THROWS_WITH(read_text(replaced(good, from, to)), Contains("ratios.tsv") && Contains("line 4"));
    }
    CHECK_THROWS_AS(read_text(good.substr(0, good.size() - 1)), InputError);
    CHECK_THROWS_AS(read_text(good.substr(0, good.find("3\t"))), InputError);
}
