// Critical ratios from the recomputation in 80 digits: where the theorem's value steps up to n.
#pragma once

#include <array>
#include <map>
#include <stdexcept>
#include <vector>

#include "reference.hpp"
#include "scale.hpp"

namespace dumbbell_test {

// What is tried: the sharpest, and from scale 20 on the others, too.
template <class T = long>
std::vector<T> steps(std::vector<T> sharpest, const std::vector<T>& others) {
    if (scaled(1) >= 20) {
        sharpest.insert(sharpest.end(), others.begin(), others.end());
    }
    return sharpest;
}

// A decimal within 1e-60 (relative) of q_c(n), n >= 4.
inline Rational critical_ratio(long n) {
    static std::map<long, Rational> known;
    if (const auto found = known.find(n); found != known.end()) {
        return found->second;
    }
    // N* - 2 - C sqrt q lies between -1.02 and 0.12 (theory, section 4).
    const auto about = [](double steps) { return std::max(1.0, steps) * std::max(1.0, steps) / 0.7842794; };
    Real lo = about(static_cast<double>(n) - 2.2);
    Real hi = about(static_cast<double>(n) - 0.8);
    const auto reached = [n](const Real& q) {
        return static_cast<long>(dumbbell_oracle::theorem(q).maximum()) >= n;
    };
    if (reached(lo) || !reached(hi)) {
        throw std::logic_error("critical_ratio: no step between the ends");
    }
    while (hi - lo > lo * Real("1e-60")) {
        const Real middle = (lo + hi) / 2;
        (reached(middle) ? hi : lo) = middle;
    }
    return known[n] = dumbbell::parse_rational(lo.str(65, std::ios::fixed));
}

}  // namespace dumbbell_test
