#pragma once

/// Packs: W doubles side by side, W = 2 (on any machine, pack_portable.hpp), 4 (AVX2, pack_avx2.hpp) or 8
/// (AVX-512, pack_avx512.hpp), or 1, a plain `double`.
///
/// The same template of a computation gives the same bits with each of them: every operation here rounds each
/// lane as IEEE 754 says, one at a time (no fused multiply-add: -ffp-contract=off), and nothing mixes lanes.
/// Each wide pack is used in one translation unit only, the one that is compiled for its instructions. There
/// is nothing else in there that another unit could come to share and that would not run on every machine: no
/// inline function of the standard library, no template without a pack in its name (a test looks at the
/// symbols).
///
/// A pack D has +, -, *, /, unary -, and from a double the pack of W copies of it; comparisons <, <=, >, >=
/// (false where either side is NaN) give a mask, which has &&, || (both sides are computed) and !. And:
///
/// - select(mask, a, b): a where the mask is set, else b
/// - abs(a), sqrt(a), max(a, b), min(a, b); the latter are b where either is NaN, or both are equal
/// - lanes(mask): bit i is set if lane i is
/// - Lanes<D>: width, the mask of no lane, a pack from and to an array
namespace dumbbell::flight::batch {

[[nodiscard]] inline double select(bool mask, double a, double b) { return mask ? a : b; }
[[nodiscard]] inline bool select(bool mask, bool a, bool b) { return mask ? a : b; }
[[nodiscard]] inline double abs(double a) { return __builtin_fabs(a); }
[[nodiscard]] inline double sqrt(double a) { return __builtin_sqrt(a); }
[[nodiscard]] inline double max(double a, double b) { return a > b ? a : b; }
[[nodiscard]] inline double min(double a, double b) { return a < b ? a : b; }
[[nodiscard]] inline unsigned lanes(bool mask) { return mask ? 1U : 0U; }

template <class D>
struct Lanes;

template <>
struct Lanes<double> {
    using Mask = bool;
    static constexpr int width = 1;
    static Mask none() { return false; }
    static double load(const double* from) { return *from; }
    static void store(double* to, double a) { *to = a; }
};

template <class D>
using Mask = typename Lanes<D>::Mask;

}  // namespace dumbbell::flight::batch
