#include "collisions/scene.hpp"

#include <algorithm>
#include <cmath>

#include "flight/paper_bound.hpp"
#include "flight/wedge.hpp"

/// The source paper's model wedges, straight and hybrid: slopes only, and the same maximum ceil(pi/gamma)
/// (L17, L18).
namespace dumbbell::collisions {
namespace {

std::vector<Chart> wedge_charts(Section section) {
    return section == Section::turning ? std::vector{Chart::wedge} : std::vector<Chart>{};
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

std::optional<Count> wedge_maximum(const Rational& q, const std::optional<Heights>& /*heights*/,
                                   const Interrupted& /*interrupted*/) {
    return flight::paper_bound(q) - 1;
}

bool may_be(const Count& /*n*/, const Rational& /*q*/, const Interrupted& /*interrupted*/) { return true; }

/// A collision of scaled slope lambda, its counts exact at the greatest r, where they are least (L17, L18).
std::optional<Witness> wedge_witness(const Rational& q_lo, const Rational& /*q_hi*/, const Count& target,
                                     const std::optional<Heights>& /*heights*/,
                                     const Interrupted& interrupted) {
    const Rational r = 1 / q_lo;
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
        const Witness w{0, lambda, std::min(*forward, least), std::min(*backward, least), Chart::wedge};
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
constexpr BoundSearch<I> wedge_bounds{wedge_maximum, may_be, may_be, wedge_witness};

/// Their steps, cot^2(pi / (2 (n - 1))), are about (2 (n - 1) / pi)^2.
constexpr SceneRow named(std::string_view hits, std::string_view system, std::string_view where,
                         std::string_view title) {
    return {.hits = hits,
            .hits_it = "trajectory hits them",
            .system = system,
            .where = where,
            .title = title,
            .growth = "1.570796326794896619231321691640",
            .charts = wedge_charts,
            .step = wedge_step,
            .bounds = {wedge_bounds<Interval>, wedge_bounds<BigInterval>}};
}

}  // namespace

const SceneRow hybrid_row =
    named("trajectory in the hybrid wedge hits its walls", "The hybrid wedge", " in the hybrid wedge",
          "Greatest number of collisions in the hybrid wedge against the mass ratio");
const SceneRow wedge_row =
    named("trajectory in the straight wedge hits its walls", "The straight wedge", " in the straight wedge",
          "Greatest number of collisions in the straight wedge against the mass ratio");

}  // namespace dumbbell::collisions
