#pragma once

#include "number/big_interval.hpp"
#include "number/interval.hpp"

namespace dumbbell::flight {

/// Where a ray (c, kappa) seems to meet the light wall, sin x = c + kappa x: a guess that steers the
/// enclosures of contact.hpp and proves nothing. If it seems to miss, `z` is where it comes closest, cos z =
/// kappa.
template <class I>
struct ContactGuess {
    I z;
    bool hits;
};

[[nodiscard]] ContactGuess<Interval> guess_contact(const Interval& c, const Interval& kappa) noexcept;
[[nodiscard]] ContactGuess<BigInterval> guess_contact(const BigInterval& c, const BigInterval& kappa);

}  // namespace dumbbell::flight
