// Sine and cosine of intervals anywhere on the line, from those on [0, 2]; squares and their roots.
#pragma once
#include "verify/core/interval.hpp"
#include "verify/guess/square_root.hpp"

namespace dumbbell_verify {

/// The least interval that holds both.
template <class N>
Interval<N> hull(const Interval<N>& a, const Interval<N>& b) {
    return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}
/// From a lower bound of something to an upper bound of the same.
template <class N>
Interval<N> span(const N& low, const N& high) {
    if (!(low <= high)) throw Excluded();
    return {low, high};
}
/// The numbers that lie in both, of two enclosures of the same thing.
template <class N>
Interval<N> meet(const Interval<N>& a, const Interval<N>& b) {
    return span(std::max(a.lo, b.lo), std::min(a.hi, b.hi));
}
/// The squares; >= 0 also where x holds 0.
template <class N>
Interval<N> square(const Interval<N>& x) {
    const Interval<N> product = x * x;
    return {std::max(N(0), product.lo), product.hi};
}

/// The square roots of what is not negative in x.
template <class N>
Interval<N> root(const Interval<N>& x) {
    const auto end = [](Round d, const N& y) {
        if (!(y > N(0))) return N(0);
        const N guess = guess_square_root(y),
                other = div(d, y, guess);  // the root lies between y/g and g, for any g > 0
        return d == down ? std::min(guess, other) : std::max(guess, other);
    };
    return {end(down, x.lo), end(up, x.hi)};
}

constexpr double most_quarters = 0x1p28;  ///< of a turn: farther out nothing is known

/// Of a number z. With k right angles taken off, z - k pi/2 lies in an interval y of [-1, 1]; at its end y.lo
/// the series are known, and over a distance neither function changes by more than that distance.
template <class N>
SinCos<Interval<N>> sin_cos_at(const N& z, const Interval<N>& quarter) {
    using I = Interval<N>;
    const I whole(N(-1), N(1));
    const double quarters = to_double(down, z) / to_double(down, quarter.lo);
    if (!(std::abs(quarters) < most_quarters)) return {whole, whole};
    const int k = static_cast<int>(std::lround(quarters));
    const I y = I(z) - I(k) * quarter;
    if (!(y.lo >= N(-1) && y.hi <= N(1))) return {whole, whole};
    const bool negative = y.lo < N(0);
    const auto [s, c] = sin_cos(negative ? -y.lo : y.lo);
    const N width = (I(y.hi) - y.lo).hi;
    const I error(-width, width), sine = (negative ? -s : s) + error, cosine = c + error;
    const I turned[] = {sine, cosine, -sine, -cosine};  // sin(y + k pi/2) for k = 0 to 3
    return {turned[k & 3], turned[(k + 1) & 3]};
}

/// For all z in X. Between two neighbouring multiples of a right angle both functions are monotone; at k
/// right angles one of them has an extremum.
template <class N>
SinCos<Interval<N>> sin_cos_on(const Interval<N>& x, const Interval<N>& quarter) {
    using I = Interval<N>;
    const I quarters = x / quarter, whole(N(-1), N(1));
    const double first = std::ceil(to_double(down, quarters.lo)),
                 last = std::floor(to_double(up, quarters.hi));
    if (!(last - first < 4 && std::abs(first) < most_quarters && std::abs(last) < most_quarters))
        return {whole, whole};
    SinCos<I> result = sin_cos_at(x.lo, quarter);
    if (x.lo < x.hi) {
        const SinCos<I> end = sin_cos_at(x.hi, quarter);
        result = {hull(result.sin, end.sin), hull(result.cos, end.cos)};
    }
    for (int k = static_cast<int>(first); k <= static_cast<int>(last); ++k) {
        if ((k & 3) == 0) result.cos.hi = N(1);
        if ((k & 3) == 1) result.sin.hi = N(1);
        if ((k & 3) == 2) result.cos.lo = N(-1);
        if ((k & 3) == 3) result.sin.lo = N(-1);
    }
    return result;
}

}  // namespace dumbbell_verify
