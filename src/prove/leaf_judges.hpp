#pragma once

#include <optional>

#include "certificate/certificate.hpp"
#include "model/interrupted.hpp"
#include "prove/section.hpp"

/// One function per section: the reason that closes a box of one of its charts, if any, or none if
/// interrupted. `judge` (leaf.hpp) dispatches.
namespace dumbbell {

template <class I>
[[nodiscard]] std::optional<Leaf> judge_turning(Chart chart, const Box& box, long upper,
                                                const Interrupted& interrupted);

/// Full section (L15), its plain form (L16), and its chart `again` (L19).
template <class I>
[[nodiscard]] std::optional<Leaf> judge_full(Chart chart, const Box& box, long upper,
                                             const Interrupted& interrupted);

/// The straight wedge (L17); the hybrid has the same cover (L18).
template <class I>
[[nodiscard]] std::optional<Leaf> judge_wedge(const Box& box, long upper, const Interrupted& interrupted);

}  // namespace dumbbell
