#pragma once

#include "starts/trace.hpp"

namespace dumbbell::starts {

/// An enclosure with `digits` decimal digits: `text` is a decimal and a radius that together cover it, `lo`
/// and `hi` cover it too.
[[nodiscard]] TracedValue traced_value(const BigInterval& x, int digits);
[[nodiscard]] TracedValue traced_value(const Interval& x, int digits);

}  // namespace dumbbell::starts
