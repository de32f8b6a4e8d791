#pragma once

#include <map>
#include <string>
#include <vector>

#include "number/count.hpp"
#include "pictures/frame.hpp"

/// Colours of numbers of collisions: an even, bright-to-dark scale that stays ordered for every kind of
/// colour vision and in grey print (viridis); no collision at all is grey.
namespace dumbbell::pictures {

[[nodiscard]] std::string count_kind(const Count& count);

/// A Shade that owns its text.
struct CountShade {
    std::string light;
    std::string dark;
    [[nodiscard]] Shade shade() const { return {light, dark}; }
};

/// The colours of these counts, the same in every picture. Precondition: ascending, none negative.
[[nodiscard]] std::map<Count, CountShade> count_shades(const std::vector<Count>& counts);

/// Gives each count its colour. Precondition: as count_shades.
void colour_counts(Svg& svg, const std::vector<Count>& counts);

/// The counts that a legend shows: all, or about a dozen from the least to the greatest.
[[nodiscard]] std::vector<Count> shown_counts(const std::vector<Count>& counts);

}  // namespace dumbbell::pictures
