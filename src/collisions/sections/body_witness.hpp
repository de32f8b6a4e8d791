#pragma once

#include <optional>

#include "base/interrupted.hpp"
#include "collisions/certificate.hpp"

/// Contacts of bodies with the bridge that have many collisions before and after (lemma L74).
namespace dumbbell::collisions {

/// The most collisions that a contact of a grid has in the body (rho, Q): a guess of the maximum.
[[nodiscard]] long greatest_found(const Rational& q, const Rational& rho, const Interrupted& interrupted);

/// A contact with at least `target` collisions in all, for every Q in the range and every rho of the system,
/// if one is found.
[[nodiscard]] std::optional<Witness> found_contact(const Range& range, const System& system, long target,
                                                   const Interrupted& interrupted);

}  // namespace dumbbell::collisions
