// What is asked of a file, and what was found in it.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verify/core/claim.hpp"
#include "verify/core/outside.hpp"

namespace dumbbell_verify {

struct Settings {
    unsigned jobs = 1, max_bits = 2048;
    std::uint64_t budget = default_budget;  ///< of work on the file, in units
    unsigned precision = 0;    ///< at least this many bits of MPFR for every piece; 0: what the pieces say
    std::string explain;       ///< PIECE:PATH or box.PATH, the leaf to show
    std::string scene, claim;  ///< demanded scene and kind; empty: none
    bool shares = false;       ///< of the numbers of collisions, from a box of starts
    bool heavy_once = false;   ///< demanded: the heavy mass touches at most once
    Collisions demand;

    /// A claim without a scene is about the dumbbell; empty: the file's own.
    [[nodiscard]] std::string_view demanded_scene() const {
        const bool states = demand.ratios || demand.most || demand.least || demand.gap ||
                            demand.gaps_at_most || heavy_once || !claim.empty();
        return scene.empty() && states ? std::string_view("dumbbell") : scene;
    }
};

/// The lines of one kind, and how many root boxes these leaves fill.
struct Tally {
    std::string_view name;
    std::uint64_t lines = 0;
    double covered = 0;
};

struct Proof {
    Collisions claim;  ///< if the file is about mass ratios
    std::string digest;
    std::uint64_t work = 0;                   ///< in units
    const struct Section* section = nullptr;  ///< if the file is about mass ratios
    bool heavy_once = false;                  ///< proved for every ratio: the heavy mass touches at most once
    double roots = 0;                         ///< number of root boxes
    std::optional<mpq_class> decided;         ///< of a rectangle of bodies: at least this share
    bool explained = false;                   ///< the leaf that was asked for exists
    std::vector<Tally> tallies;               ///< split, the opcodes of the section, open
};

}  // namespace dumbbell_verify
