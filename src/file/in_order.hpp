#pragma once

#include <cstddef>
#include <functional>

#include "base/interrupted.hpp"

namespace dumbbell {

/// Hands on what came of a piece of work. False: no more is wanted.
using HandOn = std::function<bool()>;
/// A piece of work; empty: there is no more.
using Work = std::function<HandOn()>;

/// Works on a stream of unknown length, on `jobs` threads as in `parallel.hpp`. `next` is called by one
/// thread at a time, and what came of the work is handed on by one thread at a time, in the order in which
/// `next` gave it. While `next` waits, what is done is handed on; it is told how to ask whether it waits in
/// vain, for no more is wanted. At most `pieces_ahead` pieces for each thread are begun and not handed on, so
/// that memory does not grow with the stream. Throws what the first piece to fail, or `next`, or a HandOn,
/// throws.
inline constexpr std::size_t pieces_ahead = 64;
void in_order(int jobs, const std::function<Work(const Interrupted& in_vain)>& next);

}  // namespace dumbbell
