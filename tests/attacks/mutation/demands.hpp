// Claims that are demanded of a true file from outside: accepted iff the file's pieces prove them, which is
// decided here from the data alone.
#pragma once
#include <string>
#include <vector>

#include "bases.hpp"
#include "verify/program/verify.hpp"

namespace dumbbell_mutation {

struct Demand {
    dumbbell_verify::Request settings;
    std::string what;     ///< as options of dumbbell-verify
    bool proved = false;  ///< by the base
    bool fitting = true;  ///< false: the demand is about another kind of claim, and refused as wrong usage
};

/// Demands near the bounds and the ends of the pieces, with and without a demanded scene or kind of claim.
[[nodiscard]] std::vector<Demand> demands_of(const Base& base);

}  // namespace dumbbell_mutation
