// Numbers in decimals.
#pragma once
#include <gmpxx.h>

#include <string>

namespace dumbbell_verify {

/// x >= 0 with this number of decimals, rounded up or down.
inline std::string decimals(const mpq_class& x, bool upward, unsigned places = 6) {
    mpz_class scale, digits;
    mpz_ui_pow_ui(scale.get_mpz_t(), 10, places);
    const mpz_class scaled = x.get_num() * scale;
    (upward ? mpz_cdiv_q : mpz_fdiv_q)(digits.get_mpz_t(), scaled.get_mpz_t(), x.get_den_mpz_t());
    std::string text = digits.get_str();
    if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
    return places == 0 ? text : text.insert(text.size() - places, ".");
}

}  // namespace dumbbell_verify
