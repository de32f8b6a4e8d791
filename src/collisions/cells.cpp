#include "collisions/cells.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "collisions/names.hpp"
#include "file/dyadic.hpp"
#include "file/limits.hpp"
#include "flight/corner.hpp"
#include "flight/outward.hpp"
#include "number/parallel.hpp"

namespace dumbbell::collisions {
namespace {

using flight::Ray;

/// The places (0, hi) where something is not yet so, and from some place on is: the ends of a short stretch
/// between them. A guess; `is_so` is asked about it again.
template <class IsSo>
std::pair<double, double> threshold(double hi, const IsSo& is_so) {
    constexpr double least = 1e-18;
    double lo = 0;
    while (hi - lo > 1e-15 * hi && hi > least) {
        const double middle = lo == 0 ? hi / 8 : hi > 4 * lo ? std::sqrt(lo * hi) : lo + (hi - lo) / 2;
        if (middle <= lo || middle >= hi) {
            break;
        }
        (is_so(middle) ? hi : lo) = middle;
    }
    return {lo, hi};
}

/// The shortest dyadic near p, on the side to which it is rounded, that is as good: files spell it.
template <class Round, class IsGood>
double shortest(double p, Round round, const IsGood& is_good) {
    for (int places = 2; places < 60; places += 2) {
        const int exponent = std::ilogb(p) - places;
        const double shorter = std::ldexp(round(std::ldexp(p, -exponent)), exponent);
        if (shorter > 0 && is_good(shorter)) {
            return shorter;
        }
    }
    return p;
}

/// A side of a rectangle: all rho, one Q.
class Edge {
  public:
    Edge(const Rectangle& bodies, const Rational& q, const Interrupted& interrupted)
        : least_(enclose<Interval>(bodies.rho.lo)),
          greatest_(enclose<Interval>(bodies.rho.hi)),
          r_(enclose<Interval>(1 / q)),
          cap_(static_cast<long>(2 * std::sqrt(q.convert_to<double>())) + 10),  // L84 (a)
          interrupted_(interrupted) {}

    /// k0 and the even motion of Theorem B, from below.
    [[nodiscard]] long top() const { return count({high_end(greatest_), Interval(0), high_end(r_)}); }
    [[nodiscard]] long through_corner() const {
        const Ray<Interval> along{Interval(0), high_end(greatest_), high_end(r_)};
        const auto out = flight::reflect_at_light_wall(high_end(-least_), Interval(1), high_end(r_));
        if (!certainly_positive(out.denominator)) {
            return 0;
        }
        const Ray<Interval> even{Interval(0), high_end(out.numerator / out.denominator), high_end(r_)};
        return std::min(count(flight::over_bridge(along)), count(flight::over_bridge(even)));
    }
    /// f(e_j) of all, from below, if j <= J.
    [[nodiscard]] std::pair<long, double> orbit_from_below(long j) const {
        const auto passes = [&](double p, bool if_there_is_none = false) {
            const auto behind = flight::outward_from_below(j, Interval(p), greatest_, r_);
            return behind ? flight::passes_bridge(*behind, greatest_) : if_there_is_none;
        };
        const auto collisions = [&](double p) {
            const auto behind = flight::outward_from_above(j, Interval(p), least_, r_);
            return behind ? count(flight::over_bridge(*behind)) : -1;
        };
        // R is as high as 1 for all of them, the bridge only as the least one's.
        const double p = threshold(j % 2 != 0 ? greatest_.hi() : least_.lo(), [&](double x) {
                             return passes(x, true);
                         }).second;
        const long found = passes(p) ? collisions(p) : -1;
        return {found, shortest(
                           p, [](double x) { return std::ceil(x); },
                           [&](double x) { return passes(x) && collisions(x) == found; })};
    }

