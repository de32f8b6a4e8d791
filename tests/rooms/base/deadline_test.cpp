#include "base/deadline.hpp"

#include <csignal>
#include <thread>

#include "catch.hpp"

using namespace dumbbell;

TEST_CASE("a budget begins when it is given, and ends") {
    CHECK(deadline(std::chrono::duration<double>(0))());
    const auto soon = deadline(std::chrono::duration<double>(0.02));
    CHECK_FALSE(deadline(std::chrono::duration<double>(3600))());
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    CHECK(soon());
}

TEST_CASE("no budget, and one longer than the clock can count, never end") {
    CHECK_FALSE(deadline(std::nullopt)());
    CHECK_FALSE(deadline(std::chrono::duration<double>(1e300))());
}

TEST_CASE("a signal ends every budget") {
    const auto endless = deadline(std::nullopt);
    const auto long_one = deadline(std::chrono::duration<double>(3600));
    stop_signal = SIGINT;
    CHECK(endless());
    CHECK(long_one());
    stop_signal = 0;
    CHECK_FALSE(endless());
}
