#include <fmt/format.h>

#include <algorithm>

#include "collisions/leaf.hpp"
#include "collisions/section.hpp"
#include "collisions/writer.hpp"
#include "mutations.hpp"
#include "starts/answer/writer.hpp"

namespace dumbbell_mutation {
namespace {

using namespace dumbbell;
using namespace dumbbell::collisions;

/// A tree that is as good as it gets for the bound: what does not close within `depth` splits is a leaf
/// `count` all the same, with hints that fit the bound.
void best_tree(Chart chart, const Box& box, const Count& upper, int depth, Tree& tree) {
    auto leaf = judge<Interval>(chart, box, upper);
    if (!leaf && depth == 0) {
        leaf = judge<Interval>(chart, box, upper + 1);
        const Count forward = leaf ? std::clamp<Count>(leaf->forward, 0, upper - 1) : upper - 1;
        leaf = Leaf{chart == Chart::again ? Reason::once : Reason::count, forward, upper - 1 - forward};
    }
    if (leaf) {
        tree.push_back({std::nullopt, *leaf});
        return;
    }
    const bool position =
        width(box[Axis::position].lo, box[Axis::position].hi) * approximate(box[Axis::ratio].hi) >=
        width(box[Axis::slope].lo, box[Axis::slope].hi);
    const bool ratio = width(box[Axis::ratio].lo, box[Axis::ratio].hi) * 8 > approximate(box[Axis::ratio].lo);
    const Axis axis = ratio ? Axis::ratio : position ? Axis::position : Axis::slope;
    const auto [low, high] = halves(box, axis);
    tree.push_back({axis, {}});
    best_tree(chart, low, upper, depth - 1, tree);
    best_tree(chart, high, upper, depth - 1, tree);
}

class Claims {
  public:
    Claims(const Certificate& data, const Sink& sink) : data_(data), sink_(sink) {}

    void run() {
        for (std::size_t i = 0; i < data_.pieces.size(); ++i) {
            bounds(i);
            for (const int bits : bit_counts)
                change(i, "bits", std::to_string(bits), [&](Piece& p) { p.bits = bits; });
            if (i + 1 < data_.pieces.size()) merge(i);
        }
        ranges();
        for (int i = 0; i <= static_cast<int>(Section::plain_body); ++i) {
            Certificate changed = data_;
            changed.system.section = static_cast<Section>(i);
            give("section", fmt::format("{}", i), changed);
        }
    }

  private:
    void give(std::string_view kind, const std::string& what, const Certificate& changed) {
        sink_({kind, what, render(changed).text});
    }
    template <class Change>
    void change(std::size_t i, std::string_view kind, const std::string& what, Change apply) {
        Certificate changed = data_;
        apply(changed.pieces[i]);
        give(kind, fmt::format("piece {}: {}", i + 1, what), changed);
    }
    static void without_lower(Piece& piece) {
        piece.lower = 0;
        piece.witness.reset();
    }

    void bounds(std::size_t i) {
        const Piece& piece = data_.pieces[i];
        change(i, "weaker claim", "no lower bound", without_lower);
        change(i, "weaker claim", "no upper bound", [](Piece& p) { p.upper.reset(); });
        change(i, "weaker claim", "neither", [](Piece& p) {
            p.upper.reset();
            without_lower(p);
        });
        for (const int side : {0, 1, 2})
            change(i, "one more attained", fmt::format("hint {}", side), [&](Piece& p) {
                ++p.lower;
                if (!p.witness) p.witness = Witness{Rational(1, 2), Rational(1, 4)};
                if (p.upper) p.upper = std::max(*p.upper, p.lower);
                if (p.witness && side > 0) ++(side == 1 ? p.witness->forward : p.witness->backward);
            });
        if (!piece.upper) return;
        for (const long less : {1L, 2L}) {
            change(i, "N less, same tree", std::to_string(less), [&](Piece& p) {
                *p.upper -= less;
                without_lower(p);
            });
            for (const bool forward : {true, false})
                change(i, "N less, hints less", fmt::format("{} {}", less, forward), [&](Piece& p) {
                    *p.upper -= less;
                    without_lower(p);
                    for (ChartTree& chart : p.cover.charts)
                        for (Node& node : chart.tree)
                            if (dumbbell::Count& hint = forward ? node.leaf.forward : node.leaf.backward;
                                1 + node.leaf.forward + node.leaf.backward > *p.upper)
                                hint = std::max<Count>(0, hint - less);
                });
        }
        for (const int depth : {0, 1, 2, 3, 4, 6, 8})
            if (*piece.upper > 1)
                change(i, "N less, best tree", fmt::format("depth {}", depth), [&](Piece& p) {
                    --*p.upper;
                    without_lower(p);
                    p.cover = {};
                    for (const Chart chart : row_of(data_.system.section).charts) {
                        p.cover.charts.push_back({chart, {}});
                        Box root = root_box(chart, p.q_lo, p.q_hi);
                        root.rho = data_.system.rho.value_or(0);
                        best_tree(chart, root, *p.upper, depth, p.cover.charts.back().tree);
                    }
                });
        change(i, "lemma L7", "instead of the cover",
               [](Piece& p) { p.cover = Cover{.equal_masses = true, .charts = {}}; });
    }

