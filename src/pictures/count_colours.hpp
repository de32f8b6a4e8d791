#pragma once

#include <string>
#include <vector>

#include "pictures/frame.hpp"

/// Colours of numbers of collisions: an even, bright-to-dark scale that stays ordered for every kind of
/// colour vision and in grey print (viridis); no collision at all is grey.
namespace dumbbell {

/// The class of the count's colour.
[[nodiscard]] std::string count_kind(long count);

/// Gives each count its colour. Precondition: ascending, none negative.
void colour_counts(Svg& svg, const std::vector<long>& counts);

/// The counts that a legend shows: all, or about a dozen from the least to the greatest.
[[nodiscard]] std::vector<long> shown_counts(const std::vector<long>& counts);

}  // namespace dumbbell
