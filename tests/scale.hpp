#pragma once

#include <cstdlib>

/// How much a test tries: `count`, of which a test case takes at most a second, times DUMBBELL_TEST_SCALE in the
/// environment, 1 by default. `./run trust` asks for 20.
[[nodiscard]] inline long scaled(long count) {
    const char* scale = std::getenv("DUMBBELL_TEST_SCALE");
    const long factor = scale == nullptr ? 1 : std::atol(scale);
    return factor > 1 ? count * factor : count;
}
