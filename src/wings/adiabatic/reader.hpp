#pragma once

#include "adiabatic/certificate.hpp"

namespace dumbbell::adiabatic {

/// Reads a certificate about the adiabatic invariant back into data, as read_certificate does with those
/// about mass ratios: no verification. Throws InputError (naming file and line) if it cannot be read.
[[nodiscard]] Certificate read_certificate(const NamedFile& file);

}  // namespace dumbbell::adiabatic
