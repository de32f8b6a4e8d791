#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/interrupted.hpp"
#include "collisions/certificate.hpp"
#include "collisions/section.hpp"

/// One function per section: the reason that closes a box of one of its charts, if any, or none if
/// interrupted. `judge` (leaf.hpp) dispatches.
namespace dumbbell::collisions {

template <class I>
[[nodiscard]] std::optional<Leaf> judge_turning(Chart chart, const Box& box, const Count& upper,
                                                const Interrupted& interrupted);

/// What the batch kernel says of a box: it is closed; or it is not, and closer bounds would not close it
/// either; or only they can tell.
enum class BoxJudgement { closed, open, unsure };

/// judge_turning in double for many boxes at once, with the bounds of the batch kernel (L39): results[i] is
/// set where it closes boxes[i], and empty where not.
[[nodiscard]] std::vector<BoxJudgement> judge_turning_together(Chart chart, std::span<const Box> boxes,
                                                               long upper,
                                                               std::span<std::optional<Leaf>> results,
                                                               const Interrupted& interrupted);

/// Full section (L15), its plain form (L16), and its chart `again` (L19).
template <class I>
[[nodiscard]] std::optional<Leaf> judge_full(Chart chart, const Box& box, long upper,
                                             const Interrupted& interrupted);

/// The straight wedge (L17); the hybrid has the same cover (L18).
template <class I>
[[nodiscard]] std::optional<Leaf> judge_wedge(const Box& box, long upper, const Interrupted& interrupted);

}  // namespace dumbbell::collisions
