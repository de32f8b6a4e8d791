#pragma once

#include "flight/count.hpp"
#include "peers.hpp"

/// What flight/count.hpp asks of an interval type, for a peer's: all of them have its names, in their own
/// namespace.
namespace dumbbell_bench {

/// The guess of Newton's iteration in plain double, for any type: it proves nothing.
template <class I>
dumbbell::flight::ContactGuess<I> double_guess(const I& c, const I& kappa, double start) {
    const auto guess = dumbbell::flight::guess_contact(dumbbell::Interval(approximate(c)),
                                                       dumbbell::Interval(approximate(kappa)), start);
    return {I(guess.z.lo()), guess.hits};
}

template <class I>
dumbbell::flight::Ray<I> as_ray(const dumbbell::flight::Ray<double>& ray) {
    return {I(ray.c), I(ray.kappa), I(ray.r)};
}

}  // namespace dumbbell_bench
