#pragma once

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>

// What the compiler tells of its flags; the self-test at start-up finds what it does not tell.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    defined(__NO_SIGNED_ZEROS__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "dumbbell: -ffast-math and its parts break IEEE arithmetic and with it every enclosure; build without"
#endif

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53 &&
                  FLT_EVAL_METHOD == 0,
              "dumbbell needs IEEE 754 binary64, and operations that round to it");

/// Directed rounding without switching modes.
///
/// All arithmetic runs in round-to-nearest. If t is the exact result of an operation and v = RN(t) the
/// computed one, no double lies strictly between t and v, hence
///
///     next_down(v) <= t <= next_up(v),
///
/// whatever the binade, subnormals included. That is the whole proof, and it needs no property of the
/// compiler beyond IEEE semantics of single operations (tested at start-up, see self_test.hpp). On overflow v
/// = inf, and next_down(inf) = DBL_MAX <= t. NaN stays NaN.
namespace dumbbell {

/// The greatest double below v; -inf for -inf; NaN for NaN.
[[nodiscard]] inline double next_down(double v) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(v);
    if (v > 0) {
        return std::bit_cast<double>(bits - 1);
    }
    if (v == 0) {
        return -std::numeric_limits<double>::denorm_min();
    }
    if (v >= -std::numeric_limits<double>::max()) {
        return std::bit_cast<double>(bits + 1);
    }
    return v;  // -inf, NaN
}

/// The least double above v; inf for inf; NaN for NaN.
[[nodiscard]] inline double next_up(double v) noexcept { return -next_down(-v); }

/// The rounding policy that Boost.Interval is given: `*_down` <= exact result <= `*_up`.
///
/// Only what Interval uses is here: an operation of Boost that would need more does not compile, so no
/// primary template can silently compute unrounded.
struct NeighbourRounding {
    using unprotected_rounding = NeighbourRounding;

    static double mul_down(double a, double b) noexcept { return next_down(a * b); }
    static double mul_up(double a, double b) noexcept { return next_up(a * b); }
    static double div_down(double a, double b) noexcept { return next_down(a / b); }
    static double div_up(double a, double b) noexcept { return next_up(a / b); }
    /// sqrt is correctly rounded by IEEE 754. The result is never below 0.
    static double sqrt_down(double a) noexcept { return a == 0 ? 0.0 : next_down(std::sqrt(a)); }
    static double sqrt_up(double a) noexcept { return a == 0 ? 0.0 : next_up(std::sqrt(a)); }
};

}  // namespace dumbbell
