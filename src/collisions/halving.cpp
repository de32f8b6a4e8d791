#include "collisions/halving.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collisions/section.hpp"
#include "number/decimal.hpp"
#include "number/parallel.hpp"

namespace dumbbell::collisions {

Halving::Halving(const Claim& claim, const PieceStore* store, Interrupted interrupted)
    : claim_(claim), interrupted_(std::move(interrupted)) {
    for (const Piece& piece : store ? store->kept() : std::vector<Piece>()) {
        kept_.push_back({piece.q_lo, piece.q_hi});
    }
}

/// With more bits than tell numbers so far apart from each other.
std::vector<Halving::Maximum> Halving::maxima_at(const std::vector<Rational>& ratios, int bits) const {
    const auto& bounds = row_of(claim_.system.section).bounds;
    std::vector<Maximum> maxima(ratios.size());
    in_parallel(ratios.size(), [&](std::size_t i) {
        const PrecisionScope scope(std::max(bits, double_bits));
        const auto find = [&](const auto& search) {
            return search.maximum(ratios[i], claim_.system, interrupted_);
        };
        if (!interrupted_()) {
            maxima[i] = bits > double_bits ? find(std::get<BoundSearch<BigInterval>>(bounds))
                                           : find(std::get<BoundSearch<Interval>>(bounds));
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

/// At short decimals.
std::vector<Halving::Part> Halving::halves_of(const std::vector<Part>& parts) const {
    std::vector<Rational> middles;
    double finest = 1;
    for (const auto& [range, at_lo, at_hi] : parts) {
        const double share = Rational((range.hi - range.lo) / range.hi).convert_to<double>();
        const Rational middle = (range.lo + range.hi) / 2;
        middles.push_back(exact(cut_down(middle, 3 - static_cast<int>(std::log10(share)))));
        finest = std::min(finest, share);
    }
    const auto maxima = maxima_at(middles, -2 * std::ilogb(finest));
    std::vector<Part> halves;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto& [range, at_lo, at_hi] = parts[i];
        halves.push_back({{range.lo, middles[i]}, at_lo, maxima[i]});
        halves.push_back({{middles[i], range.hi}, maxima[i], at_hi});
    }
    return halves;
}

/// Neighbours of one value, where nothing lies in between: L83.
void Halving::merge_equal() {
    std::ranges::sort(tried_, {}, [](const Part& part) { return part.range.lo; });
    std::vector<Part> merged;
    for (Part& part : tried_) {
        const auto has_one = [&](const Part& other) {
            return other.at_lo == part.at_hi && other.at_hi == part.at_hi;
        };
        if (!merged.empty() && has_one(merged.back()) && has_one(part)) {
            merged.back().range.hi = part.range.hi;
        } else {
            merged.push_back(std::move(part));
        }
    }
    tried_ = std::move(merged);
}

std::vector<PlannedPiece> Halving::next(std::vector<ProvedPiece>& proved) {
    std::vector<Part> parts, failed;
    const bool is_first = !std::exchange(begun_, true);
    if (is_first) {
        const auto ends = maxima_at({claim_.range.lo, claim_.range.hi}, double_bits);
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
    if (is_first && row_of(claim_.system.section).is_monotone) {
        merge_equal();
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
