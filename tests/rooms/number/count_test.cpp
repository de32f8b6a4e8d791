#include "number/count.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "base/error.hpp"

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

TEST_CASE("a count that fits is a long by itself, and no other is") {
    const long fits = beyond - 1;
    CHECK(fits == greatest_long);
    const auto as_long = [](long n) { return n; };
    CHECK_THROWS_AS(as_long(beyond), InputError);
    CHECK_THROWS_AS(as_long(Count(0) - beyond - 1), InputError);
}
