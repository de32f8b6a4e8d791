#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/interrupted.hpp"
#include "flight/batch/query.hpp"

/// Certified bounds of G (L4, L5) for many rays at once.
namespace dumbbell::flight::batch {

/// What runs the kernel. All of them give the same answers, bit for bit.
enum class Backend { portable, avx2, avx512 };

[[nodiscard]] std::string_view name(Backend backend);
/// Those that this machine can run, slowest first.
[[nodiscard]] std::vector<Backend> backends();
/// The fastest of them, or what the environment variable DUMBBELL_BACKEND names. Throws InputError if it
/// names none of them.
[[nodiscard]] Backend chosen_backend();

/// Upper bounds of G over all rays at or above queries[i].ray in c, kappa and r, of which it is the lowest,
/// flattest one: answers[i].count, whatever the other queries are; cap + 1 if none up to the cap is certain,
/// also if interrupted. Throws BrokenInvariant unless there are as many answers as queries, no cap is above
/// greatest_cap, and this thread's arithmetic is sound (require_sound_arithmetic).
void count_at_most(std::span<const Query> queries, std::span<Answer> answers, Backend backend,
                   const Interrupted& interrupted = never);

/// Lower bounds of G, at most the cap, over all rays at or below queries[i].ray (c >= 0 for them too), of
/// which it is the highest, steepest one; 0 if interrupted. Throws like count_at_most.
void count_at_least(std::span<const Query> queries, std::span<Answer> answers, Backend backend,
                    const Interrupted& interrupted = never);

}  // namespace dumbbell::flight::batch
