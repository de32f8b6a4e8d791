// Files of the claim kind `initial-conditions` (format-initial.md).
#pragma once
#include <span>
#include <utility>

#include "verify/core/settings.hpp"
#include "verify/core/text.hpp"
#include "verify/wings/starts/demand.hpp"

namespace dumbbell_verify::starts {

/// When every state of a leaf has its first contact, and with which mass.
struct FirstContact {
    bool heavy = false;
    mpq_class from, until;
};

/// A leaf that says: at least `least` and at most `most` collisions from every point of its box.
struct Leaf {
    std::uint64_t least = 0, most = 0, line = 0;
    unsigned bits = 53;     ///< with as many it must be certified
    bool multiple = false;  ///< not in double
    bool any_spin = false;  ///< of every phidot, whatever the box says
    std::string_view opcode;
    std::optional<FirstContact> first;
    Box box;
};

/// nullptr if the rules of format-initial.md certify what the leaf says, else what is missing; a log gets a
/// line for every inequality.
const char* check_leaf(const Leaf& leaf, Log* log);

/// Certified: both masses are above the floor over the whole box (format-initial.md, section 2).
bool starts_in_the_air(const Box& box, unsigned bits);

/// For a piece [x0, x1] x [s0, s1] of the section of all incoming trajectories, in the first two quantities:
/// its states (format-initial.md, section 8). Precondition: s1 < 1.
Box incoming_states(const Box& piece);

/// Reads on after the line `claim`, for all incoming trajectories or for a box; returns only if all that the
/// file and the demand say is certified, else throws the Failure of the least line.
std::pair<Proof, Claim> proof(Text& text, const Settings& settings, const Numbers& numbers, bool incoming);

/// The kinds of these files, for the program.
std::span<const ClaimKind> claim_kinds();

}  // namespace dumbbell_verify::starts
