#include "number/self_test.hpp"

#include <array>
#include <cfenv>
#include <string>
#include <thread>

#include "base/error.hpp"
#include "catch.hpp"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

using namespace dumbbell;

namespace {

/// What the self-test says on a thread of its own after `spoil`: nothing if it passes.
template <class Spoil>
std::string verdict_after(const Spoil& spoil) {
    std::string verdict;
    std::thread([&] {
        spoil();
        try {
            require_sound_arithmetic();
        } catch (const BrokenInvariant& broken) {
            verdict = broken.what();
        }
    }).join();
    return verdict;
}

std::string verdict_in_mode(int mode) {
    return verdict_after([mode] { std::fesetround(mode); });
}

}  // namespace

TEST_CASE("The self-test passes here, and on a new thread") {
    CHECK_NOTHROW(require_sound_arithmetic());
    CHECK(verdict_after([] {}).empty());
}

TEST_CASE("The self-test refuses every other rounding mode, on the thread that has it and there only") {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        CAPTURE(mode);
        CHECK_THAT(verdict_in_mode(mode), Contains("round"));
        CHECK_NOTHROW(require_sound_arithmetic());
        CHECK(verdict_in_mode(FE_TONEAREST).empty());
    }
}

TEST_CASE("A thread inherits its mode from the one that starts it, and is refused with it") {
    std::string inner;
    std::thread([&] {
        std::fesetround(FE_UPWARD);
        inner = verdict_after([] {});
    }).join();
    CHECK_THAT(inner, Contains("round"));
}

TEST_CASE("Threads that were started before and after a mode change elsewhere stay sound") {
    std::array<std::string, 8> verdicts;
    std::array<std::thread, 8> threads;
    for (std::size_t i = 0; i < threads.size(); ++i) {
        threads[i] = std::thread([&verdicts, i] {
            if (i % 2 == 1) {
                std::fesetround(FE_DOWNWARD);
            }
            for (int round = 0; round < 100 && verdicts[i].empty(); ++round) {
                try {
                    require_sound_arithmetic();
                } catch (const BrokenInvariant& broken) {
                    verdicts[i] = broken.what();
                }
            }
        });
    }
    for (std::size_t i = 0; i < threads.size(); ++i) {
        threads[i].join();
        CAPTURE(i);
        CHECK(verdicts[i].empty() == (i % 2 == 0));
    }
}

#if defined(__SSE2__)
TEST_CASE("The self-test refuses flush-to-zero and denormals-are-zero") {
    constexpr unsigned flush_to_zero = 0x8000;
    constexpr unsigned denormals_are_zero = 0x0040;
    for (const unsigned flags : {flush_to_zero, denormals_are_zero, flush_to_zero | denormals_are_zero}) {
        CAPTURE(flags);
        CHECK_THAT(verdict_after([flags] { _mm_setcsr(_mm_getcsr() | flags); }), Contains("subnormal"));
        CHECK_NOTHROW(require_sound_arithmetic());
    }
}

TEST_CASE("The self-test refuses a rounding mode that only the SSE unit has, which fegetround does not see") {
    for (const unsigned mode : {_MM_ROUND_UP, _MM_ROUND_DOWN, _MM_ROUND_TOWARD_ZERO}) {
        CAPTURE(mode);
        CHECK_FALSE(verdict_after([mode] { _MM_SET_ROUNDING_MODE(mode); }).empty());
        CHECK_NOTHROW(require_sound_arithmetic());
    }
}

TEST_CASE("The self-test refuses a rounding mode that only the x87 unit has, which computes long double") {
    CHECK_FALSE(verdict_after([] {
                    std::fesetround(FE_UPWARD);
                    _MM_SET_ROUNDING_MODE(_MM_ROUND_NEAREST);
                }).empty());
    CHECK_NOTHROW(require_sound_arithmetic());
}
#endif
