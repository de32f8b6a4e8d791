#pragma once

#include "number/big_interval.hpp"
#include "number/interval.hpp"

namespace dumbbell::flight {

/// Where a ray (c, kappa) seems to meet the light wall, sin x = c + kappa x: a guess that steers the
/// enclosures of contact.hpp and proves nothing. If it seems to miss, `z` is where it comes closest, cos z =
/// kappa. `from`: where it certainly is not yet, if that is known.
template <class I>
struct ContactGuess {
    I z;
    bool hits;
};

[[nodiscard]] ContactGuess<Interval> guess_contact(const Interval& c, const Interval& kappa,
                                                   double from = 0) noexcept;
[[nodiscard]] ContactGuess<BigInterval> guess_contact(const BigInterval& c, const BigInterval& kappa,
                                                      double from = 0);

}  // namespace dumbbell::flight
