#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "batch/query.hpp"
#include "model/interrupted.hpp"

/// Certified bounds of G (L4, L5) for many rays at once.
namespace dumbbell::batch {

/// What runs the kernel. All of them give the same answers, bit for bit.
enum class Backend { plain, avx2, avx512 };

[[nodiscard]] std::string_view name(Backend backend);
/// Those that this machine can run, slowest first.
[[nodiscard]] std::vector<Backend> backends();
/// The fastest of them, or what the environment variable DUMBBELL_BACKEND names. Throws InputError if it
/// names none of them.
[[nodiscard]] Backend chosen_backend();

/// answers[i] for queries[i], whatever the others are. Precondition: as many answers as queries.
void count_at_most(std::span<const Query> queries, std::span<Answer> answers, Backend backend,
                   const Interrupted& interrupted = never);

}  // namespace dumbbell::batch
