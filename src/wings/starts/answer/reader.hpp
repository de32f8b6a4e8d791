#pragma once

#include "starts/cover/certificate.hpp"

namespace dumbbell::starts {

/// Reads a certificate about initial conditions back into data, as read_certificate does with those about
/// mass ratios: no verification. Throws InputError (naming file and line) if it cannot be read.
[[nodiscard]] Certificate read_certificate(const NamedFile& file);

}  // namespace dumbbell::starts
