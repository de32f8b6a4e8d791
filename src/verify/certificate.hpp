// One certificate file: its grammar (format.md, sections 2 and 3) and the check of all that it claims.
#pragma once
#include <string>
#include <vector>

#include "adiabatic_claim.hpp"
#include "collisions.hpp"
#include "initial_claim.hpp"
#include "section.hpp"
#include "text.hpp"

namespace dumbbell_verify {

struct Settings {
    unsigned jobs = 1, max_bits = 2048;
    std::uint64_t budget = default_budget;  ///< of work on the file, in units (work.hpp)
    unsigned precision = 0;  ///< at least so many bits of MPFR for every piece; 0: what the pieces say
    std::string scene = "dumbbell", explain;  ///< explain: PIECE:PATH or box.PATH, the leaf to show
    std::string claim;                        ///< demanded kind; empty: any
    Pieces check = all_pieces;                ///< of the others no leaf and no witness is checked
    Collisions demand;
};

/// The lines of one kind, and how many root boxes these leaves fill.
struct Tally {
    std::string_view name;
    std::uint64_t lines = 0;
    double covered = 0;
};

struct Proof {
    Collisions claim;
    std::optional<Initial> initial;      ///< instead, if the file is about initial conditions
    std::optional<Adiabatic> adiabatic;  ///< instead, if it is about the adiabatic invariant
    std::string digest;
    std::uint64_t work = 0;      ///< in units (work.hpp)
    std::string_view section;    ///< its name, if the file is about mass ratios
    bool heavy_once = false;     ///< proved for every ratio: the heavy mass touches at most once
    double roots = 0;            ///< number of root boxes
    bool explained = false;      ///< the leaf that was asked for exists
    std::vector<Tally> tallies;  ///< split, the opcodes of the section, open
};

/// Returns only if all that the file and the demand say is certified, but for the leaves and witnesses of the
/// pieces that `settings` does not have checked; else throws the Failure of the least line.
Proof verify(const std::string& path, const Settings& settings);

}  // namespace dumbbell_verify
