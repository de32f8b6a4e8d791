#pragma once

#include <string>

#include "dumbbell/interval.hpp"
#include "dumbbell/mass_ratio.hpp"

/// The law of N(q) for every mass ratio (proofs/law.md). It rests on a certificate, whose steps are in the
/// library: certificates/law.dbc.gz, which the verifier verifies.
namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

/// Numbers of any size as decimal digits.
struct Law {
    std::string least;  ///< least <= N(q) <= most; they differ by one if q is too near a step
    std::string most;
    std::string step;  ///< the n whose step, at q_c(n), is nearest to q
    Interval past;     ///< how far q is past that step; the way to the next one is 1
};

/// What the law says of one mass ratio. Throws InputError for a range.
[[nodiscard]] [[gnu::visibility("default")]] Law law(const MassRatio& ratio);

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
