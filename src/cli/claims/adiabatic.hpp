#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "adiabatic/certificate.hpp"

namespace dumbbell {

/// What `adiabatic` is to prove, as it stands on the command line.
struct AdiabaticWords {
    std::string delta;
    std::string theorem = "thm3.3";
    std::optional<std::string> y, margins, exponents;
    std::string accuracy = "0.1";
};

/// Whether --delta is one number or range, or a list of them.
enum class Deltas { one, list };

/// Adds the options of the claim to a command; `claim` outlives it.
void add_adiabatic_options(CLI::App& command, AdiabaticWords& claim, Deltas deltas);

/// Of --theorem.
[[nodiscard]] AdiabaticClaim claim_of(const AdiabaticWords& claim);

/// All statements asked for: one for each delta, exponent and distance from the vertical, the distance
/// running fastest. Throws InputError, which names the option, if one of them makes no sense.
[[nodiscard]] std::vector<AdiabaticHypotheses> statements_of(const AdiabaticWords& claim, Deltas deltas);

/// Of --accuracy: greater than 0, at most 1. Throws InputError.
[[nodiscard]] Rational accuracy_of(const AdiabaticWords& claim);

}  // namespace dumbbell
