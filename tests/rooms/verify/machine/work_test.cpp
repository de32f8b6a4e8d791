// The bound of the work on a leaf: what format.md promises to accept is within it, and what is beyond ends.
#include <algorithm>
#include <atomic>

#include "catch.hpp"
#include "verify/core/big.hpp"
#include "verify/core/ray.hpp"
#include "verify/core/reader.hpp"
#include "verify/machine/meter.hpp"

using namespace dumbbell_verify;

namespace {

/// Follows a ray at q = 10^12 for this number of collisions, of hundreds of thousands. False: it has more.
template <class N>
bool follow(std::uint64_t collisions) {
    const N r = bound(down, mpq_class(1, 1'000'000'000'000), N(0));
    return Rays<N>(nullptr).at_most("", {N(0), r, r}, collisions);
}
template <class N>
double per_collision(std::uint64_t collisions) {
    Meter::begin();
    CHECK_FALSE(follow<N>(collisions));
    return static_cast<double>(Meter::done()) / static_cast<double>(collisions);
}

/// A leaf that does so much work.
struct Task {
    std::uint64_t line, units;
    bool fails = false;
};
std::optional<Failure> perform(const Task& task) {
    return judge(task.line, "task", [&] {
        constexpr std::uint64_t step = 1'000'000;
        for (std::uint64_t done = 0; done < task.units; done += step) Meter::spend(step);
        return task.fails ? "that it holds" : nullptr;
    });
}
/// The line and verdict of what comes of these leaves; line 0: all are taken.
std::pair<std::uint64_t, Verdict> done_and_verdict(const std::vector<Task>& tasks, unsigned jobs,
                                                   std::uint64_t units) try {
    Budget budget(units);
    judge_all(tasks, jobs, budget, perform);
    return {0, Verdict::verified};
} catch (const Failure& failure) {
    return {failure.line, failure.verdict};
}

}  // namespace

TEST_CASE("the collisions of format.md, section 4, are within a budget of 100 s") {
    const double most = static_cast<double>(100 * units_per_second);
    CHECK(1e8 * per_collision<double>(1000) < most);
    for (const unsigned bits : {53U, 64U, 96U, 128U, 160U, 200U, 256U, 400U, 512U, 1000U, 2048U, 4096U}) {
        Big::precision = bits;
        const double promised = std::min(1e6, 0x1p34 / bits / bits);
        INFO(bits << " bits, " << promised << " collisions");
        CHECK(promised * per_collision<Big>(bits < 1000 ? 200 : 20) < most);
    }
}

TEST_CASE("a leaf's share ends rays, in double and in multiple precision") {
    const auto ends = [](const auto& work) {
        Shares shares(1, 50'000'000);
        Meter::begin(&shares);
        CHECK_THROWS_AS(work(), std::length_error);
        const std::uint64_t done = Meter::done();
        Meter::begin();
        return done;
    };
    CHECK(ends([] { (void)follow<double>(19'000); }) < 80'000'000);
    Big::precision = 128;
    CHECK(ends([] { (void)follow<Big>(19'000); }) < 80'000'000);
    CHECK_FALSE(follow<Big>(10));  // without a share there is no end
}

TEST_CASE("the leaf at which a budget ends is the same with any number of threads") {
    std::vector<Task> tasks;
    for (std::uint64_t line = 1; line <= 60; ++line) tasks.push_back({line, 20'000'000 * (line % 7)});
    std::uint64_t done = 0, end = 0;
    for (const Task& task : tasks) {
        Meter::begin();
        done += Meter::done() + task.units;
        if (end == 0 && done > 900'000'000) end = task.line;
    }
    REQUIRE((end > 10 && end < 50));
    for (const unsigned jobs : {1U, 2U, 7U}) {
        CHECK(done_and_verdict(tasks, jobs, 900'000'000) == std::pair(end, Verdict::limit));
        CHECK(done_and_verdict(tasks, jobs, done) == std::pair(std::uint64_t{0}, Verdict::verified));
        CHECK(done_and_verdict(tasks, jobs, done - 1) == std::pair(std::uint64_t{60}, Verdict::limit));
        CHECK(done_and_verdict(tasks, jobs, 0) == std::pair(std::uint64_t{1}, Verdict::limit));
        // A failure before it is told, one after it is not.
        std::vector<Task> failing = tasks;
        failing[end - 2].fails = failing[end].fails = true;
        CHECK(done_and_verdict(failing, jobs, 900'000'000) == std::pair(end - 1, Verdict::rejected));
        failing[end - 2].fails = false;
        CHECK(done_and_verdict(failing, jobs, 900'000'000) == std::pair(end, Verdict::limit));
    }
}

TEST_CASE("leaves after a failure are not judged, those before it are") {
    std::vector<Task> leaves;
    for (std::uint64_t i = 0; i < 500; ++i) leaves.push_back({i, 0});
    for (const unsigned jobs : {1U, 4U}) {
        std::vector<std::atomic<bool>> judged(leaves.size());
        const auto judge_one = [&](const Task& task) -> std::optional<Failure> {
            judged[task.line] = true;
            if (task.line == 200 || task.line == 220) return Failure{Verdict::limit, task.line, "", ""};
            return std::nullopt;
        };
        try {
            Budget budget(default_budget);
            judge_all(leaves, jobs, budget, judge_one);
            FAIL("no failure");
        } catch (const Failure& failure) {
            CHECK(failure.line == 200);
        }
        CHECK(
            std::all_of(judged.begin(), judged.begin() + 201, [](const auto& done) { return done.load(); }));
        if (jobs == 1)
            CHECK(std::none_of(judged.begin() + 201, judged.end(), [](const auto& d) { return d.load(); }));
    }
}
