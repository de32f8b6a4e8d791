#pragma once

#include <string>

#include "starts/certificate.hpp"

namespace dumbbell::pictures {

/// How likely each number of collisions is, from a certificate about initial conditions, as a self-contained
/// SVG: a bar up to the share that the leaves prove at least, hatched from there to what they prove at most.
/// The scale is logarithmic, for the records are rare. Throws InputError if nothing of the box is decided.
[[nodiscard]] std::string shares_svg(const starts::InitialCertificate& certificate);

}  // namespace dumbbell::pictures
