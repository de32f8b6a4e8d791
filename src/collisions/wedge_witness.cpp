#include <algorithm>

#include "collisions/witness.hpp"
#include "flight/wedge.hpp"

namespace dumbbell::collisions {

std::optional<Witness> find_wedge_witness(const Rational& q_lo, long target, const Interrupted& interrupted) {
    const Rational r = 1 / q_lo;
    const auto attempt = [&](const Rational& lambda) -> std::optional<Witness> {
        const Rational denominator = 1 + 2 * r * lambda - r;
        const Rational mu = denominator > 0 ? (2 + r * lambda - lambda) / denominator : Rational(-1);
        if (r * lambda >= 1 || mu < 0) {
            return std::nullopt;
        }
        const auto forward = flight::wedge_count(r * lambda, r, target, interrupted);
        const auto backward = forward ? flight::wedge_count(r * mu, r, target, interrupted) : std::nullopt;
        if (!backward) {
            return std::nullopt;
        }
        const Witness w{0, lambda, *forward, *backward, Chart::wedge};
        return w.total() >= target ? std::optional(w) : std::nullopt;
    };
    // lambda = 1 turns symmetrically: best where the maximum is odd. Nearly horizontal rays do where it is
    // even and no tie is near; lambda = 0, the horizontal one itself, attains it however near a tie is.
    constexpr int least_lambda_bits = 200;
    for (int depth = 0; depth <= least_lambda_bits + 1 && !interrupted(); ++depth) {
        const Rational lambda = depth <= least_lambda_bits ? Rational(1, Integer(1) << depth) : Rational(0);
        if (auto witness = attempt(lambda)) {
            witness->forward = std::min<Count>(witness->forward, target);
            witness->backward = std::min<Count>(witness->backward, target);
            return witness;
        }
    }
    return std::nullopt;
}

}  // namespace dumbbell::collisions
