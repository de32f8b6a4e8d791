// Numbers of 64 bits and GMP's, whose interface knows `int` and `long`: that may be no longer than 32 bits.
#pragma once
#include <gmpxx.h>

#include <cstdint>

namespace dumbbell_verify {

inline mpz_class integer(std::uint64_t n) {
    mpz_class result;
    mpz_import(result.get_mpz_t(), 1, -1, sizeof n, 0, 0, &n);
    return result;
}
inline mpz_class integer(const mpz_class& n) { return n; }
/// Whether n >= 0 has so many bits at most.
inline bool fits(const mpz_class& n, std::size_t bits) {
    return n >= 0 && mpz_sizeinbase(n.get_mpz_t(), 2) <= bits;
}
/// n. Precondition: fits(n, 64).
inline std::uint64_t unsigned_64(const mpz_class& n) {
    std::uint64_t result = 0;
    mpz_export(&result, nullptr, -1, sizeof result, 0, 0, n.get_mpz_t());
    return result;
}

/// So many words of 64 bits, whatever GMP's own are; 0 of 0.
inline std::uint64_t limbs(const mpz_class& n) { return (mpz_size(n.get_mpz_t()) * GMP_NUMB_BITS + 63) / 64; }

}  // namespace dumbbell_verify
