// Small tools shared by the test files of this folder.
#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include "sampler.hpp"
#include "scalar.hpp"
#include "scale.hpp"

namespace dumbbell_oracle {

using Real = long double;

// One message with every number in full: a failure must be reproducible from its text.
template <class... T>
[[nodiscard]] std::string say(const T&... parts) {
    std::ostringstream out;
    out.precision(21);
    ((out << parts << ' '), ...);
    return out.str();
}

[[nodiscard]] inline bool close(Real a, Real b, Real tolerance) {
    return std::abs(a - b) <= tolerance * (1 + std::max(std::abs(a), std::abs(b)));
}

// A mass ratio >= 1: half of them spread over the decades, half near 1 or in the range of the first few
// steps.
[[nodiscard]] inline double random_ratio(Sampler& sampler, double greatest = 1e6) {
    if (sampler.coin()) return sampler.log_uniform(1, greatest);
    return sampler.coin() ? 1 + sampler.log_uniform(1e-9, 1) : sampler.uniform(1, 40);
}

// A value in [lo, hi], often at or very near an end.
[[nodiscard]] inline double biased(Sampler& sampler, double lo, double hi) {
    const double span = hi - lo;
    const double pick = sampler.uniform(0, 1);
    if (pick < 0.05) return lo;
    if (pick < 0.25) return lo + span * sampler.log_uniform(1e-9, 1);
    if (pick < 0.45) return hi - span * sampler.log_uniform(1e-9, 1);
    return sampler.uniform(lo, hi);
}

}  // namespace dumbbell_oracle
