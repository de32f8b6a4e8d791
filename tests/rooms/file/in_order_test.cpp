#include "file/in_order.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "catch.hpp"

using namespace dumbbell;

namespace {

void nap() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

/// Waits until it holds, but not for ever; whether it does.
template <class Condition>
bool comes_true(const Condition& holds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(5);
    while (!holds() && std::chrono::steady_clock::now() < end) {
        nap();
    }
    return holds();
}

}  // namespace

TEST_CASE("what came of the work is handed on in the order of the work, on any number of threads") {
    for (const int jobs : {1, 2, 8}) {
        std::vector<int> handed;
        int begun = 0;
        in_order(jobs, [&](const Interrupted&) {
            return begun == 1000 ? Work() : [&handed, i = begun++]() -> HandOn {
                if (i % 100 == 0) {
                    nap();
                }
                return [&handed, i] {
                    handed.push_back(i);
                    return true;
                };
            };
        });
        CHECK(handed.size() == 1000);
        CHECK(std::ranges::is_sorted(handed));
    }
}

TEST_CASE("while the first piece takes long, only so many others are begun") {
    std::atomic<std::size_t> begun = 0, greatest = 0;
    in_order(2, [&](const Interrupted&) {
        const std::size_t i = begun;
        if (i == 1000) {
            return Work();
        }
        ++begun;
        return Work([&, i]() -> HandOn {
            if (i == 0) {
                (void)comes_true([&] { return begun == 2 * pieces_ahead; });
                for (int naps = 0; naps < 50; ++naps) {
                    nap();
                }
                greatest = begun.load();
            }
            return [] { return true; };
        });
    });
    CHECK(greatest == 2 * pieces_ahead);
    CHECK(begun == 1000);
}

TEST_CASE("what is done is handed on while the next piece is waited for") {
    std::atomic<int> handed = 0;
    int begun = 0;
    bool in_time = false;
    in_order(2, [&](const Interrupted&) {
        if (begun == 3) {
            in_time = comes_true([&] { return handed == 3; });
            return Work();
        }
        ++begun;
        return Work([&]() -> HandOn { return [&] { return ++handed > 0; }; });
    });
    CHECK(in_time);
}

TEST_CASE("where no more is wanted nothing more is handed on") {
    for (const int jobs : {1, 4}) {
        int begun = 0, handed = 0;
        in_order(jobs, [&](const Interrupted&) {
            return ++begun > 1000 ? Work() : Work([&]() -> HandOn { return [&] { return ++handed < 3; }; });
        });
        CHECK(handed == 3);
        CHECK(begun <= 1000);
    }
}

TEST_CASE("who waits for the next piece learns that no more is wanted") {
    std::atomic<bool> begun = false, waits = false;
    bool learned = false;
    in_order(2, [&](const Interrupted& in_vain) {
        if (begun.exchange(true)) {
            waits = true;
            learned = comes_true(in_vain);
            return Work();
        }
        return Work([&]() -> HandOn {
            (void)comes_true([&] { return waits.load(); });
            return [] { return false; };
        });
    });
    CHECK(learned);
}

TEST_CASE("work that throws ends all, wherever it throws") {
    const auto fail = []() -> bool { throw std::runtime_error("on purpose"); };
    for (const int jobs : {1, 4}) {
        int begun = 0;
        const auto all = [&](const Work& last) {
            begun = 0;
            in_order(jobs, [&](const Interrupted&) {
                return ++begun == 300 ? last : Work([]() -> HandOn { return [] { return true; }; });
            });
        };
        CHECK_THROWS_AS(all([&]() -> HandOn { return fail() ? HandOn() : HandOn(); }), std::runtime_error);
        CHECK_THROWS_AS(all([&]() -> HandOn { return fail; }), std::runtime_error);
        CHECK_THROWS_AS(in_order(jobs, [&](const Interrupted&) { return fail() ? Work() : Work(); }),
                        std::runtime_error);
    }
}
