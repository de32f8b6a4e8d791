// The certificates that are mutated: small, made by the prover, and together with every opcode and kind of
// claim.
#pragma once
#include <string>
#include <vector>

#include "page/any_certificate.hpp"

namespace dumbbell_mutation {

struct Base {
    std::string name;
    dumbbell::page::AnyCertificate data;
    std::string text;
    /// How many times as much time as others it takes to verify, about: it gets fewer mutants by this factor,
    /// and none of single bytes.
    std::size_t cost = 1;
};

/// Deterministic. `large` adds some with hundreds of leaves.
[[nodiscard]] std::vector<Base> bases(bool large);
/// Those of them that are about the adiabatic invariant.
[[nodiscard]] std::vector<Base> adiabatic_bases();

}  // namespace dumbbell_mutation
