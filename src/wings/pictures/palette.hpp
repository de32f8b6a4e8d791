#pragma once

#include <array>

#include "pictures/svg.hpp"

/// What has the same colour in every picture, those of the page of `dumbbell report` included. Numbers of
/// collisions: count_colours.hpp.
namespace dumbbell::pictures::palette {

inline constexpr Shade proved{"#0055a4", "#6db1ff"};
inline constexpr Shade paper{"#c8501e", "#ff9d66"};
inline constexpr Shade growth{"#1d2430", "#e6e9ee"};
inline constexpr Shade gap{"#e69f00", "#f0b429"};

inline constexpr Shade light{"#d55e00", "#ff9248"};
inline constexpr Shade heavy{"#0072b2", "#58b4f5"};
inline constexpr Shade floor{"#edf0f3", "#20262f"};

inline constexpr Shade outside{"#e8eaed", "#39424c"};
inline constexpr Shade meets{"#e69f00", "#e69f00"};
inline constexpr Shade meets_reversed{"#cc79a7", "#cc79a7"};
inline constexpr Shade once{"#56b4e9", "#56b4e9"};
inline constexpr Shade witness{"#b3005e", "#ff7ac0"};

inline constexpr Shade no_collision{"#d3d8de", "#4a535d"};
inline constexpr Shade hatch{"#b4bbc3", "#4d5762"};  ///< what is not decided

/// Classes without an order, in the set of Okabe and Ito: they stay apart for every kind of colour vision.
inline constexpr std::array<const char*, 7> classes{"#0072b2", "#e69f00", "#009e73", "#cc79a7",
                                                    "#56b4e9", "#d55e00", "#f0e442"};

}  // namespace dumbbell::pictures::palette
