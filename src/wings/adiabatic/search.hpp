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

/// An initial condition as in State, delta as its share of the way from D1 to D2.
struct Sample {
    double u = 0;
    double s = 0;
    double share = 0;
    long n = 0;
    double error = 0;  ///< in the claim's unit; 0: not of the hypotheses
};

/// What is looked for: the claim's own error, or with a bounce one of its two.
struct Search {
    Hypotheses of;
    bool height_error = false;  ///< of a bounce: E2, not E1
    long most_collisions = 1'000'000;
    int jobs = 1;
    Interrupted interrupted = never;
};

/// The error of one initial condition.
[[nodiscard]] Sample simulated(const Search& search, double u, double s, double share);

/// Some initial conditions with a great error, the greatest first: the best of a grid, refined.
/// Deterministic.
[[nodiscard]] std::vector<Sample> search_errors(const Search& search);

/// The orbit of a found initial condition, enclosed: that it satisfies the claim's hypotheses, and a lower
/// bound of its error in the claim's unit, by the rules of format-adiabatic.md, section 6, with some
/// slack. Nothing if that is not certain.
[[nodiscard]] std::optional<State> attained(const Search& search, const Sample& sample);

}  // namespace dumbbell::adiabatic
