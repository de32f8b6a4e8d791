#include "collisions/halving.hpp"

#include <algorithm>
#include <utility>

#include "collisions/section.hpp"
#include "number/parallel.hpp"

namespace dumbbell::collisions {

Halving::Halving(const Claim& claim, const PieceStore* store, Interrupted interrupted)
    : claim_(claim), interrupted_(std::move(interrupted)) {
    for (const Piece& piece : store ? store->kept() : std::vector<Piece>()) {
        kept_.push_back({piece.q_lo, piece.q_hi});
    }
}

std::vector<Halving::Maximum> Halving::maxima_at(const std::vector<Rational>& ratios) const {
    const auto& bounds = std::get<BoundSearch<Interval>>(row_of(claim_.system.section).bounds);
    std::vector<Maximum> maxima(ratios.size());
    in_parallel(ratios.size(), [&](std::size_t i) {
        if (!interrupted_()) {
            maxima[i] = bounds.maximum(ratios[i], claim_.system, interrupted_);
        }
    });
    return maxima;
}

bool Halving::is_narrow(const Part& part) const {
    const auto& [range, at_lo, at_hi] = part;
    return range.hi - range.lo <= claim_.gap * range.lo || !at_lo || !at_hi;
}

/// Not if its proof has failed in an earlier run, which kept a piece of it.
bool Halving::is_to_be_proved(const Part& part) const {
    const auto is_inside = [&](const Range& kept) {
        return kept != part.range && part.range.lo <= kept.lo && kept.hi <= part.range.hi;
    };
    return is_narrow(part) || (*part.at_lo == *part.at_hi && std::ranges::none_of(kept_, is_inside));
}

std::vector<Halving::Part> Halving::halves_of(const std::vector<Part>& parts) const {
    std::vector<Rational> middles;
    for (const Part& part : parts) {
        middles.emplace_back((part.range.lo + part.range.hi) / 2);
    }
    const auto maxima = maxima_at(middles);
    std::vector<Part> halves;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto& [range, at_lo, at_hi] = parts[i];
        halves.push_back({{range.lo, middles[i]}, at_lo, maxima[i]});
        halves.push_back({{middles[i], range.hi}, maxima[i], at_hi});
    }
    return halves;
}

std::vector<PlannedPiece> Halving::next(std::vector<ProvedPiece>& proved) {
    std::vector<Part> parts, failed;
    if (!std::exchange(begun_, true)) {
        const auto ends = maxima_at({claim_.range.lo, claim_.range.hi});
        parts.push_back({claim_.range, ends[0], ends[1]});
    }
    for (std::size_t i = tried_.size(); i-- > 0;) {
        if (!proved[i].piece.upper && !is_narrow(tried_[i])) {
            failed.push_back(tried_[i]);
            proved.erase(proved.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
    tried_.clear();
    while (!parts.empty() || !failed.empty()) {
        std::ranges::move(halves_of(std::exchange(failed, {})), std::back_inserter(parts));
        for (Part& part : std::exchange(parts, {})) {
            (is_to_be_proved(part) ? tried_ : failed).push_back(std::move(part));
        }
    }
    std::vector<PlannedPiece> planned;
    for (const auto& [range, at_lo, at_hi] : tried_) {
        const bool known = at_lo && at_hi;
        planned.push_back({range.lo, range.hi, as_long(known ? std::max(*at_lo, *at_hi) : Count(1)),
                           as_long(known ? std::min(*at_lo, *at_hi) : Count())});
    }
    return planned;
}

}  // namespace dumbbell::collisions
