// The lines that prove a bound: a cover, or a witness (format.md, sections 3.1 and 3.6).
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>

#include "verify/core/section.hpp"
#include "verify/core/tree.hpp"

namespace dumbbell_verify {

/// Reads them, and gives each thing that is to be checked to `take`, with its path from the piece on.
struct Proofs {
    Text& text;
    const Section& section;
    std::vector<Tally>& tallies;  ///< the first are those of add_tallies()
    std::function<void(Leaf, const std::string& path)> take;
    Range rho{};  ///< of bodies

    void add_tallies() const {
        tallies.push_back({"split"});
        for (const Opcode& opcode : section.opcodes) tallies.push_back({opcode.name});
    }

    /// That no trajectory has more than `claimed` collisions, for all ratios of [a, b].
    void cover(Leaf leaf, const mpq_class& a, const mpq_class& b) const {
        for (; leaf.chart < section.charts.size(); ++leaf.chart) {
            leaf.box = section.root(leaf.chart, a, b);
            std::tie(leaf.box.lo[3], leaf.box.hi[3]) = rho;
            text.next();
            if (leaf.chart == 0 && (text.fields[0] != "chart" || section.charts[0].name.empty()))
                return found(leaf, Place::cover, 1, static_cast<double>(section.charts.size()), "cover");
            std::string path(section.charts[leaf.chart].name);
            if (text.fields.size() != 2 || text.fields[0] != "chart" || text.fields[1] != path)
                text.reject("syntax", "expected `chart " + path + "`");
            Tree<Box> tree{text, section.charts[leaf.chart].axes, tallies[0].lines, leaf.box, path + '.'};
            tree.read([&] { found(leaf, Place::leaf, 1, std::ldexp(1, -tree.depth), tree.path); });
        }
    }
    /// That some trajectory has at least `claimed` > 0.
    void witness(Leaf leaf, const mpq_class& a, const mpq_class& b) const {
        text.expect("witness", 5);
        const mpq_class e = text.dyadic(2), y = text.dyadic(3);
        leaf.box = {{e, y, a, rho.first}, {e, y, b, rho.second}};
        leaf.chart = text.fields[1] == section.other_witness ? 1 : 0;
        found(leaf, Place::witness, 4, 0, "witness");
    }

  private:
    /// The present line as one thing to check; its hints are the fields from number `hints` on.
    void found(Leaf leaf, Place place, std::size_t hints, double covered, const std::string& path) const {
        const auto& fields = text.fields;
        const auto fits = [&](const Opcode& o) {
            return o.name == fields[0] && o.place == place && (o.charts >> leaf.chart & 1) != 0;
        };
        const auto opcode = std::find_if(section.opcodes.begin(), section.opcodes.end(), fits);
        if (opcode == section.opcodes.end()) text.reject("opcode", "not a line for this place");
        if ((opcode->hints > 2 ? (fields.size() - hints) % 2 == 0 : fields.size() != hints + opcode->hints) ||
            (place == Place::witness && leaf.chart == 0 && fields[1] != section.witness))
            text.reject("syntax", "wrong number of values, or unknown kind");
        if (opcode->hints > 0) leaf.a = text.long_natural(hints);
        for (std::size_t i = hints + 1; opcode->hints > 2 && i < fields.size(); i += 2)
            leaf.orbits.emplace_back(text.long_natural(i), text.dyadic(i + 1));
        if (opcode->hints == 2) leaf.b = text.long_natural(hints + 1);
        leaf.opcode = static_cast<std::size_t>(opcode - section.opcodes.begin());
        leaf.line = text.line;
        ++tallies[1 + leaf.opcode].lines;
        tallies[1 + leaf.opcode].covered += covered;
        take(std::move(leaf), path);
    }
};

}  // namespace dumbbell_verify
