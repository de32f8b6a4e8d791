#include "verify/program/piece_sums.hpp"

#include <algorithm>

namespace dumbbell_verify {
namespace {

Bounds of_one(const Collisions::Part& piece) {
    Collisions alone;  // says what is a gap, and what is open
    alone.add(piece.lo, piece.hi, piece.upper, piece.lower);
    return {alone.upper, alone.lower, alone.gaps, alone.open};
}

Bounds together(const Bounds& a, const Bounds& b) {
    return {a.upper && b.upper ? std::max(a.upper, b.upper) : std::nullopt, std::min(a.lower, b.lower),
            a.gaps + b.gaps, a.open + b.open};
}

}  // namespace

PieceSums::PieceSums(const Collisions& claim)
    : first_(claim.keep.first), count_(claim.parts.size()), nodes_(2 * count_) {
    for (std::size_t i = 0; i < count_; ++i) nodes_[count_ + i] = of_one(claim.parts[i]);
    for (std::size_t i = count_; i-- > 1;) nodes_[i] = together(nodes_[2 * i], nodes_[2 * i + 1]);
}

Bounds PieceSums::of(const Pieces& pieces) const {
    std::optional<Bounds> sum;
    const auto take = [&](const Bounds& node) { sum = sum ? together(*sum, node) : node; };
    std::uint64_t from = pieces.first - first_ + count_, to = pieces.last - first_ + count_ + 1;
    for (; from < to; from /= 2, to /= 2) {
        if (from % 2 == 1) take(nodes_.at(from++));
        if (to % 2 == 1) take(nodes_.at(--to));
    }
    return sum.value();
}

}  // namespace dumbbell_verify
