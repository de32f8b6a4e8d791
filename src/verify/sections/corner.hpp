#pragma once
#include <gmpxx.h>

namespace dumbbell_verify {

constexpr int most_in_corner = 10'000;

/// ceil(pi/corner) >= n for the body (rho, q), exactly (L73). Throws std::length_error where that takes more
/// than most_in_corner steps.
bool corner_has(const mpz_class& n, const mpq_class& rho, const mpq_class& q);

}  // namespace dumbbell_verify
