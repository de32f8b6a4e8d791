#pragma once

#include "adiabatic/certificate.hpp"
#include "base/interrupted.hpp"
#include "base/observer.hpp"

/// Proofs about the adiabatic invariant (proofs/adiabatic.md).
namespace dumbbell::adiabatic {

struct Request {
    Hypotheses of;
    Rational accuracy = Rational(1, 10);  ///< relative, of a bound over the attained value
    long most_collisions = 1'000'000;     ///< of the attained orbit of a run
    int jobs = 1;
    Interrupted interrupted = never;
    Observer* observer = &nobody;  ///< told of boxes that are judged
};

/// What was proved, in the claim's unit: |errors| <= bounds, and orbits that attain almost as much. Bounds
/// and orbits that were not certified are missing.
struct Proof : Certificate {
    std::size_t leaves = 0;  ///< of all trees
    /// The bounds exceed what was attained by more than the accuracy asked for.
    bool coarser = false;
};

/// Throws InputError, in one line that names the option, unless the hypotheses describe a set of positive
/// size to which the statement applies.
void require_sensible(const Hypotheses& of);

/// First an orbit with a great error is looked for and enclosed, then the hypotheses are covered. The result
/// does not depend on the number of jobs, unless interrupted. Precondition: require_sensible(of).
[[nodiscard]] Proof prove(const Request& request);

}  // namespace dumbbell::adiabatic
