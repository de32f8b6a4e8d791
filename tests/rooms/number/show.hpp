#pragma once

#include <fmt/format.h>

#include <string>
#include <type_traits>

#include "number/big_interval.hpp"
#include "number/interval.hpp"

/// Prints the inputs of a failed check so that they can be typed in again.
namespace dumbbell_test {

template <class T>
requires std::is_integral_v<T> std::string show(T n) { return fmt::format("{}", n); }
inline std::string show(double x) { return fmt::format("{:a} ({})", x, x); }
inline std::string show(const char* text) { return text; }
inline std::string show(const std::string& text) { return text; }
inline std::string show(const dumbbell::Interval& x) { return fmt::format("[{:a}, {:a}]", x.lo(), x.hi()); }
inline std::string show(const dumbbell::BigInterval& x) {
    return fmt::format("[{:a}, {:a}] in doubles", x.lo(), x.hi());
}

/// The arguments, separated by blanks: say("x =", x, "got", y).
template <class... T>
std::string say(const T&... values) {
    std::string line;
    ((line += show(values) + " "), ...);
    return line;
}

}  // namespace dumbbell_test
