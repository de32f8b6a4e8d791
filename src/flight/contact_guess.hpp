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

/// A point near the contact, if one is known.
inline constexpr double no_start = -1;

[[nodiscard]] ContactGuess<Interval> guess_contact(const Interval& c, const Interval& kappa,
                                                   double start = no_start) noexcept;
[[nodiscard]] ContactGuess<BigInterval> guess_contact(const BigInterval& c, const BigInterval& kappa,
                                                      double start = no_start);

/// The same, with enclosures of the sine and cosine of `z`.
template <class I>
struct ContactPlace {
    I z;
    SinCos<I> at;
    bool hits;
};

template <class I>
[[nodiscard]] ContactPlace<I> contact_place(const I& c, const I& kappa, double start) {
    const ContactGuess<I> guess = guess_contact(c, kappa, start);
    return {guess.z, sin_cos(guess.z), guess.hits};
}
[[nodiscard]] ContactPlace<Interval> contact_place(const Interval& c, const Interval& kappa,
                                                   double start) noexcept;

}  // namespace dumbbell::flight
