#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace dumbbell::adiabatic {

/// The potential V of L35: the integral over u, from the rod's angle from the vertical to pi/2, of a density
/// v >= 0 that is constant on cells.
template <class I>
class Potential {
  public:
    /// v >= 0 on [u, the cell before's u]; the first begins at 11/7 > pi/2. Thin or almost so.
    struct Cell {
        I u;
        I v;
    };
    static I top() { return I(11) / I(7); }

    /// Precondition: at least one cell, their u decrease.
    explicit Potential(std::vector<Cell> cells) : cells_(std::move(cells)) {
        I sum(0);
        I upper = top();
        for (const Cell& cell : cells_) {
            upper_.push_back(upper);
            sums_.push_back(sum);
            sum = sum + cell.v * (upper - cell.u);
            upper = cell.u;
        }
    }

    /// A lower bound of v on all of the interval u.
    [[nodiscard]] I least_density(const I& u) const {
        if (!certainly_less(cells_.back().u, u) && !certainly_at_most(cells_.back().u, u)) {
            return I(0);
        }
        I least = cells_[first_below(high_end(u))].v;
        for (std::size_t i = first_below(high_end(u)) + 1; i < cells_.size(); ++i) {
            if (certainly_less(upper_[i], u)) {
                break;
            }
            least = min(least, cells_[i].v);
        }
        return low_end(least);
    }

    /// An upper bound of V at every angle of the interval u.
    [[nodiscard]] I greatest_value(const I& u) const {
        const std::size_t i = first_below(low_end(u));
        const I reach = max(low_end(u), low_end(cells_[i].u));
        return high_end(sums_[i] + cells_[i].v * max(I(0), upper_[i] - reach));
    }

  private:
    /// The first cell that may reach below u, or the last one.
    [[nodiscard]] std::size_t first_below(const I& u) const {
        const auto above = [&](const Cell& cell) { return certainly_less(u, cell.u); };
        return static_cast<std::size_t>(std::partition_point(cells_.begin(), cells_.end() - 1, above) -
                                        cells_.begin());
    }

    std::vector<Cell> cells_;
    std::vector<I> upper_;  ///< where each cell begins
    std::vector<I> sums_;   ///< V there
};

}  // namespace dumbbell::adiabatic
