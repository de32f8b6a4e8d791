// Leaves and attained states of the adiabatic claims as rows of a table (near_adiabatic.tsv): what one says
// in numbers, a tab, and what the verifier says of it.
#pragma once
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "verify/wings/adiabatic/grammar.hpp"

namespace adiabatic_rows {

namespace adiabatic = dumbbell_verify::adiabatic;

/// All that a judgement depends on. Bits as in leaf_rows.hpp: 0 is double.
struct Case {
    adiabatic::Claim::Kind kind = adiabatic::Claim::bounce;
    adiabatic::Leaf::Part part = adiabatic::Leaf::claim_tree;
    bool outside = false;
    unsigned bits = 0, exponent = 8;
    mpq_class y_lo, y_hi = 1, margin = 1;
    std::vector<mpq_class> bounds;
    mpq_class J;
    std::vector<std::pair<mpq_class, mpq_class>> cells;  ///< u, v
    adiabatic::Claim::Attained state;                    ///< of part `attained`, in place `index`
    std::size_t index = 0;
    dumbbell_verify::adiabatic::Box box;
};

/// `certified`, or what is missing.
inline std::string judged(const Case& c) {
    adiabatic::Terms terms;
    adiabatic::Claim& claim = terms.claim;
    claim.kind = c.kind;
    claim.delta_lo = c.box.lo[dumbbell_verify::adiabatic::axis_delta];
    claim.delta_hi = c.box.hi[dumbbell_verify::adiabatic::axis_delta];
    claim.y_lo = c.y_lo;
    claim.y_hi = c.y_hi;
    claim.margin = c.margin;
    claim.exponent = c.exponent;
    claim.bounds = c.bounds;
    claim.attained.assign(c.index + 1, c.state);
    if (!c.cells.empty()) {
        dumbbell_verify::adiabatic::Potential potential(mpq_class(11, 7));
        for (const auto& [u, v] : c.cells) potential.add_cell(u, v);
        terms.classes.push_back({c.J, potential});
    }
    adiabatic::Leaf leaf;
    leaf.part = c.part;
    leaf.terms = &terms;
    leaf.outside = c.outside;
    leaf.index = c.part == adiabatic::Leaf::attained ? c.index : 0;
    leaf.multiple = c.bits > 0;
    leaf.bits = c.bits > 0 ? c.bits : 53;
    leaf.box = c.box;
    const char* missing = adiabatic::check_leaf(leaf, nullptr);
    return missing ? missing : "certified";
}

/// The operators of gmpxx for streams need another library.
inline std::string words(const Case& c) {
    std::string text;
    const auto add = [&](const std::string& word) { text += (text.empty() ? "" : " ") + word; };
    const auto natural = [&](std::uint64_t n) { add(std::to_string(n)); };
    const auto ratio = [&](const mpq_class& x) { add(x.get_str()); };
    for (const unsigned n : {static_cast<unsigned>(c.kind), static_cast<unsigned>(c.part),
                             c.outside ? 1U : 0U, c.bits, c.exponent})
        natural(n);
    ratio(c.y_lo), ratio(c.y_hi), ratio(c.margin);
    natural(c.bounds.size());
    for (const mpq_class& bound : c.bounds) ratio(bound);
    ratio(c.J);
    natural(c.cells.size());
    for (const auto& [u, v] : c.cells) ratio(u), ratio(v);
    natural(c.index);
    ratio(c.state.u), ratio(c.state.s), ratio(c.state.delta);
    natural(c.state.collisions);
    ratio(c.state.value);
    for (std::size_t i = 0; i < c.box.lo.size(); ++i) ratio(c.box.lo.at(i)), ratio(c.box.hi.at(i));
    return text;
}

inline Case parsed(const std::string& text) {
    std::istringstream in(text);
    const auto word = [&] {
        std::string w;
        if (!(in >> w)) throw std::runtime_error("a row with too few words: " + text);
        return w;
    };
    const auto natural = [&] { return static_cast<unsigned>(std::stoul(word())); };
    const auto ratio = [&] { return mpq_class(word()); };
    Case c;
    c.kind = static_cast<adiabatic::Claim::Kind>(natural());
    c.part = static_cast<adiabatic::Leaf::Part>(natural());
    c.outside = natural() == 1;
    c.bits = natural();
    c.exponent = natural();
    c.y_lo = ratio();
    c.y_hi = ratio();
    c.margin = ratio();
    c.bounds.resize(natural());
    for (mpq_class& bound : c.bounds) bound = ratio();
    c.J = ratio();
    c.cells.resize(natural());
    for (auto& [u, v] : c.cells) u = ratio(), v = ratio();
    c.index = natural();
    c.state.u = ratio();
    c.state.s = ratio();
    c.state.delta = ratio();
    c.state.collisions = natural();
    c.state.value = ratio();
    for (std::size_t i = 0; i < c.box.lo.size(); ++i) c.box.lo.at(i) = ratio(), c.box.hi.at(i) = ratio();
    return c;
}

}  // namespace adiabatic_rows
