// Exact numbers may be long: what it takes to halve boxes of them and to look at their leaves is counted.
#include <time.h>

#include <functional>

#include "catch.hpp"
#include "make_initial.hpp"
#include "run_program.hpp"
#include "verify/program/verify.hpp"

using namespace dumbbell_verify;

namespace {

/// Seconds of this thread.
double used() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Seconds for each second that is counted, of a file that is verified.
double used_for_counted(const std::string& text, const Settings& settings = {}) {
    const make::File file(text);
    const double start = used();
    std::uint64_t work = 0;
    int times = 0;
    for (; used() - start < 0.2; ++times) work += verify(file.path(), settings).work;
    return (used() - start) * static_cast<double>(units_per_second) / static_cast<double>(work);
}

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
    return make::closed_initial(
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

TEST_CASE("a second that is counted is about as long whatever is done in it") {
    const std::string wide =
        make::closed(make::header("1000000/1", "1000000/1", 1) +
                     "piece 1000000/1 1000000/1\nbits 53\nupper 2000\nchart bridge\ncount 900 900\n"
                     "chart light\ncount 900 900\nlower 0\n");
    const double usual = used_for_counted(wide);
    for (const int digits : {5, 100, 1000}) {
        CAPTURE(digits);
        CHECK(used_for_counted(open_starts("q", 10, digits)) < 3 * usual);
        CHECK(used_for_counted(open_starts("phi", 10, digits)) < 3 * usual);
        CHECK(used_for_counted(halved_cover(10, digits)) < 3 * usual);
    }
    Settings with_shares;
    with_shares.shares = true;
    CHECK(used_for_counted(open_starts("y", 10, 5), with_shares) < 3 * usual);
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
    const make::File file(make::closed_initial(
        make::replaced(body, "between 0 none", "between 0 " + std::to_string(next - 1)) + leaves));
    const make::Run shares = make::run("--shares " + file.path());
    CHECK(shares.code == 4);
    CHECK(make::has(shares, "--shares of more than 20,000 different numbers of collisions"));
    CHECK(make::run(file.path()).code == 0);
}

TEST_CASE("a tree as deep as there may be is read on any stack") {
    std::string lines;
    for (int i = 0; i < 2000; ++i)
        lines +=
            "split " + std::string(initial_axes[static_cast<std::size_t>(i) % initial_axes.size()]) + "\n";
    lines += "open\n";
    for (int i = 0; i < 2000; ++i) lines += "open\n";
    std::string body = open_starts("phi", 0, 5);
    body = body.substr(0, body.find("open\n"));
    const make::File file(make::closed_initial(body + lines));
    for (const char* stack : {"64", "128", "256", "8192"})
        for (const char* jobs : {"1", "8"}) {
            CAPTURE(stack, jobs);
            const make::Run run =
                make::run("--jobs " + std::string(jobs) + " " + file.path() + " " + file.path(),
                          "ulimit -s " + std::string(stack) + "; ");
            CHECK(run.code == 3);
            CHECK(make::has(run, " open=2 exit=3\n"));
        }
}
