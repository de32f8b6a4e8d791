#include "number/count.hpp"

#include <limits>

#include "base/error.hpp"
#include "catch.hpp"

using namespace dumbbell;

namespace {

constexpr long greatest_long = std::numeric_limits<long>::max();
const Count beyond = Count(greatest_long) + 1;

}  // namespace

TEST_CASE("counts of any size are added and compared") {
    CHECK(beyond.str() == "9223372036854775808");
    CHECK((beyond + beyond).str() == "18446744073709551616");
    CHECK(beyond - 1 == greatest_long);
    CHECK(1 + Count(2) == 3);
    CHECK(2 < Count(3));
    CHECK(beyond > greatest_long);
    CHECK(Count(7) - beyond < 0);
    Count n = beyond;
    CHECK(++n - beyond == 1);
    CHECK(--n == beyond);
    CHECK((beyond + 5) % 256L == 5);
    CHECK(fmt::format("{}", beyond) == beyond.str());
}

TEST_CASE("a double becomes a count without what is behind the point, exactly") {
    CHECK(Count(12.9) == 12);
    CHECK(Count(0x1p200) == Count(Integer(1) << 200));
    CHECK(static_cast<double>(Count(Integer(1) << 200)) == 0x1p200);
}

TEST_CASE("a count that fits can be had as a long, and no other") {
    CHECK(as_long(beyond - 1) == greatest_long);
    CHECK_THROWS_AS(as_long(beyond), InputError);
    CHECK_THROWS_AS(as_long(Count(0) - beyond - 1), InputError);
    CHECK_FALSE(std::is_convertible_v<Count, long>);
}

TEST_CASE("counts are right where they begin to take memory of their own") {
    const Integer edge = Integer(1) << 62;
    for (const int step : {-2, -1, 0, 1, 2}) {
        for (const Integer& value : {Integer(edge + Integer(step)), Integer(-edge + Integer(step))}) {
            const Count count(value);
            CHECK(count.str() == value.str());
            CHECK(count.integer() == value);
            CHECK(Count(value.convert_to<long>()) == count);
            CHECK(as_long(count) == value.convert_to<long>());
            Count other(7);
            other = count;
            CHECK((other + 3) - count == 3);
            const Count moved(std::move(other));
            CHECK(moved == count);
            CHECK(moved - count == 0);
        }
    }
    CHECK(Count(std::numeric_limits<unsigned long>::max()).str() == "18446744073709551615");
    CHECK((Count(edge) <=> Count(-edge)) == std::strong_ordering::greater);
}
