// The potential V of a class (L35): v >= 0, piecewise constant in u, the rod's distance from the vertical.
#pragma once
#include <gmpxx.h>

#include <algorithm>
#include <type_traits>
#include <vector>

#include "verify/core/interval.hpp"

namespace dumbbell_verify::adiabatic {

/// V(u), the integral of v from u to the first cell's top, which is at least pi/2; below the last cell v = 0.
/// Kept in doubles that are rounded to the safe side.
class Potential {
  public:
    explicit Potential(const mpq_class& top) : top_(bound(up, top, 0.0)) {}

    /// The next cell downwards: v on [low, the low of the cell before]; v >= 0.
    void add_cell(const mpq_class& low, const mpq_class& v) {
        const double above = cells_.empty() ? 0 : cells_.back().above_low;
        const double high = cells_.empty() ? top_ : cells_.back().low_up;
        Cell cell{bound(down, low, 0.0),
                  bound(up, low, 0.0),
                  high,
                  std::max(0.0, bound(down, v, 0.0)),
                  bound(up, v, 0.0),
                  above,
                  0};
        cell.above_low = add(up, above, area(cell, cell.low_down));
        cells_.push_back(cell);
    }
    [[nodiscard]] std::size_t size() const { return cells_.size(); }

    /// At least V at every u >= from.
    template <class N>
    [[nodiscard]] N upper(const N& from) const {
        const double u = to_double(down, from);
        const auto cell =
            std::partition_point(cells_.begin(), cells_.end(), [&](const Cell& c) { return c.low_up > u; });
        if (cell == cells_.end()) return number<N>(up, cells_.empty() ? 0 : cells_.back().above_low);
        return number<N>(up, add(up, cell->above_high, area(*cell, u)));
    }
    /// At most v at every u of the interval, which does not reach beyond the first cell's top.
    template <class N>
    [[nodiscard]] N least(const Interval<N>& u) const {
        const double from = to_double(down, u.lo), until = to_double(up, u.hi);
        if (cells_.empty() || from < cells_.back().low_up) return N(0);
        const auto first = std::partition_point(cells_.begin(), cells_.end(),
                                                [&](const Cell& c) { return c.low_down > until; });
        double v = HUGE_VAL;
        for (auto cell = first; cell != cells_.end() && cell->high >= from; ++cell)
            v = std::min(v, cell->v_down);
        return v < HUGE_VAL ? number<N>(down, v) : N(0);
    }

  private:
    struct Cell {
        double low_down, low_up, high;  ///< high: rounded up
        double v_down, v_up;
        double above_high, above_low;  ///< upper bounds of V at the cell's ends
    };

    /// At least v times the length of the part of the cell above u.
    static double area(const Cell& cell, double u) {
        return mul(up, cell.v_up, std::max(0.0, add(up, cell.high, -u)));
    }
    /// A bound as a number: exactly, unless N has fewer bits than a double. What is too large for a double is
    /// unbounded.
    template <class N>
    static N number(Round d, double x) {
        if constexpr (std::is_same_v<N, double>)
            return x;
        else
            return std::isfinite(x) ? bound(d, mpq_class(x), N(0)) : div(d, N(1), N(0));
    }

    double top_;
    std::vector<Cell> cells_;
};

}  // namespace dumbbell_verify::adiabatic
