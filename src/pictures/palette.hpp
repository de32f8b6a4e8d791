#pragma once

#include "pictures/svg.hpp"

/// What has the same colour in every picture; the page of `dumbbell report` has the same ones
/// (web/src/style.css, under the same names; tests/programs/page/draw_test.mjs). Numbers of collisions:
/// count_colours.hpp.
namespace dumbbell::palette {

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

}  // namespace dumbbell::palette
