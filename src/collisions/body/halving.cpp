#include "collisions/body/halving.hpp"

#include <algorithm>

namespace dumbbell::collisions {
namespace {

using Maximum = std::optional<Count>;

void add_parts(const Rational& lo, const Maximum& at_lo, const Rational& hi, const Maximum& at_hi,
               const Halving& by, std::vector<ProvedPiece>& pieces) {
    const bool narrow = hi - lo <= by.gap * lo || !at_lo || !at_hi;
    if (narrow || *at_lo == *at_hi) {
        const long upper = as_long(at_lo && at_hi ? std::max(*at_lo, *at_hi) : Count(1));
        const long lower = as_long(at_lo && at_hi ? std::min(*at_lo, *at_hi) : Count());
        ProvedPiece proved = by.prove(lo, hi, upper, lower);
        if (narrow || proved.piece.upper) {
            pieces.push_back(std::move(proved));
            return;
        }
    }
    const Rational middle = (lo + hi) / 2;
    const Maximum at_middle = by.maximum(middle);
    add_parts(lo, at_lo, middle, at_middle, by, pieces);
    add_parts(middle, at_middle, hi, at_hi, by, pieces);
}

}  // namespace

std::vector<ProvedPiece> prove_halved(const Rational& q_lo, const Rational& q_hi, const Halving& by) {
    std::vector<ProvedPiece> pieces;
    add_parts(q_lo, by.maximum(q_lo), q_hi, by.maximum(q_hi), by, pieces);
    return pieces;
}

}  // namespace dumbbell::collisions
