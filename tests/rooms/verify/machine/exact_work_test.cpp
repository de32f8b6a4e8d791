// Exact numbers may be long: what it takes to halve boxes of them and to look at their leaves is counted.
#include <functional>

#include "catch.hpp"
#include "rooms/verify/program/run_program.hpp"
#include "rooms/verify/wings/starts/make_file.hpp"
#include "verify/program/verify.hpp"

using namespace dumbbell_verify;

namespace {

std::uint64_t work_of(const std::string& text) { return verify(make::File(text).path(), {}).work; }

/// `split AXIS` down to this depth, in pre-order; each leaf is the line.
std::string tree(const std::string& axis, int depth, const std::string& leaf) {
    return depth == 0 ? leaf + "\n"
                      : "split " + axis + "\n" + tree(axis, depth - 1, leaf) + tree(axis, depth - 1, leaf);
}
/// About 2.01 + n/100, as a fraction with so many digits.
std::string long_ratio(int digits, int n) {
    mpz_class bottom;
    mpz_ui_pow_ui(bottom.get_mpz_t(), 10, static_cast<unsigned>(digits - 2));
    bottom = bottom * 31 + 7;
    mpq_class ratio(bottom * (201 + n) / 100 + 1, bottom);
    ratio.canonicalize();
    return to_string(ratio);
}

/// A box of starts of which nothing is said, halved so often.
std::string open_starts(const std::string& axis, int depth, int digits) {
    const std::string header =
        "dumbbell-certificate 1\ngenerator test 1.0\nlemmas 1\nscene dumbbell\nsection none\n"
        "claim initial-conditions\n";
    return make::closed(
        header + "ratio " + long_ratio(digits, 0) + " " + long_ratio(digits, 4) +
        "\nphi 0/1 1/1\nphidot 1/1 2/1\ny 3/1 4/1\nydot -2/1 -1/1\nbits 53\nbetween 0 none\n" +
        tree(axis, depth, "open"));
}
/// A cover whose upper bound is far too high, so that what is counted is soon done; with leaves on which
/// nothing is.
std::string halved_cover(int depth, int digits) {
    const std::string lo = long_ratio(digits, 0), hi = long_ratio(digits, 4);
    return make::closed(
        make::header(lo, hi, 1) + "piece " + lo + " " + hi +
        "\nbits 53\nupper 100\nchart bridge\nsplit eta\ncount 40 40\nsplit eta\ncount 40 40\n" +
        tree("q", depth, "outside") + "chart light\ncount 40 40\nlower 0\n");
}

}  // namespace

TEST_CASE("halving boxes is counted, and more of long numbers") {
    CHECK(work_of(open_starts("q", 10, 1000)) > 10 * work_of(open_starts("q", 10, 5)));
    CHECK(work_of(halved_cover(10, 1000)) > 3 * work_of(halved_cover(10, 5)));
    CHECK(work_of(open_starts("phi", 10, 1000)) > work_of(open_starts("phi", 10, 5)));
    CHECK(work_of(open_starts("phi", 11, 5)) > 3 * work_of(open_starts("phi", 9, 5)));
}

TEST_CASE("a small file that asks for much arithmetic is given up within the budget") {
    const make::File file(open_starts("q", 12, 1000));
    CHECK(make::run("--budget 0.02s " + file.path()).code == 4);
    CHECK(make::run("--budget 10s " + file.path()).code == 3);
}

TEST_CASE("the memory that --shares takes does not grow with the file without an end") {
    std::string leaves, body = open_starts("phi", 0, 5);
    body = body.substr(0, body.find("open\n"));
    constexpr int depth = 15;
    int next = 1000;
    const std::function<void(int)> grow = [&](int left) {
        leaves += left == 0 ? "between 0 " + std::to_string(next++) + "\n" : "split phi\n";
        if (left > 0) grow(left - 1), grow(left - 1);
    };
    grow(depth);
    const make::File file(make::closed(
        make::replaced(body, "between 0 none", "between 0 " + std::to_string(next - 1)) + leaves));
    const make::Run shares = make::run("--shares " + file.path());
    CHECK(shares.code == 4);
    CHECK(make::has(shares, "--shares of more than 20,000 different numbers of collisions"));
    CHECK(make::run(file.path()).code == 0);
}

TEST_CASE("a tree as deep as there may be is read on any stack") {
    std::string lines;
    for (int i = 0; i < 2000; ++i)
        lines += "split " +
                 std::string(starts::axis_names[static_cast<std::size_t>(i) % starts::axis_names.size()]) +
                 "\n";
    lines += "open\n";
    for (int i = 0; i < 2000; ++i) lines += "open\n";
    std::string body = open_starts("phi", 0, 5);
    body = body.substr(0, body.find("open\n"));
    const make::File file(make::closed(body + lines));
    for (const char* stack : {"64", "128", "256", "8192"})
        for (const char* jobs : {"1", "8"}) {
            CAPTURE(stack, jobs);
            const make::Run run =
                make::run("--jobs " + std::string(jobs) + " " + file.path() + " " + file.path(),
                          "ulimit -s " + std::string(stack) + "; ");
            CHECK(run.code == 3);
            CHECK(make::has(run, " nothing-proved=2 open=0 exit=3\n"));
        }
}
