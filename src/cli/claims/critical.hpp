#pragma once

#include "cli/options/option.hpp"
#include "critical/enclose.hpp"

namespace dumbbell::cli {

inline constexpr Option critical_digits_option =
    Option{"--digits", "N", "significant digits, all of them proved", "15"}.from(1, critical::most_digits);

}  // namespace dumbbell::cli
