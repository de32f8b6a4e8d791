// Threads that are started before, during and after a change of mode elsewhere.
#include <flint/flint.h>

#include <array>
#include <barrier>
#include <bit>
#include <cfenv>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

#include "base/error.hpp"
#include "catch.hpp"
#include "number/big_interval.hpp"
#include "number/elementary.hpp"
#include "number/self_test.hpp"
#include "rooms/number/random.hpp"
#include "verify/starts/angle.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

/// A hash of the bits of fixed results, or 0 if the self-test refuses to compute.
using Evaluation = std::uint64_t (*)();

class Hash {
  public:
    void add(double x) { value_ = (value_ ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3; }
    [[nodiscard]] std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325;
};

std::uint64_t program() {
    try {
        require_sound_arithmetic();
    } catch (const BrokenInvariant&) {
        return 0;
    }
    Random random(301);
    Hash hash;
    for (int i = 0; i < 2'000; ++i) {
        const Interval x(random.uniform(0, 2), random.uniform(2, 3));
        const Interval y = x * sin(x) / (cos(x) + Interval(3)) - sqrt(x);
        hash.add(y.lo());
        hash.add(y.hi());
    }
    return hash.value();
}

std::uint64_t verifier() {
    using I = dumbbell_verify::Interval<double>;
    if (!dumbbell_verify::arithmetic_works()) {
        return 0;
    }
    Random random(302);
    Hash hash;
    for (int i = 0; i < 2'000; ++i) {
        const I x(random.uniform(0, 2), random.uniform(2, 3));
        const I quarter = dumbbell_verify::pi<double>() / I(2);
        const auto at = sin_cos_on(x, quarter);
        const I y = x * at.sin / (at.cos + I(3)) - square(x);
        hash.add(y.lo);
        hash.add(y.hi);
    }
    return hash.value();
}

constexpr int crew = 8;

/// Eight threads that compute when they are told to.
class Crew {
  public:
    explicit Crew(Evaluation evaluate) {
        for (std::uint64_t& result : results_) {
            threads_.emplace_back([&result, evaluate, this] {
                begin_.arrive_and_wait();
                result = evaluate();
                flint_cleanup();
            });
        }
    }
    const std::array<std::uint64_t, crew>& results() {
        begin_.arrive_and_wait();
        for (std::thread& thread : threads_) {
            thread.join();
        }
        return results_;
    }

  private:
    std::barrier<> begin_{crew + 1};
    std::array<std::uint64_t, crew> results_{};
    std::vector<std::thread> threads_;
};

bool all_are(const std::array<std::uint64_t, crew>& results, std::uint64_t expected) {
    return std::all_of(results.begin(), results.end(), [&](std::uint64_t r) { return r == expected; });
}

}  // namespace

TEST_CASE("Eight threads from before a change of mode and eight from after it compute the same bits") {
    for (const Evaluation evaluate : {&program, &verifier}) {
        const std::uint64_t expected = evaluate();
        REQUIRE(expected != 0);
        for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
            Crew before(evaluate);
            std::fesetround(mode);
            Crew during(evaluate);  // inherits the mode, and refuses
            const std::uint64_t here = evaluate();
            const bool works = all_are(before.results(), expected);
            std::fesetround(FE_TONEAREST);
            Crew after(evaluate);
            CHECK(here == 0);
            CHECK(works);
            CHECK(all_are(during.results(), 0));
            CHECK(all_are(after.results(), expected));
        }
    }
}
