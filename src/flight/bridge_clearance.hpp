#pragma once

#include <algorithm>
#include <cmath>

#include "flight/chart.hpp"

namespace dumbbell::flight {

/// Whether every ray that leaves R at a corner distance at most `at` and with slope at most r lambda, for
/// every r in the range, certainly crosses the bridge (L9 (c)): some t in (0, pi) has sin e + kappa (e + t) <
/// r sin t, written here in units of r.
template <class I>
bool certainly_meets_bridge(const Position<I>& at, const I& lambda, const RatioRange<I>& range) {
    const double slope = approximate(lambda);
    if (!(slope < 1)) {
        return false;  // as steep as the bridge anywhere
    }
    const I t(std::acos(std::max(0.0, slope)));  // where the bridge is parallel to the ray; any t would do
    return certainly_less(at.sin_e / range.r_lo + lambda * (at.e + t), sin_cos(t).sin);
}

}  // namespace dumbbell::flight
