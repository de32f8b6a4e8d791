// Trees of boxes: what of a file says that its leaves cover a box.
#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "verify/core/text.hpp"

namespace dumbbell_verify {

constexpr int most_splits = 400;  ///< of one axis, above a node

/// A tree of halved boxes in pre-order: the leaves are halves of halves of the root box, together they cover
/// it.
template <class Box>
struct Tree {
    Text& text;
    std::span<const std::string_view> axes;
    std::uint64_t& splits;   ///< counts the lines `split`
    Box& box;                ///< of the present node; in the end the root box again
    std::string path;        ///< the halves (0 lower, 1 upper) from the root to here
    int most = most_splits;  ///< of one axis
    int depth = 0;
    std::array<int, std::tuple_size_v<decltype(Box::lo)>> depths{};  ///< splits of each axis above here

    /// A node above the present one: the side of its box that is halved.
    struct Halved {
        std::size_t axis;
        mpq_class lo, hi;
    };
    std::vector<Halved> above{};

    /// Of a line `split`.
    std::size_t axis() {
        const auto axis =
            text.fields.size() == 2 ? std::find(axes.begin(), axes.end(), text.fields[1]) : axes.end();
        if (axis == axes.end()) text.reject("syntax", "not an axis of this chart");
        const auto i = static_cast<std::size_t>(axis - axes.begin());
        if (++depths[i] > most)
            text.reject("depth", "more than " + std::to_string(most) + " splits of one axis");
        if (box.lo[i] == box.hi[i]) text.reject("split", "an axis of width 0");
        return i;
    }

    /// The whole tree; `leaf` is called at each line that is no split. Without recursion: a stack may be
    /// small.
    template <class Leaf>
    void read(const Leaf& leaf) {
        do {
            text.next();
            if (text.fields[0] == "split")
                halve(axis());
            else {
                const auto used = [&](Work::Ends ends) { return ends.first(axes.size()); };
                text.budget.take(Work::of_box(used(box.lo), used(box.hi), depth), text.line);
                leaf();
                leave();
            }
        } while (!above.empty());
    }
    /// To the lower half.
    void halve(std::size_t i) {
        text.budget.take(Work::of_halving(box.lo[i], box.hi[i]), text.line);
        ++splits;
        ++depth;
        path += '0';
        above.push_back({i, box.lo[i], box.hi[i]});
        box.hi[i] = (box.lo[i] + box.hi[i]) / 2;
    }
    /// From what has been read to the next upper half; to the root if there is none.
    void leave() {
        while (!above.empty() && path.back() == '1') {
            Halved& node = above.back();
            box.lo[node.axis] = std::move(node.lo);
            --depth;
            --depths[node.axis];
            path.pop_back();
            above.pop_back();
        }
        if (above.empty()) return;
        const Halved& node = above.back();
        box.lo[node.axis] = box.hi[node.axis];
        box.hi[node.axis] = node.hi;
        path.back() = '1';
    }
};

}  // namespace dumbbell_verify
