#include "collisions/leaf_judges.hpp"
#include "flight/wedge.hpp"

namespace dumbbell::collisions {
namespace {

/// Exact counting doubles and more the length of the numbers with every few steps: only for short orbits.
constexpr long longest_exact_orbit = 64;

/// The slopes of the lowest rays of a box (L17): X at the least lambda, sigma X at the greatest; none if
/// sigma X leaves.
struct LowestSlopes {
    Rational out;
    Rational reversed;
};

LowestSlopes lowest_slopes(const Box& box, const Rational& r) {
    const Rational lambda = box.slope_hi;
    const Rational denominator = 1 + 2 * r * lambda - r;
    const Rational mu = denominator > 0 ? (2 + r * lambda - lambda) / denominator : Rational(0);
    return {r * Rational(box.slope_lo), r * std::max(Rational(0), mu)};
}

template <class Count>
std::optional<Leaf> counted(const LowestSlopes& slopes, long upper, Count count) {
    const std::optional<long> forward = count(slopes.out, upper - 1);
    if (!forward || *forward > upper - 1) {
        return std::nullopt;
    }
    const long room = upper - 1 - *forward;
    const std::optional<long> backward = count(slopes.reversed, room);
    return backward && *backward <= room ? std::optional(Leaf{Reason::count, *forward, *backward})
                                         : std::nullopt;
}

}  // namespace

template <class I>
std::optional<Leaf> judge_wedge(const Box& box, long upper, const Interrupted& interrupted) {
    const Rational r = 1 / Rational(box.q_hi);
    const Rational least = box.slope_lo;
    if (r * least >= 1 || least * (1 - 1 / Rational(box.q_lo)) > 2) {
        return Leaf{Reason::outside};  // too steep, or sigma X descends
    }
    const LowestSlopes slopes = lowest_slopes(box, r);
    const I ratio = enclose<I>(r);
    auto rounded = counted(slopes, upper, [&](const Rational& kappa, long cap) {
        return flight::wedge_count_at_most(enclose<I>(kappa), ratio, cap, interrupted);
    });
    if (rounded || upper > longest_exact_orbit) {
        return rounded;
    }
    return counted(slopes, upper, [&](const Rational& kappa, long cap) {
        return flight::wedge_count(kappa, r, cap, interrupted);
    });
}

template std::optional<Leaf> judge_wedge<Interval>(const Box&, long, const Interrupted&);
template std::optional<Leaf> judge_wedge<BigInterval>(const Box&, long, const Interrupted&);

}  // namespace dumbbell::collisions
