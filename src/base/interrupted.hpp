#pragma once

#include <functional>

namespace dumbbell {

/// What a long computation asks now and then, from any thread: whether to end early. What it had not decided
/// by then is undecided, never wrong.
using Interrupted = std::function<bool()>;

inline const Interrupted never = [] { return false; };

/// Flights of a ray between two questions: some hundredths of a second at the highest precision.
inline constexpr long flights_between_questions = 256;

/// Whether a computation that has done this number of flights is to end.
template <class Number>
[[nodiscard]] bool ends_early(const Number& flights, const Interrupted& interrupted) {
    return flights % flights_between_questions == flights_between_questions - 1 && interrupted();
}

}  // namespace dumbbell