    /// One piece for the ranges of two, with everything of either.
    void merge(std::size_t i) {
        for (const bool first : {true, false}) {
            Certificate changed = data_;
            Piece &low = changed.pieces[i], &high = changed.pieces[i + 1];
            high.q_lo = low.q_lo;
            low.q_hi = high.q_hi;
            if (first) high = low;
            changed.pieces.erase(changed.pieces.begin() + static_cast<std::ptrdiff_t>(i));
            give("pieces merged",
                 fmt::format("{} and the next, with the cover of the {}", i + 1, first ? "first" : "second"),
                 changed);
        }
    }

    /// The first piece begins earlier, the last ends later, or all that is said is said of another ratio.
    void ranges() {
        for (const char* step : steps)
            for (const int sides : {1, 2, 3, 4, 5}) {
                Certificate changed = data_;
                Rational &lo = changed.pieces.front().q_lo, &hi = changed.pieces.back().q_hi;
                const Rational wide = 1 + parse_rational(step);
                if (sides == 1 || sides == 3) lo = std::max(Rational(1), lo / wide);
                if (sides == 2 || sides == 3) hi *= wide;
                if (sides > 3) {
                    if (changed.pieces.size() > 1) continue;
                    hi = lo = sides == 4 ? Rational(hi * wide) : std::max(Rational(1), lo / wide);
                }
                give(sides > 3 ? "another ratio" : "wider range", fmt::format("{} sides {}", step, sides),
                     changed);
            }
    }

    const Certificate& data_;
    const Sink& sink_;
};

void claims_of(const starts::Certificate& data, const Sink& sink) {
    const auto give = [&](std::string_view kind, const std::string& what,
                          const starts::Certificate& changed) {
        sink({kind, what, render(changed).text});
    };
    // All incoming trajectories have nothing to choose but the ratio.
    for (std::size_t axis = data.incoming ? starts::axis_count - 1 : 0; axis < starts::axis_count; ++axis)
        for (const char* step : steps)
            for (const int sides : {1, 2, 3, 4, 5}) {
                starts::Certificate changed = data;
                Rational &lo = changed.box.lo[axis], &hi = changed.box.hi[axis];
                const Rational width = hi > lo ? Rational(hi - lo) : Rational(1);
                const Rational reach = parse_rational(step) * width;
                if (sides == 1 || sides >= 3) lo += sides == 4 ? reach : Rational(-reach);
                if (sides == 2 || sides >= 3) hi += sides == 5 ? Rational(-reach) : reach;
                if (lo > hi || (axis == starts::axis_count - 1 && lo <= 0)) continue;
                give(sides > 3 ? "box moved" : "wider box",
                     fmt::format("axis {} {} sides {}", axis, step, sides), changed);
            }
    for (const int bits : bit_counts) {
        starts::Certificate changed = data;
        changed.bits = bits;
        give("bits", std::to_string(bits), changed);
    }
    for (const long more : {-1L, 1L}) {
        starts::Certificate changed = data;
        for (starts::Node& node : changed.tree)
            if (!node.split && node.leaf.most) {
                node.leaf.least = std::max(0L, node.leaf.least + more);
                *node.leaf.most = std::max(0L, *node.leaf.most + more);
            }
        give("all counts", std::to_string(more), changed);
    }
}

}  // namespace

void claim_mutations(const Base& base, const Sink& sink) {
    if (const auto* data = std::get_if<Certificate>(&base.data))
        Claims(*data, sink).run();
    else if (const auto* adiabatic = std::get_if<adiabatic::Certificate>(&base.data))
        adiabatic_claim_mutations(*adiabatic, sink);
    else
        claims_of(std::get<starts::Certificate>(base.data), sink);
}

}  // namespace dumbbell_mutation
