// Plain recomputation in 80 digits (about 266 bits), with the oracle's formulas: what the certified counts
// and covers are compared with. Shares no arithmetic and no code with src/.
#pragma once

#include <string>

#include "attacks/oracle/ray_count.hpp"
#include "attacks/oracle/scalar.hpp"
#include "number/rational.hpp"
#include "rooms/number/random.hpp"

namespace dumbbell_test {

using Real = dumbbell_oracle::Digits80;
using dumbbell::Rational;

inline Rational at(const char* ratio) { return dumbbell::parse_rational(ratio); }

inline Real real(const Rational& x) { return Real(numerator(x).str()) / Real(denominator(x).str()); }

// N* at an exact mass ratio, by the theorem of theory section 4.
inline long reference_maximum(const Rational& q) {
    return static_cast<long>(dumbbell_oracle::theorem(real(q)).maximum());
}

struct Sides {
    long forward;
    long backward;
};

// The counts of both rays of a contact with the bridge.
inline Sides bridge_counts(const Rational& e, const Rational& eta, const Rational& q) {
    const dumbbell_oracle::BridgeState<Real> state{real(e), real(eta)};
    const Real r = 1 / real(q);
    return {static_cast<long>(ray_count(dumbbell_oracle::bridge_ray(state, r), r)),
            static_cast<long>(ray_count(dumbbell_oracle::bridge_ray_reversed(state, r), r))};
}

// In [lo, hi], often at an end.
inline Rational between(Random& random, const Rational& lo, const Rational& hi) {
    const double pick = random.uniform(0, 1);
    if (pick < 0.3) {
        return lo;
    }
    if (pick < 0.6) {
        return hi;
    }
    return lo + (hi - lo) * dumbbell::exact(random.uniform(0, 1));
}

}  // namespace dumbbell_test
