#pragma once

#include <string>
#include <utility>

#include "number/integer.hpp"

namespace dumbbell {

/// One of several parts of a range: the 7th of 64.
struct Part {
    long number = 1;
    long of = 1;
};

/// K/N of --part, 1 <= K <= N <= 10^6. Throws InputError.
[[nodiscard]] Part parse_part(const std::string& text);

/// Rounded down. Precondition: x >= 0.
[[nodiscard]] Integer sqrt(const Integer& x);

/// The steps of a range, where step x costs about fixed + x.
struct Steps {
    Integer first;
    Integer end;  ///< one behind the last
    long fixed = 0;
};

/// A part of them, as first and end: all parts cost about as much, each has a step at least, and together
/// they are all. By integers alone, so that every machine cuts alike. Throws InputError if there are fewer
/// steps' worth of work than parts.
[[nodiscard]] std::pair<Integer, Integer> steps_of(const Part& part, const Steps& steps);

}  // namespace dumbbell
