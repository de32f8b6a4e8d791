// Critical ratios as the program encloses them.
#pragma once

#include "catch.hpp"
#include "critical/enclose.hpp"

namespace dumbbell_test {

inline dumbbell::critical::Ratio enclosed(long n, int digits) {
    auto ratio = dumbbell::critical::enclose_ratio(n, {.digits = digits});
    REQUIRE(ratio);
    return *ratio;
}

}  // namespace dumbbell_test
