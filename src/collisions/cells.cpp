#include "collisions/cells.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "collisions/piece_lines.hpp"
#include "file/dyadic.hpp"
#include "file/limits.hpp"
#include "flight/corner.hpp"
#include "number/parallel.hpp"

namespace dumbbell::collisions {
namespace {

/// The length of a side in logs; of a single number 1.
double extent(const Range& side) {
    return side.is_single() ? 1 : std::log1p(Rational((side.hi - side.lo) / side.lo).convert_to<double>());
}
double area(const Rectangle& box) { return extent(box.rho) * extent(box.q); }

/// A tree of cells that grows where it is not decided, the greatest cells first, and its certificate.
class Cutter : SealedLines {
  public:
    Cutter(const std::optional<double>& wanted, const Interrupted& interrupted, Observer& observer)
        : wanted_(wanted), interrupted_(interrupted), observer_(observer) {}

    Cells cut(const Rectangle& whole) && {
        const std::size_t most_nodes = wanted_ ? 2'000'000 : 4'000;
        counted_ = area(whole);
        nodes_.push_back({.box = whole});
        judge_from(0);
        while (!waiting_.empty() && share() < wanted_.value_or(1) && nodes_.size() < most_nodes &&
               !interrupted_()) {
            judge_from(halve_greatest());
        }
        head({}, "body", "body", "cells", "collisions");
        line("ratio {} {}", to_fraction(whole.q.lo), to_fraction(whole.q.hi));
        line("rho {} {}", to_fraction(whole.rho.lo), to_fraction(whole.rho.hi));
        line("bits {}", bits);
        write(nodes_[0]);
        line("total split {}\ntotal cell {}\ntotal beyond {}\ntotal open {}", nodes_.size() / 2, found_.cells,
             beyond_, open_);
        if (open_ + beyond_ > 0) {
            found_.upper = std::nullopt;
            found_.lower = 0;
        }
        found_.share = share();
        found_.certificate = std::move(*this).sealed();
        return std::move(found_);
    }

  private:
    static constexpr int bits = 96;               // the verifiers evaluate in another way
    static constexpr std::size_t together = 256;  // whatever the threads: the tree is the same
    static constexpr int deepest = 60;

    struct Node {
        Rectangle box;
        int depth = 0;
        bool is_beyond = false;
        LowerBound lower{};
        long most = 0;
        std::optional<UpperBound> upper{};
        Range Rectangle::*side = nullptr;  ///< to be halved; none if it is decided, or one number is wanted
        std::size_t halves = 0;            ///< the lower one; the upper one follows
    };

    /// Rounded down, by more than the roundings of doubles.
    [[nodiscard]] double share() const { return counted_ > 0 ? decided_ / counted_ - 1e-9 : 0; }

    std::size_t halve_greatest() {
        const std::size_t first = nodes_.size();
        for (std::size_t i = 0; i < together && !waiting_.empty(); ++i) {
            const std::size_t chosen = waiting_.extract(waiting_.begin()).value().second;
            nodes_[chosen].halves = nodes_.size();
            for (const bool is_upper : {false, true}) {
                Node half{.box = nodes_[chosen].box, .depth = nodes_[chosen].depth + 1};
                Range& range = half.box.*nodes_[chosen].side;
                (is_upper ? range.lo : range.hi) = (range.lo + range.hi) / 2;
                nodes_.push_back(std::move(half));
            }
        }
        return first;
    }

    void judge_from(std::size_t first) {
        in_parallel(nodes_.size() - first, [&](std::size_t i) { judge(nodes_[first + i]); });
        observer_.advance(nodes_.size() - first);
        for (std::size_t i = first; i < nodes_.size(); ++i) {
            const Node& node = nodes_[i];
            decided_ += node.upper && node.most == node.lower.bound ? area(node.box) : 0;
            counted_ -= node.is_beyond ? area(node.box) : 0;
            if (node.side != nullptr && !(node.box.*node.side).is_single() && node.depth < deepest) {
                // In single precision: areas that are equal but for roundings come in the order of the nodes.
                waiting_.emplace(-static_cast<float>(area(node.box)), i);
            }
        }
    }

    void judge(Node& node) const {
        const auto& [rho, q] = node.box;
        const auto longer =
            !rho.is_single() && (q.is_single() || extent(rho) > extent(q)) ? &Rectangle::rho : &Rectangle::q;
        node.is_beyond = wanted_ && rho.hi * q.hi <= 1;
        if (wanted_ && rho.lo * q.lo < 1) {
            node.side = node.is_beyond ? nullptr : longer;
            return;
        }
        node.lower = least_collisions(node.box, interrupted_);
        node.most = node.lower.bound;
        node.upper = at_most(node.most, node.box, interrupted_);
        if (node.upper) {
            return;
        }
        // Where it is one number, the width in rho alone is in the way (L87).
        const auto [fewest, seen] = at_corners(node.box);
        node.side = fewest == seen && !rho.is_single() ? &Rectangle::rho : wanted_ ? longer : nullptr;
        constexpr long beyond = 4;
        node.most = std::max(node.most, seen - 1);
        do {
            node.upper = at_most(++node.most, node.box, interrupted_);
        } while (!node.upper && node.most < seen + beyond);
    }

    /// The fewest and the most collisions that the bodies at its corners seem to have.
    [[nodiscard]] std::pair<long, long> at_corners(const Rectangle& box) const {
        const auto at = [&](const Rational& rho, const Rational& q) {
            return least_collisions({{rho, rho}, {q, q}}, interrupted_).bound;
        };
        return std::minmax({at(box.rho.lo, box.q.lo), at(box.rho.hi, box.q.lo), at(box.rho.lo, box.q.hi),
                            at(box.rho.hi, box.q.hi)});
    }

    void write(const Node& node) {
        if (node.halves > 0) {
            line("split {}", node.side == &Rectangle::rho ? "rho" : "q");
            write(nodes_[node.halves]);
            write(nodes_[node.halves + 1]);
        } else if (node.upper) {
            cell(node.most, *node.upper, node.lower);
        } else {
            line("{}", node.is_beyond ? "beyond" : "open");
            ++(node.is_beyond ? beyond_ : open_);
        }
    }

    void cell(long most, const UpperBound& upper, const LowerBound& lower) {
        line("cell {} {} {} {} {}", most, lower.bound, lower.j, to_dyadic(lower.p), to_text(upper));
        found_.lower = found_.cells == 0 ? lower.bound : std::min(found_.lower, lower.bound);
        found_.upper = std::max(found_.upper.value_or(0), most);
        ++found_.cells;
    }

    std::optional<double> wanted_;
    const Interrupted& interrupted_;
    Observer& observer_;
    Cells found_;
    std::vector<Node> nodes_;
    std::set<std::pair<float, std::size_t>> waiting_;  ///< to be halved, the greatest first
    double decided_ = 0, counted_ = 0;                 ///< areas in (log rho, log Q)
    long beyond_ = 0, open_ = 0;
};

}  // namespace

bool is_within_reach(const Rectangle& bodies) {
    return flight::corner_count(bodies.rho.hi, bodies.q.hi, most_in_corner) <= most_in_corner;
}

Cells prove_cells(const Rectangle& bodies, const std::optional<double>& wanted,
                  const Interrupted& interrupted, Observer& observer) {
    return Cutter(wanted, interrupted, observer).cut(bodies);
}

}  // namespace dumbbell::collisions