    /// k0, and f(e_j) of all that have so many hits in the valley, each from above; most + 1: it is not
    /// certain that it is at most `most`.
    [[nodiscard]] long top_at_most(long most) const {
        return at_most({low_end(least_), Interval(0), low_end(r_)}, most);
    }
    [[nodiscard]] std::pair<long, double> orbit_from_above(long j, long most) const {
        const auto misses = [&](double p) {
            const auto behind = flight::outward_from_above(j, Interval(p), least_, r_);
            return !behind || !flight::hits_bridge(*behind, least_);
        };
        const auto collisions = [&](double p) {
            const auto behind = flight::outward_from_below(j, Interval(p), greatest_, r_);
            return behind ? at_most(flight::over_bridge(*behind), most) : most + 1;
        };
        const double p = threshold(least_.lo(), misses).first;
        const long found = collisions(p);
        return {found, p == 0 ? p
                              : shortest(
                                    p, [](double x) { return std::floor(x); },
                                    [&](double x) { return !misses(x) && collisions(x) <= found; })};
    }
    /// T, from above, if J is `hits`.
    [[nodiscard]] long even_at_most(long hits, long most) const {
        return flight::even_at_most(hits, greatest_, r_, most, interrupted_);
    }

  private:
    [[nodiscard]] long count(const Ray<Interval>& highest) const {
        return count_at_least(highest, cap_, interrupted_);
    }
    [[nodiscard]] long at_most(const Ray<Interval>& lowest, long most) const {
        return count_at_most(lowest, most, interrupted_);
    }

    Interval least_, greatest_, r_;
    long cap_;
    const Interrupted& interrupted_;
};

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
        std::string text = fmt::format("cell {} {} {} {} {}", most, lower.bound, lower.j,
                                       to_dyadic(exact(lower.p)), upper.end);
        for (const auto& [x, p] : upper.orbits) {
            text += fmt::format(" {} {}", x, to_dyadic(exact(p)));
        }
        line("{}", text);
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

LowerBound least_collisions(const Rectangle& bodies, const Interrupted& interrupted) {
    const Edge edge(bodies, bodies.q.lo, interrupted);
    const long near = flight::corner_count(bodies.rho.lo, bodies.q.lo, most_in_corner);
    LowerBound best{near};
    const auto take = [&best](const LowerBound& found) { best = found.bound > best.bound ? found : best; };
    take({1 + 2 * edge.top()});
    take({2 + 2 * edge.through_corner()});
    const long hits = (near - 1) / 2;
    for (const long j : {1L, hits}) {  // seen: others have no more (body.md)
        if (j > 0 && j <= hits) {
            const auto [beyond, p] = edge.orbit_from_below(j);
            take({2 * j + 1 + 2 * beyond, j, p});
        }
    }
    return best;
}

std::optional<UpperBound> at_most(long upper, const Rectangle& bodies, const Interrupted& interrupted) {
    const Edge edge(bodies, bodies.q.hi, interrupted);
    const long near = flight::corner_count(bodies.rho.hi, bodies.q.hi, most_in_corner),
               half = (upper - 1) / 2;
    UpperBound found{(near + 1) / 2, {}};
    long beyond = bodies.rho.lo == 1 ? 0 : edge.top_at_most(half);
    if (beyond > half) {
        return std::nullopt;
    }
    for (long x = half + 1 - beyond; x < found.end; x = half + 1 - beyond) {
        const auto [collisions, p] = edge.orbit_from_above(x, half - x);
        if (collisions > half - x) {
            return std::nullopt;
        }
        found.orbits.emplace_back(x, p);
        beyond = collisions;
    }
    const long last = half + 1 - found.end;
    const bool may_be_even =
        upper % 2 == 1 && near % 2 == 0 && edge.even_at_most(found.end - 1, last) >= last;
    return may_be_even ? std::nullopt : std::optional(found);
}

bool is_within_reach(const Rectangle& bodies) {
    return flight::corner_count(bodies.rho.hi, bodies.q.hi, most_in_corner) <= most_in_corner;
}

Cells prove_cells(const Rectangle& bodies, const std::optional<double>& wanted,
                  const Interrupted& interrupted, Observer& observer) {
    return Cutter(wanted, interrupted, observer).cut(bodies);
}

}  // namespace dumbbell::collisions
