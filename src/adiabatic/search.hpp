#pragma once

#include <optional>
#include <vector>

#include "adiabatic/certificate.hpp"
#include "base/interrupted.hpp"

/// The search for orbits with a great error, in plain doubles: guesses that prove nothing
/// until `attained` encloses them.
namespace dumbbell::adiabatic {

/// What a search may cost, about, whatever delta is: its orbits are the fewer the longer they are.
inline constexpr double most_collisions_in_all = 2e8;

/// An initial condition as in AdiabaticState, delta as its share of the way from D1 to D2.
struct AdiabaticSample {
    double u = 0;
    double s = 0;
    double share = 0;
    long n = 0;
    double error = 0;  ///< in the claim's unit; 0: not of the hypotheses
};

/// What is looked for: the claim's own error, or with a bounce one of its two.
struct AdiabaticSearch {
    AdiabaticHypotheses of;
    bool height_error = false;  ///< of a bounce: E2, not E1
    long most_collisions = 1'000'000;
    int jobs = 1;
    Interrupted interrupted = never;
};

/// The error of one initial condition.
[[nodiscard]] AdiabaticSample simulated(const AdiabaticSearch& search, double u, double s, double share);

/// Some initial conditions with a great error, the greatest first: the best of a grid, refined.
/// Deterministic.
[[nodiscard]] std::vector<AdiabaticSample> search_errors(const AdiabaticSearch& search);

/// The orbit of a found initial condition, enclosed: that it satisfies the claim's hypotheses, and a lower
/// bound of its error in the claim's unit, by the rules of format-adiabatic.md, section 6, with some
/// slack. Nothing if that is not certain.
[[nodiscard]] std::optional<AdiabaticState> attained(const AdiabaticSearch& search,
                                                     const AdiabaticSample& sample);

}  // namespace dumbbell::adiabatic
