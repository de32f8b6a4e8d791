#pragma once

#include "number/big_interval.hpp"
#include "number/interval.hpp"

/// What the dynamics need to know of the values that they are evaluated with: plain enclosures (natural
/// form), or jets (mean value form, starts/air/jet.hpp).
namespace dumbbell {

/// The interval type in which a value's range is known.
template <class S>
struct EnclosureOf {
    using Type = S;
};
template <class S>
using Enclosure = typename EnclosureOf<S>::Type;

/// All values over the box.
[[nodiscard]] inline Interval range(const Interval& x) noexcept { return x; }
[[nodiscard]] inline BigInterval range(const BigInterval& x) { return x; }

/// The common part of two enclosures of the same numbers; the first one if either is no interval.
template <class I>
[[nodiscard]] I intersection(const I& a, const I& b) {
    if (!certainly_at_most(low_end(a), high_end(b)) || !certainly_at_most(low_end(b), high_end(a))) {
        return a;
    }
    return hull(max(low_end(a), low_end(b)), min(high_end(a), high_end(b)));
}

/// The same, but the second one if only that is an interval.
[[nodiscard]] inline Interval common_part(const Interval& a, const Interval& b) {
    return certainly_at_most(low_end(a), high_end(a)) ? intersection(a, b) : b;
}
[[nodiscard]] inline BigInterval common_part(const BigInterval& a, const BigInterval& b) {
    return certainly_at_most(low_end(a), high_end(a)) ? intersection(a, b) : b;
}

/// |X| as an upper bound of the absolute values.
template <class I>
[[nodiscard]] I magnitude(const I& x) {
    return high_end(max(x, -x));
}

}  // namespace dumbbell
