#include "campaign/local_engine.hpp"

#include <catch2/catch.hpp>
#include <ctime>
#include <map>

#include "scripted_engine.hpp"

using namespace dumbbell;
using namespace dumbbell::campaign;
using namespace dumbbell_test;
using namespace std::chrono_literals;
using Catch::Matchers::Contains;

namespace {

Task task_of(const Order& order) { return {order.id(), order.text(), {}, {}}; }

Order ratios(long first, long last) { return small_plan(first, last).whole; }

}  // namespace

TEST_CASE("each task has its own result") {
    LocalEngine engine(3, ".");
    std::map<std::string, std::string> expected;
    for (long n = 3; n < 23; ++n) {
        const Task task = task_of(ratios(n, n + 2));
        expected[task.id] = worked(task).result;
        engine.submit(task);
    }
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const auto outcome = engine.wait(1h);
        REQUIRE(outcome.has_value());
        CHECK(outcome->end == campaign::Outcome::End::done);
        CHECK(outcome->result == expected.at(outcome->id));
        CHECK(outcome->worker == "local");
    }
    CHECK_FALSE(engine.wait(1ms).has_value());
}

TEST_CASE("a task beyond its limit is too long, and one that cannot be understood fails") {
    LocalEngine engine(1, ".");
    Task task = task_of(ratios(5000, 5003));
    task.limit = 0s;
    engine.submit(task);
    auto outcome = engine.wait(1h);
    REQUIRE(outcome.has_value());
    CHECK(outcome->end == campaign::Outcome::End::too_long);
    engine.submit({"x", "nonsense", {}, {}});
    outcome = engine.wait(1h);
    REQUIRE(outcome.has_value());
    CHECK(outcome->end == campaign::Outcome::End::failed);
    CHECK_THAT(outcome->reason, Contains("is not an order"));
    engine.submit(task_of({"prove nonsense\n", {"x"}}));
    outcome = engine.wait(1h);
    REQUIRE(outcome.has_value());
    CHECK_THAT(outcome->reason, Contains("'nonsense'"));
}

TEST_CASE("an engine that is no longer wanted ends early") {
    const std::clock_t start = std::clock();  // of the processor: the machine may be busy
    {
        LocalEngine engine(2, ".");
        for (long n = 0; n < 4; ++n) {
            engine.submit(task_of(ratios(200'000 + 10 * n, 200'003 + 10 * n)));
        }
    }
    CHECK(std::clock() - start < 60 * CLOCKS_PER_SEC);
}
