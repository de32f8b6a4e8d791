#include "staircase/critical_confirm.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "collisions/piece.hpp"
#include "number/decimal.hpp"

namespace dumbbell::staircase {
namespace {

Decided decide(const Rational& q, long expected, const Interrupted& interrupted) {
    collisions::PieceOptions options;
    options.interrupted = interrupted;
    const collisions::Piece piece = prove_single(q, options).piece;
    return {q, expected, piece.upper, piece.lower, piece.bits};
}

}  // namespace

Confirmation confirm(const collisions::CriticalRatio& critical, const Rational& distance,
                     const Interrupted& interrupted) {
    require(distance > 0 && distance <= Rational(1, 100), "confirm: distance out of range");
    const int digits = digits_to_confirm(distance);
    const Rational below = exact(cut_down(critical.q_lo * (1 - distance), digits));
    const Rational above = exact(cut_up(critical.q_hi * (1 + distance), digits));
    return {decide(std::max(below, Rational(1)), critical.n - 1, interrupted),
            decide(above, critical.n, interrupted)};
}

int digits_to_confirm(const Rational& distance) {
    // A decimal of d digits is right to 10^(1-d) relatively, and distance >= 10^first.
    const Decimal first = cut_down(distance, 1);
    return 3 - first.exponent;
}

}  // namespace dumbbell::staircase
