// A tree of a section with the charts contact and departure, by search: what the section's own check accepts.
#pragma once
#include <stdexcept>
#include <string>
#include <tuple>

#include "verify/core/section.hpp"

namespace make {

/// A tree that this section accepts with U = leaf.claimed on the leaf's box, or std::runtime_error.
inline std::string full_tree(const dumbbell_verify::Section& section, dumbbell_verify::Leaf leaf,
                             int depth = 0) {
    using dumbbell_verify::count_leaf, dumbbell_verify::outside, dumbbell_verify::witness;
    if (depth > 40) throw std::runtime_error("the cover does not close");
    leaf.opcode = outside;
    if (!section.check(leaf, nullptr)) return "outside\n";
    if (section.charts[leaf.chart].name == "again") {
        leaf.opcode = witness + 1;
        if (!section.check(leaf, nullptr)) return "once\n";
    }
    leaf.opcode = count_leaf;
    leaf.a = leaf.claimed - 1;
    if (section.charts[leaf.chart].name != "again" && !section.check(leaf, nullptr))
        return "count " + leaf.a.get_str() + "\n";
    const std::size_t i = leaf.box.hi[0] - leaf.box.lo[0] > 2 * (leaf.box.hi[1] - leaf.box.lo[1]) ? 0 : 1;
    dumbbell_verify::Leaf lower = leaf, upper = leaf;
    lower.box.hi[i] = upper.box.lo[i] = (leaf.box.lo[i] + leaf.box.hi[i]) / 2;
    return "split " + std::string(section.charts[leaf.chart].axes[i]) + "\n" +
           full_tree(section, lower, depth + 1) + full_tree(section, upper, depth + 1);
}
/// All trees of a piece at the ratio q, for bodies of these rho if there are some.
inline std::string full_cover(const dumbbell_verify::Section& section, const mpq_class& q,
                              std::uint64_t upper, const dumbbell_verify::Range& rho = {}) {
    std::string text;
    dumbbell_verify::Leaf leaf;
    leaf.claimed = upper;
    for (leaf.chart = 0; leaf.chart < section.charts.size(); ++leaf.chart) {
        leaf.box = section.root(leaf.chart, q, q);
        std::tie(leaf.box.lo[3], leaf.box.hi[3]) = rho;
        text += "chart " + std::string(section.charts[leaf.chart].name) + "\n" + full_tree(section, leaf);
    }
    return text;
}

}  // namespace make
