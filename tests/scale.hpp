#pragma once

#include <algorithm>
#include <cstdlib>
#include <vector>

/// How much a test tries: `count`, of which a test case takes at most a second, times DUMBBELL_TEST_SCALE in
/// the environment, 1 by default. `./run trust` asks for 20.
[[nodiscard]] inline long scaled(long count) {
    const char* scale = std::getenv("DUMBBELL_TEST_SCALE");
    const long factor = scale == nullptr ? 1 : std::atol(scale);
    return factor > 1 ? count * factor : count;
}

/// The first of them, of which a test case takes at most a second, and more where more is asked for.
template <class T>
[[nodiscard]] std::vector<T> some_of(std::vector<T> all, long count) {
    all.resize(std::min(all.size(), static_cast<std::size_t>(scaled(count))));
    return all;
}
