// One certificate file of any claim kind.
#pragma once
#include <string>

#include "verify/kinds/other_claim.hpp"

namespace dumbbell_verify {

/// Returns only if all that the file and the demand say is certified; else throws the Failure of the least
/// line.
Verified verify(Source& bytes, const Request& request);
Verified verify(const std::string& path, const Request& request);

}  // namespace dumbbell_verify
