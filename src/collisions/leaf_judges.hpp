#pragma once

#include <optional>

#include "base/interrupted.hpp"
#include "collisions/certificate.hpp"
#include "collisions/section.hpp"

/// One function per section: the reason that closes a box of one of its charts, if any, or none if
/// interrupted. `judge` (leaf.hpp) dispatches.
namespace dumbbell::collisions {

template <class I>
[[nodiscard]] std::optional<Leaf> judge_turning(Chart chart, const Box& box, const Count& upper,
                                                const Interrupted& interrupted);

/// Whether the counts that would have to be less are certainly not: no precision closes the box. Only to save
/// work.
[[nodiscard]] bool is_open_turning(Chart chart, const Box& box, long upper, const Interrupted& interrupted);

/// Full section (L15), its plain form (L16), and its chart `again` (L19).
template <class I>
[[nodiscard]] std::optional<Leaf> judge_full(Chart chart, const Box& box, long upper,
                                             const Interrupted& interrupted);

/// The straight wedge (L17); the hybrid has the same cover (L18).
template <class I>
[[nodiscard]] std::optional<Leaf> judge_wedge(const Box& box, long upper, const Interrupted& interrupted);

}  // namespace dumbbell::collisions
