#include "flight/wedge.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "collisions/chart.hpp"
#include "collisions/section.hpp"
#include "flight/paper_bound.hpp"

/// The source paper's model wedges, straight and hybrid: slopes only, and the same maximum ceil(pi/gamma)
/// (L17, L18).
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

LowestSlopes lowest_slopes(const Side& slope, const Rational& r) {
    const Rational lambda = slope.hi;
    const Rational denominator = 1 + 2 * r * lambda - r;
    const Rational mu = denominator > 0 ? (2 + r * lambda - lambda) / denominator : Rational(0);
    return {r * Rational(slope.lo), r * std::max(Rational(0), mu)};
}

template <class Count>
std::optional<Leaf> counted_slopes(const LowestSlopes& slopes, long upper, Count count) {
    const std::optional<long> forward = count(slopes.out, upper - 1);
    if (!forward || *forward > upper - 1) {
        return std::nullopt;
    }
    const long room = upper - 1 - *forward;
    const std::optional<long> backward = count(slopes.reversed, room);
    return backward && *backward <= room ? std::optional(Leaf{Reason::count, *forward, *backward})
                                         : std::nullopt;
}

template <class I>
std::optional<Leaf> judge_wedge(const Box& box, const Count& most, const Interrupted& interrupted) {
    const long upper = as_long(most);
    const auto& [position, slope, q] = box.sides;
    const Rational r = 1 / Rational(q.hi);
    const Rational least = slope.lo;
    if (r * least >= 1 || least * (1 - 1 / Rational(q.lo)) > 2) {
        return Leaf{Reason::outside};  // too steep, or sigma X descends
    }
    const LowestSlopes slopes = lowest_slopes(slope, r);
    const I ratio = enclose<I>(r);
    auto rounded = counted_slopes(slopes, upper, [&](const Rational& kappa, long cap) {
        return flight::wedge_count_at_most(enclose<I>(kappa), ratio, cap, interrupted);
    });
    if (rounded || upper > longest_exact_orbit) {
        return rounded;
    }
    return counted_slopes(slopes, upper, [&](const Rational& kappa, long cap) {
        return flight::wedge_count(kappa, r, cap, interrupted);
    });
}

/// At cot^2(pi / (2 (n - 1))).
Step wedge_step(long n, double gap, const Interrupted& /*interrupted*/) {
    if (n == 4) {
        return {n, 3, 0, true};
    }
    const PrecisionScope scope(64 + static_cast<int>(-3.33 * std::log10(gap)));
    const auto at = sin_cos(half_pi<BigInterval>() / BigInterval(static_cast<double>(n - 1)));
    const BigInterval q = sqr(at.cos / at.sin);
    return {n, exact_lo(q), (exact_hi(q) - exact_lo(q)) / exact_lo(q), false};
}

std::optional<Count> wedge_maximum(const Rational& q, const System& /*system*/,
                                   const Interrupted& /*interrupted*/) {
    return flight::paper_bound(q) - 1;
}

/// A collision of scaled slope lambda, its counts exact at the greatest r, where they are least (L17, L18).
std::optional<Witness> wedge_witness(const Range& range, const Count& target, const System& /*system*/,
                                     const Interrupted& interrupted) {
    const Rational r = 1 / range.lo;
    const long least = as_long(target);
    const auto attempt = [&](const Rational& lambda) -> std::optional<Witness> {
        const Rational denominator = 1 + 2 * r * lambda - r;
        const Rational mu = denominator > 0 ? (2 + r * lambda - lambda) / denominator : Rational(-1);
        if (r * lambda >= 1 || mu < 0) {
            return std::nullopt;
        }
        const auto forward = flight::wedge_count(r * lambda, r, least, interrupted);
        const auto backward = forward ? flight::wedge_count(r * mu, r, least, interrupted) : std::nullopt;
        if (!backward) {
            return std::nullopt;
        }
        const Witness w{0, lambda, std::min(*forward, least), std::min(*backward, least), Place::wedge};
        return w.total() >= target ? std::optional(w) : std::nullopt;
    };
    // lambda = 1 turns symmetrically: best where the maximum is odd. Nearly horizontal rays do where it is
    // even and no tie is near; lambda = 0, the horizontal one itself, attains it however near a tie is.
    constexpr int least_lambda_bits = 200;
    for (int depth = 0; depth <= least_lambda_bits + 1 && !interrupted(); ++depth) {
        const Rational lambda = depth <= least_lambda_bits ? Rational(1, Integer(1) << depth) : Rational(0);
        if (auto witness = attempt(lambda)) {
            return witness;
        }
    }
    return std::nullopt;
}

template <class I>
constexpr BoundSearch<I> wedge_bounds{wedge_maximum, nullptr, nullptr, wedge_witness};

constexpr std::array wedge_charts{Chart::wedge};

/// Their steps, cot^2(pi / (2 (n - 1))), are about (2 (n - 1) / pi)^2.
constexpr SectionRow wedge(std::string_view scene, std::string_view hits, std::string_view system,
                           std::string_view where, std::string_view title) {
    return {.scene = scene,
            .section = "turning",
            .lemmas = "1",
            .section_in_file = "turning",
            .hits = hits,
            .hits_it = "trajectory hits them",
            .system = system,
            .where = where,
            .title = title,
            .growth = "1.570796326794896619231321691640",
            .charts = wedge_charts,
            .exact_step = 3,
            .step = wedge_step,
            .bounds = {wedge_bounds<Interval>, wedge_bounds<BigInterval>}};
}

}  // namespace

const ChartRow wedge_chart{.name = "wedge",
                           .position = "e",
                           .slope = "lambda",
                           .greatest_position = 0,
                           .judges = {judge_wedge<Interval>, judge_wedge<BigInterval>}};

const SectionRow hybrid_row =
    wedge("hybrid", "trajectory in the hybrid wedge hits its walls", "The hybrid wedge",
          " in the hybrid wedge", "Greatest number of collisions in the hybrid wedge against the mass ratio");
const SectionRow wedge_row = wedge(
    "wedge", "trajectory in the straight wedge hits its walls", "The straight wedge",
    " in the straight wedge", "Greatest number of collisions in the straight wedge against the mass ratio");

}  // namespace dumbbell::collisions
