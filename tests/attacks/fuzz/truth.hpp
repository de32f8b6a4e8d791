// What is true of N*, by Theorem 2 of proofs/theorem.md and the table of critical ratios made from it; no
// certificate and no part of the verifier is used.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <limits>
#include <string>

#include "collisions/certificate.hpp"

namespace dumbbell_fuzz {

/// Near the critical ratio q_c(n), to 50 digits; 3 <= n <= greatest_critical().
[[nodiscard]] mpq_class critical_ratio(std::size_t n);
[[nodiscard]] std::size_t greatest_critical();

/// Ends the program if "N* <= upper and N* >= lower at all ratios of the piece" is certainly false.
/// `height`: rho of a body.
void must_be_true(const dumbbell::collisions::Piece& piece,
                  const std::optional<dumbbell::Rational>& height = {});

}  // namespace dumbbell_fuzz
