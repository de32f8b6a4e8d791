// Leaves and attained states of the adiabatic claims as rows of a table (near_adiabatic.tsv): what one says
// in numbers, a tab, and what the verifier says of it.
#pragma once
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "verify/adiabatic.hpp"

namespace adiabatic_rows {

using dumbbell_verify::Adiabatic;
using dumbbell_verify::AdiabaticLeaf;
using dumbbell_verify::AdiabaticTerms;

/// All that a judgement depends on. Bits as in leaf_rows.hpp: 0 is double.
struct Case {
    Adiabatic::Kind kind = Adiabatic::bounce;
    AdiabaticLeaf::Part part = AdiabaticLeaf::claim_tree;
    bool outside = false;
    unsigned bits = 0, exponent = 8;
    mpq_class y_lo, y_hi = 1, margin = 1;
    std::vector<mpq_class> bounds;
    mpq_class J;
    std::vector<std::pair<mpq_class, mpq_class>> cells;  ///< u, v
    Adiabatic::Attained state;                           ///< of part `attained`, in place `index`
    std::size_t index = 0;
    dumbbell_verify::AdiabaticBox box;
};

/// `certified`, or what is missing.
inline std::string judged(const Case& c) {
    AdiabaticTerms terms;
    Adiabatic& claim = terms.claim;
    claim.kind = c.kind;
    claim.delta_lo = c.box.lo[dumbbell_verify::axis_delta];
    claim.delta_hi = c.box.hi[dumbbell_verify::axis_delta];
    claim.y_lo = c.y_lo;
    claim.y_hi = c.y_hi;
    claim.margin = c.margin;
    claim.exponent = c.exponent;
    claim.bounds = c.bounds;
    claim.attained.assign(c.index + 1, c.state);
    if (!c.cells.empty()) {
        dumbbell_verify::Potential potential(mpq_class(11, 7));
        for (const auto& [u, v] : c.cells) potential.add_cell(u, v);
        terms.classes.push_back({c.J, potential});
    }
    AdiabaticLeaf leaf;
    leaf.part = c.part;
    leaf.terms = &terms;
    leaf.outside = c.outside;
    leaf.index = c.part == AdiabaticLeaf::attained ? c.index : 0;
    leaf.multiple = c.bits > 0;
    leaf.bits = c.bits > 0 ? c.bits : 53;
    leaf.box = c.box;
    const char* missing = check_adiabatic(leaf, nullptr);
    return missing ? missing : "certified";
}

inline std::string words(const Case& c) {
    std::ostringstream out;
    out << c.kind << " " << c.part << " " << c.outside << " " << c.bits << " " << c.exponent << " " << c.y_lo
        << " " << c.y_hi << " " << c.margin << " " << c.bounds.size();
    for (const mpq_class& bound : c.bounds) out << " " << bound;
    out << " " << c.J << " " << c.cells.size();
    for (const auto& [u, v] : c.cells) out << " " << u << " " << v;
    out << " " << c.index << " " << c.state.u << " " << c.state.s << " " << c.state.delta << " "
        << c.state.collisions << " " << c.state.value;
    for (std::size_t i = 0; i < c.box.lo.size(); ++i) out << " " << c.box.lo.at(i) << " " << c.box.hi.at(i);
    return out.str();
}

inline Case parsed(const std::string& text) {
    std::istringstream in(text);
    Case c;
    int kind = 0, part = 0;
    std::size_t bounds = 0, cells = 0;
    in >> kind >> part >> c.outside >> c.bits >> c.exponent >> c.y_lo >> c.y_hi >> c.margin >> bounds;
    c.bounds.resize(bounds);
    for (mpq_class& bound : c.bounds) in >> bound;
    in >> c.J >> cells;
    c.cells.resize(cells);
    for (auto& [u, v] : c.cells) in >> u >> v;
    in >> c.index >> c.state.u >> c.state.s >> c.state.delta >> c.state.collisions >> c.state.value;
    for (std::size_t i = 0; i < c.box.lo.size(); ++i) in >> c.box.lo.at(i) >> c.box.hi.at(i);
    if (!in) throw std::runtime_error("a row with too few words: " + text);
    c.kind = static_cast<Adiabatic::Kind>(kind);
    c.part = static_cast<AdiabaticLeaf::Part>(part);
    return c;
}

}  // namespace adiabatic_rows
