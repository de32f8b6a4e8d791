#include "number/parallel.hpp"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "catch.hpp"
#include "number/big_interval.hpp"

using namespace dumbbell;

namespace {

void wait_for(const std::atomic<bool>& event) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    while (!event && std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

/// How many of `count` parts are done, one by one.
std::size_t done_of(std::size_t count) {
    std::atomic<std::size_t> done = 0;
    in_parallel(count, [&](std::size_t) { ++done; });
    return done;
}

}  // namespace

TEST_CASE("each index is worked on once, at the caller's precision") {
    const PrecisionScope scope(200);
    std::vector<int> times(1000);
    std::atomic<bool> precise = true;
    (void)with_threads(8, [&] {
        in_parallel(times.size(), 7, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i != end; ++i) {
                ++times[i];
            }
            if (PrecisionScope::current() != 200) {
                precise = false;
            }
        });
        return true;
    });
    CHECK(times == std::vector<int>(times.size(), 1));
    CHECK(precise);
}

TEST_CASE("a loop within a loop is done whole when another part of the outer one throws") {
    std::atomic<bool> begun = false;
    std::atomic<bool> thrown = false;
    std::atomic<std::size_t> done = 0;
    const auto work = [&](std::size_t i) {
        if (i == 0) {
            wait_for(begun);
            thrown = true;
            throw std::runtime_error("of the outer loop");
        }
        begun = true;
        wait_for(thrown);
        std::this_thread::sleep_for(std::chrono::milliseconds(50));  // until it has been caught
        done = done_of(100);
    };
    const auto outer = [&] {
        in_parallel(2, work);
        return true;
    };
    CHECK_THROWS_WITH(with_threads(2, outer), "of the outer loop");
    CHECK((!begun || done == 100));  // not begun where there is but one thread
}

TEST_CASE("what a part throws is thrown, and nothing counts as done") {
    CHECK_THROWS_WITH(in_parallel(10, [](std::size_t) { throw std::runtime_error("no"); }), "no");
    CHECK(done_of(0) == 0);
    CHECK(done_of(10) == 10);
}
