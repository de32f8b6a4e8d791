#pragma once

#include <array>
#include <optional>
#include <string>

#include "cli/options/given.hpp"
#include "collisions/claim.hpp"

namespace dumbbell::cli {

/// Which body.
inline constexpr std::array body_options{
    Option{"--rho", "RHO",
           "d2/d1 of the distances of the contacts from the centre of mass; certify: or LO:HI"}
        .of("bodies"),
    Option{"--inertia", "Q", "(d1/k)^2, k the radius of gyration, or a range LO:HI"}.needs("--rho").of(
        "bodies"),
    flag("--coin", "a thin coin that turns in a plane, about a horizontal diameter: --rho 1 --inertia 4")
        .excludes("--rho,--rod-mass")
        .of("bodies"),
    Option{"--rod-mass", "MU", "the dumbbell RATIO with a uniform rod of MU times the mass of both ends"}
        .excludes("--rho")
        .of("bodies")};

/// Whether an option says that the claim is about a body with mass between its contacts.
[[nodiscard]] bool is_about_body(const Given& given);

/// The claim about it, with the usual gap; of a list its line is RATIO with --rod-mass, and Q with --rho.
/// Throws InputError if the options do not say, or say no body whose mass is between its contacts.
[[nodiscard]] collisions::Claim body_claim(const Given& given,
                                           const std::optional<std::string>& line = std::nullopt);

}  // namespace dumbbell::cli
