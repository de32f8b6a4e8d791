// The algorithms of std::ranges that the prover uses, which emscripten's library of C++ lacks.
#pragma once
#include <algorithm>
#include <functional>
#ifndef __cpp_lib_ranges
namespace std::ranges {

template <class Range, class Value, class Projection = identity>
constexpr auto find(Range&& range, const Value& value, Projection projection = {}) {
    return std::find_if(begin(range), end(range),
                        [&](const auto& x) { return invoke(projection, x) == value; });
}
template <class Range, class Test>
constexpr auto find_if(Range&& range, Test test) {
    return std::find_if(begin(range), end(range), ref(test));
}
template <class Range, class Test>
constexpr bool all_of(Range&& range, Test test) {
    return std::all_of(begin(range), end(range), ref(test));
}
template <class Range, class Test>
constexpr bool none_of(Range&& range, Test test) {
    return std::none_of(begin(range), end(range), ref(test));
}
template <class Range, class Use>
constexpr void for_each(Range&& range, Use use) {
    std::for_each(begin(range), end(range), ref(use));
}
template <class Range, class To, class Operation>
constexpr void transform(Range&& range, To to, Operation operation) {
    std::transform(begin(range), end(range), to, [&](auto& x) { return invoke(operation, x); });
}
template <class Range, class To>
constexpr void move(Range&& range, To to) {
    std::move(begin(range), end(range), to);
}

/// `compare` of what the projection makes of two elements.
template <class Compare, class Projection>
constexpr auto projected(Compare& compare, Projection& projection) {
    return [&](const auto& x, const auto& y) {
        return invoke(compare, invoke(projection, x), invoke(projection, y));
    };
}
template <class Range, class Compare = std::less<>, class Projection = identity>
constexpr auto min_element(Range&& range, Compare compare = {}, Projection projection = {}) {
    return std::min_element(begin(range), end(range), projected(compare, projection));
}
template <class Range, class Compare = std::less<>, class Projection = identity>
constexpr auto max_element(Range&& range, Compare compare = {}, Projection projection = {}) {
    return std::max_element(begin(range), end(range), projected(compare, projection));
}
template <class Range, class Compare = std::less<>, class Projection = identity>
constexpr void sort(Range&& range, Compare compare = {}, Projection projection = {}) {
    std::sort(begin(range), end(range), projected(compare, projection));
}

}  // namespace std::ranges
#endif
