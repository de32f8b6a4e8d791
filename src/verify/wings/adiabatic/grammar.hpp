// Files of the claim kinds `adiabatic-*` (format-adiabatic.md).
#pragma once
#include <deque>
#include <span>

#include "verify/core/settings.hpp"
#include "verify/core/text.hpp"
#include "verify/wings/adiabatic/demand.hpp"
#include "verify/wings/adiabatic/potential.hpp"

namespace dumbbell_verify::adiabatic {

/// The axes of the trees, of which each tree has some: u and v distances from the vertical, s = -ydot/delta,
/// sigma a slope over sqrt(r).
struct Box {
    std::array<mpq_class, 5> lo, hi;
};
inline constexpr std::size_t axis_u = 0, axis_s = 1, axis_v = 2, axis_delta = 3, axis_sigma = 4;

/// L35: flights of S >= J sqrt(E) change S by no more than the potential says.
struct Class {
    mpq_class J;
    Potential potential;
};

/// What the leaves of one file have in common.
struct Terms {
    Claim claim;
    std::deque<Class> classes;
};

/// One thing to check: a class itself, a leaf of its tree or of the tree of the claim, an attained state.
struct Leaf {
    enum Part { class_itself, class_tree, claim_tree, attained };
    Part part = claim_tree;
    const Terms* terms = nullptr;
    bool outside = false;
    std::size_t index = 0;  ///< the number of the class, or of the attained state
    std::uint64_t line = 0;
    unsigned bits = 53;     ///< with as many it must be certified
    bool multiple = false;  ///< not in double
    std::string_view opcode;
    Box box;
};

/// nullptr if the rules of format-adiabatic.md certify it, else what is missing; a log gets every inequality.
const char* check_leaf(const Leaf& leaf, Log* log);
const char* check_class(const Leaf& leaf, Log* log);     ///< section 3
const char* check_bounces(const Leaf& leaf, Log* log);   ///< section 4
const char* check_bounce(const Leaf& leaf, Log* log);    ///< section 5
const char* check_attained(const Leaf& leaf, Log* log);  ///< section 6

/// Reads on after the line `claim`; returns only if all that the file and the demand say is certified, else
/// throws the Failure of the least line.
std::pair<Proof, Claim> proof(Text& text, const Settings& settings, const Numbers& numbers, Claim::Kind kind);

/// The kinds of these files, for the program.
std::span<const ClaimKind> claim_kinds();

}  // namespace dumbbell_verify::adiabatic
