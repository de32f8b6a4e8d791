#pragma once

#include <string>
#include <vector>

#include "adiabatic/certificate.hpp"

namespace dumbbell::adiabatic {

/// A statement about the adiabatic invariant as a unit of an order:
///
///     case CLAIM D1 D2 Y1 Y2 M K
///
/// in exact fractions, the claim as certificates name it, `-` for what is no part of the statement. Two
/// statements are the same if and only if their units are.
[[nodiscard]] std::string case_of(const AdiabaticHypotheses& of);

/// And back. Throws InputError unless it is spelt like that, and require_sensible has no objection.
[[nodiscard]] AdiabaticHypotheses parse_case(const std::string& unit);

/// The same for people: theorem, D1, D2, Y1, Y2, M, K as `dumbbell adiabatic` reads them, exactly.
[[nodiscard]] std::vector<std::string> columns_of(const AdiabaticHypotheses& of);

/// The options of `dumbbell adiabatic` for these statements, all of one claim: those of a whole grid, with a
/// list of each quantity.
[[nodiscard]] std::string options_of(const std::vector<AdiabaticHypotheses>& grid);

}  // namespace dumbbell::adiabatic
