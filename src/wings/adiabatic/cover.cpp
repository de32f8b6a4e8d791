#include "adiabatic/cover.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/growing_tree.hpp"
#include "number/parallel.hpp"

namespace dumbbell::adiabatic {
namespace {

struct Place {
    std::optional<Axis> split;
    Judged leaf{};
};
using Growing = GrowingTree<Place, Box, axis_count>;

constexpr std::array<Axis, axis_count> all_axes{Axis::u, Axis::sigma, Axis::s, Axis::v, Axis::delta};

/// How wide a side is for what happens in the box: angles count relatively.
double weight(const Box& box, Axis axis) {
    const double width = box.width(axis);
    const double end = box.hi[static_cast<std::size_t>(axis)];
    switch (axis) {
        case Axis::u:
        case Axis::v:
            return width / end;
        case Axis::sigma:
            return width / (1 + end);
        default:
            return width / 2;
    }
}

class Growth {
  public:
    Growth(const Box& root, const Judge& judge, const Target& target, const Limits& limits)
        : tree_(root), judge_(judge), target_(target), limits_(limits) {}

    std::optional<Cover> grow() {
        for (std::size_t leaves = 1; !tree_.boxes().empty(); tree_.next_generation()) {
            judge_generation();
            if (limits_.interrupted() || std::ranges::any_of(now_, &Open::hopeless)) {
                return std::nullopt;
            }
            const double enough =
                target_.fixed ? target_.goal : std::max(target_.goal, best_ * (1 + target_.slack));
            choose_axes(enough);
            for (std::size_t i = 0; i < now_.size(); ++i) {
                const Judged& judged = now_[i].judged;
                const bool closed = judged.outside || judged.bound <= enough;
                if (!closed && now_[i].split && leaves < limits_.max_leaves) {
                    ++leaves;
                    tree_.split(i, *now_[i].split, tree_.boxes()[i].halves(*now_[i].split));
                    continue;
                }
                if (!closed && (target_.fixed || !std::isfinite(judged.bound))) {
                    return std::nullopt;
                }
                bound_ = judged.outside ? bound_ : std::max(bound_, judged.bound);
                tree_.close(i, judged);
            }
        }
        return finished();
    }

  private:
    struct Open {
        Judged judged;
        double at_centre = 0;
        bool hopeless = false;  ///< no box around its centre can be closed
        std::optional<Axis> split;
    };

    template <class Work>
    void each(const Work& work) {
        in_parallel(now_.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i != end && !limits_.interrupted(); ++i) {
                work(i);
            }
            limits_.observer->enter("covering all of them", "boxes");
            limits_.observer->advance(end - begin);
        });
    }

    void judge_generation() {
        now_.assign(tree_.boxes().size(), {});
        each([&](std::size_t i) {
            const Box& box = tree_.boxes()[i];
            now_[i].judged = judge_(box);
            if (now_[i].judged.outside || (target_.fixed && now_[i].judged.bound <= target_.goal)) {
                return;
            }
            const Judged centre = judge_(box.centre());
            if (!centre.outside) {
                now_[i].hopeless = target_.fixed ? centre.bound > target_.goal : std::isinf(centre.bound);
                now_[i].at_centre = centre.bound;
            }
        });
        for (const Open& box : now_) {
            best_ = std::max(best_, box.at_centre);
        }
    }

    /// For the boxes that are not closed: the axis along which a box of width 0 has the least bound.
    void choose_axes(double enough) {
        each([&](std::size_t i) {
            if (now_[i].judged.outside || now_[i].judged.bound <= enough) {
                return;
            }
            const Box& box = tree_.boxes()[i];
            double least = 0;
            double widest = 0;
            for (const Axis axis : all_axes) {
                if (!(box.width(axis) > 0) ||
                    tree_.depths(i)[static_cast<std::size_t>(axis)] >= limits_.max_depth) {
                    continue;
                }
                const Judged slice = judge_(box.collapsed(axis));
                const double bound = slice.outside ? std::min(0.0, enough) : slice.bound;
                const double wide = weight(box, axis);
                if (!now_[i].split || bound < least || (bound == least && wide > widest)) {
                    now_[i].split = axis;
                    least = bound;
                    widest = wide;
                }
            }
        });
    }

    [[nodiscard]] std::optional<Cover> finished() {
        Cover cover{{}, bound_, 0};
        for (const Place& node : std::move(tree_).pre_order()) {
            cover.tree.push_back({node.split, !node.split && node.leaf.outside, node.leaf.by_class});
            cover.leaves += node.split ? 0 : 1;
        }
        return cover;
    }

    Growing tree_;
    const Judge& judge_;
    const Target& target_;
    const Limits& limits_;
    std::vector<Open> now_;
    double best_ = 0;
    double bound_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

std::optional<Cover> find_cover(const Box& root, const Judge& judge, const Target& target,
                                const Limits& limits) {
    return with_threads(limits.jobs, [&] { return Growth(root, judge, target, limits).grow(); });
}

}  // namespace dumbbell::adiabatic
