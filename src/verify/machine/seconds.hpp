// Units of work as seconds.
#pragma once
#include <string>

#include "verify/core/outside.hpp"

namespace dumbbell_verify {

/// Whole ones, or with three decimals.
inline std::string seconds(std::uint64_t units) {
    const std::uint64_t thousandths = units / (units_per_second / 1000), part = thousandths % 1000;
    const std::string decimals = part == 0 ? "" : "." + std::to_string(1000 + part).substr(1);
    return std::to_string(thousandths / 1000) + decimals + " s";
}

}  // namespace dumbbell_verify
