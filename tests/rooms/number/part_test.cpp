#include "number/part.hpp"

#include "base/error.hpp"
#include "catch.hpp"

using namespace dumbbell;

TEST_CASE("a part is K/N") {
    const Part part = parse_part("7/64");
    CHECK(part.number == 7);
    CHECK(part.of == 64);
    CHECK(parse_part("1/1").of == 1);
    CHECK(parse_part("1000000/1000000").number == 1'000'000);
    for (const char* text :
         {"", "/", "7", "7/", "/64", "0/64", "65/64", "-1/64", "7/0", "7/64/2", "7:64", "7 / 64", "1.5/3",
          "+1/3", "1/1000001", "9999999999999999999/9999999999999999999", "x/y"}) {
        CAPTURE(text);
        CHECK_THROWS_WITH(parse_part(text), Contains("write K/N") && Contains("7/64"));
    }
}

TEST_CASE("a square root is rounded down, exactly") {
    const Integer root = pow(Integer(10), 40) + 7;
    CHECK(sqrt(root * root) == root);
    CHECK(sqrt(root * root - 1) == root - 1);
    CHECK(sqrt(Integer(0)) == 0);
}

TEST_CASE("parts of steps follow one another, and none is empty, up to as many as there can be") {
    for (const Steps& steps :
         {Steps{3, 40, 0}, Steps{3, 40, 1000}, Steps{pow(Integer(10), 18), pow(Integer(10), 18) + 37, 5}}) {
        long most = 1;
        for (long of = 2; of <= 38; ++of) {
            try {
                (void)steps_of({1, of}, steps);
                most = of;
            } catch (const InputError& error) {
                CHECK_THAT(error.what(), Contains("at most " + std::to_string(most)));
            }
        }
        CHECK(most >= 18);
        for (long of = 1; of <= most; ++of) {
            Integer reached = steps.first;
            for (long number = 1; number <= of; ++number) {
                CAPTURE(of, number);
                const auto [first, end] = steps_of({number, of}, steps);
                REQUIRE(first == reached);
                REQUIRE(end > first);
                reached = end;
            }
            REQUIRE(reached == steps.end);
        }
    }
}

TEST_CASE("a range without a step has one part") {
    CHECK(steps_of({1, 1}, {5, 5, 0}).first == 5);
    CHECK_THROWS_AS(steps_of({1, 2}, {5, 5, 0}), InputError);
}
