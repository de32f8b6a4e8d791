#include "collisions/cells.hpp"

#include <algorithm>

#include "collisions/piece_lines.hpp"
#include "file/dyadic.hpp"
#include "file/limits.hpp"
#include "flight/corner.hpp"

namespace dumbbell::collisions {
namespace {

/// The certificate of a rectangle, cell by cell.
class Cutter : SealedLines {
  public:
    explicit Cutter(const Interrupted& interrupted) : interrupted_(interrupted) {}

    Cells cut(const Rectangle& whole) && {
        head({}, "body", "body", "cells", "collisions");
        line("ratio {} {}", to_fraction(whole.q.lo), to_fraction(whole.q.hi));
        line("rho {} {}", to_fraction(whole.rho.lo), to_fraction(whole.rho.hi));
        line("bits {}", bits);
        node(whole, 0);
        line("total split {}\ntotal cell {}\ntotal open {}", splits_, found_.cells, open_);
        if (open_ > 0) {
            found_.upper = std::nullopt;
            found_.lower = 0;
        }
        found_.certificate = std::move(*this).sealed();
        return std::move(found_);
    }

  private:
    static constexpr int bits = 96;  // the verifiers evaluate in another way
    static constexpr int deepest = 20;
    static constexpr long most_splits = 2000;

    void node(const Rectangle& box, int depth) {
        const LowerBound lower = least_collisions(box, interrupted_);
        long most = lower.bound;
        auto upper = at_most(most, box, interrupted_);
        if (!upper) {
            const auto [fewest, seen] = at_corners(box);
            if (fewest == seen && depth < deepest && splits_ < most_splits && box.rho.lo < box.rho.hi) {
                const Rational middle = (box.rho.lo + box.rho.hi) / 2;
                line("split rho");
                ++splits_;
                node({{box.rho.lo, middle}, box.q}, depth + 1);
                node({{middle, box.rho.hi}, box.q}, depth + 1);
                return;
            }
            constexpr long beyond = 4;
            for (most = std::max(most + 1, seen); !upper && most <= seen + beyond; ++most) {
                upper = at_most(most, box, interrupted_);
            }
            --most;
        }
        if (upper) {
            cell(most, *upper, lower);
        } else {
            line("open");
            ++open_;
        }
    }

    /// The fewest and the most collisions that the bodies at its corners seem to have.
    [[nodiscard]] std::pair<long, long> at_corners(const Rectangle& box) const {
        const auto at = [&](const Rational& rho, const Rational& q) {
            return least_collisions({{rho, rho}, {q, q}}, interrupted_).bound;
        };
        return std::minmax({at(box.rho.lo, box.q.lo), at(box.rho.hi, box.q.lo), at(box.rho.lo, box.q.hi),
                            at(box.rho.hi, box.q.hi)});
    }

    void cell(long most, const UpperBound& upper, const LowerBound& lower) {
        line("cell {} {} {} {} {}", most, lower.bound, lower.j, to_dyadic(lower.p), to_text(upper));
        found_.lower = found_.cells == 0 ? lower.bound : std::min(found_.lower, lower.bound);
        found_.upper = std::max(found_.upper.value_or(0), most);
        ++found_.cells;
    }

    const Interrupted& interrupted_;
    Cells found_;
    long splits_ = 0, open_ = 0;
};

}  // namespace

bool is_within_reach(const Rectangle& bodies) {
    return flight::corner_count(bodies.rho.hi, bodies.q.hi, most_in_corner) <= most_in_corner;
}

Cells prove_cells(const Rectangle& bodies, const Interrupted& interrupted) {
    return Cutter(interrupted).cut(bodies);
}

}  // namespace dumbbell::collisions
