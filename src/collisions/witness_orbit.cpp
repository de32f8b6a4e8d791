#include "collisions/witness_orbit.hpp"

#include <fmt/core.h>

#include "base/error.hpp"

namespace dumbbell::collisions {
namespace {

template <class I>
Interval outward(const I& x) {
    return {low_end(x).lo(), high_end(x).hi()};
}

template <class I>
std::vector<flight::Collision<Interval>> orbit_in(const Witness& w, const Rational& q) {
    const I r = enclose<I>(Rational(1) / q);
    const auto orbit = enclose_orbit(
        flight::BridgeContact<I>{enclose<I>(w.e), enclose<I>(w.eta), as_long(w.forward), as_long(w.backward)},
        flight::RatioRange<I>{r, r});
    std::vector<flight::Collision<Interval>> result;
    if (orbit) {
        for (const auto& c : *orbit) {
            result.push_back({c.heavy, outward(c.time), outward(c.phi), outward(c.y), outward(c.ydot_before),
                              outward(c.ydot_after), outward(c.phidot_before), outward(c.phidot_after),
                              outward(c.grazing_sine)});
        }
    }
    return result;
}

}  // namespace

std::vector<flight::Collision<Interval>> witness_orbit(const Witness& witness, const Rational& q, int bits) {
    constexpr long most_collisions = 10'000'000;
    if (witness.total() > most_collisions) {
        throw InputError(fmt::format("the orbit has {} collisions: they are listed up to {}", witness.total(),
                                     most_collisions));
    }
    const PrecisionScope scope(bits);
    return bits <= 53 ? orbit_in<Interval>(witness, q) : orbit_in<BigInterval>(witness, q);
}

}  // namespace dumbbell::collisions
