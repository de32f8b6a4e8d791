#pragma once

#include <optional>

#include "adiabatic/search.hpp"

namespace dumbbell::adiabatic {

/// The orbit of a found initial condition, enclosed: that it satisfies the claim's hypotheses, and a lower
/// bound of its error in the claim's unit, by the rules of format-adiabatic.md, section 6, with some
/// slack. Nothing if that is not certain.
[[nodiscard]] std::optional<AdiabaticState> attained(const AdiabaticSearch& search,
                                                     const AdiabaticSample& sample);

}  // namespace dumbbell::adiabatic
