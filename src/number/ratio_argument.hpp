#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "number/rational.hpp"

namespace dumbbell {

/// A RATIO or LO:HI of the command line as mass ratios >= 1.
struct RatioArgument {
    Rational lo;
    Rational hi;
    bool swapped = false;  ///< the user gave ratios below 1: the masses are renamed, q -> 1/q
};

/// Throws InputError for anything that is no ratio, is 0, has LO > HI, or crosses 1.
[[nodiscard]] RatioArgument parse_ratio_argument(const std::string& text);

/// REL of --gap: 1e-300 <= REL <= 0.01. Throws InputError.
[[nodiscard]] Rational parse_gap(const std::string& text);

/// The exact number of an option. Throws InputError, which names the option.
[[nodiscard]] Rational parse_number(std::string_view option, const std::string& text);

/// TIME of an option: a number with s, m or h. Throws InputError, which names the option.
[[nodiscard]] std::chrono::duration<double> parse_duration(const std::string& text,
                                                           std::string_view option = "--budget");

}  // namespace dumbbell
