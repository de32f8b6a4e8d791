#pragma once

#include <string>

#include "collisions/certify.hpp"

/// Which bodies a user means.
namespace dumbbell::collisions {

/// Those with this rho and this inertia Q, each a number or LO:HI as it is written: none changes into its
/// inverse. Throws InputError, which names the option, if no body with its mass between its contacts has
/// them (L70).
[[nodiscard]] CertifyRequest body_of(const std::string& rho, const std::string& inertia);

/// The dumbbell q whose uniform rod has mu times the mass of its ends: L70 (d).
[[nodiscard]] CertifyRequest body_of_rod(const Rational& q, const Rational& mu);

}  // namespace dumbbell::collisions
