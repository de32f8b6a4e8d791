#pragma once

#include "flight/ray.hpp"

/// The counts of flight/count.hpp, the very same templates, with the intervals of other libraries: what a
/// user would have got by picking one of them. The guesses of Newton's iteration are this project's for all
/// of them, and every bound is rigorous. Each peer has a file of its own.
namespace dumbbell_bench {

struct Peer {
    const char* name;
    long (*at_most)(const dumbbell::flight::Ray<double>& lowest, long cap);
    long (*at_least)(const dumbbell::flight::Ray<double>& highest, long cap);
};

/// CGAL::Interval_nt has no sine. A user has to bring one: MPFR's, the only one that Debian has with
/// correctly rounded bounds for doubles; or this project's, which wants another rounding mode than CGAL.
extern const Peer cgal_with_mpfr_sine;
extern const Peer cgal_with_own_sine;
/// At 53 bits.
/// At 53 bits.
extern const Peer arb;

}  // namespace dumbbell_bench
