#pragma once

#include <optional>

#include "law/certificate.hpp"

namespace dumbbell::law {

struct LawRequest {
    int jobs = 1;
    Interrupted interrupted = never;
    Observer* observer = &nobody;
};

/// The law for every mass ratio (proofs/law.md): all that rests on a computation, proved. Nothing if
/// interrupted or not proved. The result does not depend on the number of jobs. Throws BrokenInvariant if the
/// arithmetic of a thread is not sound.
[[nodiscard]] std::optional<LawCertificate> prove_law(const LawRequest& request);

}  // namespace dumbbell::law
