#pragma once

#include "campaign/kind.hpp"
#include "staircase/critical_range.hpp"

namespace dumbbell::campaign {

/// Critical ratios: what `dumbbell critical N1:N2` encloses. A unit is one of them, a result an enclosure for
/// each, and merged they are the table that `critical --out` writes. There is no certificate of them: a
/// result is checked by the signs of the margin at both ends of each enclosure (certainly_encloses).
[[nodiscard]] const Kind& critical_kind();

/// Cuts the request's counts; `shards`: how many at most, if the user has a wish. Throws InputError if there
/// is only one.
[[nodiscard]] Plan plan_critical(const staircase::CriticalRequest& request,
                                 std::optional<std::size_t> shards);

}  // namespace dumbbell::campaign
