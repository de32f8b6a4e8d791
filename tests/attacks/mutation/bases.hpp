// The certificates that are mutated: small, made by the prover, and together with every opcode and kind of
// claim.
#pragma once
#include <string>
#include <variant>
#include <vector>

#include "collisions/certificate.hpp"
#include "starts/certificate.hpp"

namespace dumbbell_mutation {

struct Base {
    std::string name;
    std::variant<dumbbell::Certificate, dumbbell::InitialCertificate> data;
    std::string text;
};

/// Deterministic. `large` adds some with hundreds of leaves.
[[nodiscard]] std::vector<Base> bases(bool large);

}  // namespace dumbbell_mutation
