#pragma once

/// The two ends of an interval side by side, as {-lo, hi}: outward is up for both. By the compiler's own
/// vectors: one register where the machine's basic instructions know such.
namespace dumbbell::ends {

using Pair = double __attribute__((vector_size(16)));
using Bits = unsigned long long __attribute__((vector_size(16)));

[[nodiscard]] inline Pair twice(double v) { return Pair{v, v}; }
[[nodiscard]] inline Pair swapped(Pair v) { return Pair{v[1], v[0]}; }
/// The second argument where either is NaN.
[[nodiscard]] inline Pair max(Pair a, Pair b) { return a > b ? a : b; }
[[nodiscard]] inline Pair min(Pair a, Pair b) { return a < b ? a : b; }

/// At least the exact result t of an operation, of which v = RN(t) is the computed one; NaN for NaN.
///
/// The same as next_up(v) (rounding.hpp), without a branch, but that -0 stays as it is: an operation gives -0
/// only if t <= 0 (IEEE 754, 6.3). The bits of a double, less its sign, grow with its size: one more is the
/// neighbour away from 0, one less that towards it. Where this steps over the end of the numbers - from inf
/// to a NaN, from one NaN to anything - or from -0 to the least number below 0, the result is not greater
/// than v, and v is taken.
[[nodiscard]] inline Pair above(Pair v) {
    const Bits step = reinterpret_cast<Bits>(v < 0) | 1;  // -1 below 0, else 1
    const Pair next = reinterpret_cast<Pair>(reinterpret_cast<Bits>(v) + step);
    return max(next, v);
}

}  // namespace dumbbell::ends
