#pragma once

#include <optional>
#include <string>

#include "base/interrupted.hpp"
#include "collisions/certificate.hpp"
#include "number/rational.hpp"

namespace dumbbell::collisions {

/// The counts that are certain from (e, eta) for every ratio in [q_lo, q_hi], up to `cap` in each direction;
/// nothing if it is no admissible contact there; less than is certain if interrupted. I: Interval or
/// BigInterval.
template <class I>
[[nodiscard]] std::optional<Witness> checked_witness(const Rational& e, const Rational& eta,
                                                     const Rational& q_lo, const Rational& q_hi,
                                                     const Count& cap,
                                                     const Interrupted& interrupted = never);

/// Searches for a witness of at least `target` collisions. The extremal orbits leave the bridge near its top,
/// or near its corner, almost along its tangent; the search tries shorter and shorter distances from both
/// (where to look is a guess, what is returned is checked). Nothing if none is found, or none before it is
/// interrupted.
template <class I>
[[nodiscard]] std::optional<Witness> find_witness(const Rational& q_lo, const Rational& q_hi,
                                                  const Count& target,
                                                  const Interrupted& interrupted = never);

/// The same for bodies: a contact with the bridge that has at least `target` collisions (L74), for every Q of
/// the range; of a certificate by orbits only for its least.
template <class I>
[[nodiscard]] std::optional<Witness> contact_of_body(const Range& range, long target, const System& system,
                                                     const Interrupted& interrupted = never);

/// A dumbbell in the air, as decimals that mean exactly what they spell, in the units of `trace`: rod length
/// 1, phi in radians, y the height of the centre of mass.
struct WitnessStart {
    std::string phi, phidot, y, ydot;
    int digits = 0;  ///< that `trace` needs; 0: double precision suffices
};

}  // namespace dumbbell::collisions
