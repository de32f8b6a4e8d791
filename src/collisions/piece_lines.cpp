#include "collisions/piece_lines.hpp"

#include "base/error.hpp"
#include "collisions/chart.hpp"
#include "collisions/names.hpp"
#include "file/dyadic.hpp"

namespace dumbbell::collisions {

std::string to_text(const UpperBound& bound) {
    std::string text = std::to_string(bound.end);
    for (const auto& [x, p] : bound.orbits) {
        text += fmt::format(" {} {}", x, to_dyadic(p));
    }
    return text;
}

void PieceLines::proof(const Piece& piece) {
    line("bits {}", piece.bits);
    if (piece.upper) {
        line("upper {}", *piece.upper);
        cover(piece.cover);
    } else {
        line("upper none");
        count("open");
    }
    line("lower {}", piece.lower);
    if (piece.lower > 0) {
        require(piece.witness.has_value(), "certificate: a lower bound needs a witness");
        const Witness& w = *piece.witness;
        line("witness {} {} {} {} {}", name(w.place), to_dyadic(w.e), to_dyadic(w.eta), w.forward,
             w.backward);
        count("witness");
    }
}

void PieceLines::cover(const Cover& cover) {
    if (cover.equal_masses || cover.symmetric) {
        const std::string_view word = cover.symmetric ? symmetric_word : equal_masses_word;
        line("{}", word);
        count(word);
        return;
    }
    if (cover.orbits) {
        line("{} {}", orbits_word, to_text(*cover.orbits));
        count(orbits_word);
    }
    for (const ChartTree& part : cover.charts) {
        line("chart {}", row_of(part.chart).name);
        for (const Node& node : part.tree) {
            if (node.split) {
                line("split {}", axis_name(part.chart, *node.split));
                count("split");
            } else {
                leaf(part.chart, node.leaf);
            }
        }
    }
}

void PieceLines::leaf(Chart chart, const Leaf& leaf) {
    const std::string_view word = name(leaf.reason);
    count(word);
    if (leaf.reason != Reason::count) {
        line("{}", word);
    } else if (row_of(chart).counts_both_ways) {
        line("{} {} {}", word, leaf.forward, leaf.backward);
    } else {
        line("{} {}", word, leaf.forward);
    }
}

void PieceLines::totals(std::span<const std::string_view> kinds) {
    for (const std::string_view kind : kinds) {
        line("total {} {}", kind, totals_[kind]);
    }
}

}  // namespace dumbbell::collisions
