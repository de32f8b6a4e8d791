#pragma once

#include <array>
#include <optional>

#include "cli/options/given.hpp"
#include "collisions/claim.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::cli {

inline constexpr Option ratio_option = argument("RATIO", "mass ratio, or closed range LO:HI");

/// What `certify` is to prove of it.
inline constexpr std::array claim_options{
    Option{"--section", "turning|full|plain",
           "what is covered: turning (one collision of each trajectory), full (all collision states, counted "
           "forward), or plain (full, by interval evaluation alone)",
           "turning"},
    Option{"--gap", "REL", "ranges: relative width of the gap around a critical ratio, from 1e-300 to 0.01",
           "1e-6"}};

/// What is said first if the ratios were given below 1.
inline constexpr const char* masses_are_swapped = "Ratios below 1: the masses are swapped, q -> 1/q.\n";

/// The claim; of a list the one of a line. Throws InputError if the options contradict one another, or are
/// out of reach.
[[nodiscard]] collisions::Claim claim_of(const Given& given, const std::optional<std::string>& line);

}  // namespace dumbbell::cli
