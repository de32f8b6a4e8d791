#include "starts/answer/witness_start.hpp"

#include <array>

#include "flight/orbit.hpp"
#include "number/decimal.hpp"
#include "starts/answer/trace.hpp"

namespace dumbbell::starts {
namespace {

/// Digits after the point of a start, and those that `trace` is asked for. An orbit of hundreds of collisions
/// forgets digits on its way.
struct Effort {
    int places;
    int digits;
};
constexpr std::array<Effort, 8> efforts{
    {{4, 0}, {8, 0}, {12, 0}, {16, 20}, {32, 40}, {64, 80}, {128, 160}, {256, 320}}};

/// The state before the first collision, at the height 2, where both masses are in the air; with |phidot| =
/// 1, or |ydot| = 1 if the rod hardly turns. Enclosed, but that is not needed: `trace` decides.
struct Start {
    BigInterval phi, phidot, ydot;
};

std::optional<Start> start_of(const collisions::Witness& w, const Rational& q) {
    const BigInterval r = enclose<BigInterval>(Rational(1) / q);
    const auto orbit = enclose_orbit(
        flight::BridgeContact<BigInterval>{enclose<BigInterval>(w.e), enclose<BigInterval>(w.eta),
                                           as_long(w.forward), as_long(w.backward)},
        flight::RatioRange<BigInterval>{r, r});
    if (!orbit || !certainly_positive(-orbit->front().ydot_before)) {
        return std::nullopt;
    }
    const flight::Collision<BigInterval>& first = orbit->front();
    const BigInterval time = (BigInterval(2) - first.y) / -first.ydot_before;
    const bool turns = approximate(first.phidot_before) * approximate(first.phidot_before) > 1e-6;
    const BigInterval& unit = turns ? first.phidot_before : first.ydot_before;
    const BigInterval speed = certainly_positive(unit) ? unit : -unit;
    return certainly_positive(speed)
               ? std::optional(Start{first.phi - first.phidot_before * time, first.phidot_before / speed,
                                     first.ydot_before / speed})
               : std::nullopt;
}

/// The middle of x with this many digits after the point, turned by multiples of `period` towards 0.
Rational rounded(const BigInterval& x, int places, const std::optional<BigInterval>& period = {}) {
    const auto middle = [](const BigInterval& y) { return (exact_lo(y) + exact_hi(y)) / 2; };
    const auto floor = [](const Rational& y) {
        const Integer whole = numerator(y) / denominator(y);
        return y < whole ? Integer(whole - 1) : whole;
    };
    Rational value = middle(x);
    if (period) {
        const Rational turn = middle(*period);
        value -= turn * Rational(floor(value / turn));
    }
    const Rational unit(pow(Integer(10), static_cast<unsigned>(places)));
    return Rational(floor(value * unit + Rational(1, 2))) / unit;
}

}  // namespace

std::optional<collisions::WitnessStart> witness_start(const collisions::Witness& witness, const Rational& q,
                                                      const Interrupted& interrupted) {
    if (witness.total() > longest_witness || witness.place != collisions::Place::bridge) {
        return std::nullopt;
    }
    for (const auto& [places, digits] : efforts) {
        if (interrupted()) {
            break;
        }
        const PrecisionScope scope(256 + 4 * places);
        const auto start = start_of(witness, q);
        if (!start) {
            continue;
        }
        const Rational phi = rounded(start->phi, places, BigInterval(2) * pi<BigInterval>());
        const Rational phidot = rounded(start->phidot, places);
        const Rational ydot = rounded(start->ydot, places);
        if (ydot >= 0) {
            continue;
        }
        const std::array<Rational, axis_count> point{phi, phidot, 2, ydot, q};
        const Trace found = trace({point, point}, digits);
        if (found.exact() && found.least == witness.total()) {
            return collisions::WitnessStart{spelled(phi), spelled(phidot), "2", spelled(ydot), digits};
        }
    }
    return std::nullopt;
}

}  // namespace dumbbell::starts
