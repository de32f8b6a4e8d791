// All mutants of one base through the verifier, and what became of each.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bases.hpp"
#include "examine.hpp"

namespace dumbbell_mutation {

/// A text to be verified. `stale`: the same change with the base's own totals and checksum.
struct Trial {
    std::string_view kind;
    std::string what, text, stale;
    dumbbell_verify::Request settings;
    bool demand = false;  ///< the base itself, with a claim demanded: accepted iff `proved`
    bool proved = false, fitting = true;
};

enum class Fate {
    rejected,      ///< the verifier refused it
    accepted,      ///< a true proof, if a second verifier says so, too
    unexplained,   ///< about the adiabatic invariant, accepted, and not shown to be true: a soundness bug,
                   ///< until shown otherwise
    unmasked,      ///< accepted with the old checksum, or refused for something else than the totals or the
                   ///< checksum
    wrong_demand,  ///< a demand decided wrongly
    crash,
    hang
};
inline constexpr std::string_view fate_names[] = {"rejected",     "accepted", "UNEXPLAINED", "UNMASKED",
                                                  "WRONG-DEMAND", "CRASH",    "HANG"};

struct Result {
    Fate fate = Fate::rejected;
    bool stale_tried = false;
    dumbbell_verify::Verdict verdict = dumbbell_verify::Verdict::rejected;
    std::uint64_t line = 0;
    std::string code, text;  ///< of the refusal; of an accepted file the claim
    std::string argument;
};

struct Options {
    unsigned jobs = 1;
    int seconds = 20;         ///< of processor time for one mutant
    std::size_t most = 4000;  ///< mutants of one base, without the demands
    std::size_t scale = 1;    ///< how many times as many; half of the additional ones have several changes
};

/// Different texts only, in the same order at each call. Where a base has more than its share a sample that
/// is spread evenly.
[[nodiscard]] std::vector<Trial> trials_of(const Base& base, const Options& options);

[[nodiscard]] std::vector<Result> run(const std::vector<Trial>& trials, const Options& options);

}  // namespace dumbbell_mutation
