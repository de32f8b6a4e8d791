// Critical ratios as the program encloses them.
#pragma once

#include "catch.hpp"
#include "collisions/critical.hpp"

namespace dumbbell_test {

inline dumbbell::collisions::CriticalRatio enclosed(long n, int digits) {
    auto ratio = dumbbell::collisions::enclose_critical_ratio(n, {.digits = digits});
    REQUIRE(ratio);
    return *ratio;
}

}  // namespace dumbbell_test
