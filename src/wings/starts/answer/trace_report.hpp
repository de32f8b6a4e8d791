#pragma once

#include <optional>
#include <string>

#include "starts/air/exact_event.hpp"
#include "starts/answer/trace.hpp"
#include "starts/cover/subdivide.hpp"
#include "starts/given/given_start.hpp"
#include "words/json.hpp"

namespace dumbbell::starts {

/// The most that may be asked for.
inline constexpr int most_trace_digits = 10'000;

/// What `trace` tells its user.
struct TraceReport {
    Box box;
    Trace trace{};
    int digits = 0;  ///< as asked for; 0: double precision
    std::optional<Subdivision> parts{};
    double seconds = 0;
    std::optional<std::string> out{};
    std::optional<std::string> sha256{};
    /// Of all trajectories at these mass ratios, by theorem 1: for those who ask what a bound rests on.
    std::optional<long> maximum{};
    StartMeaning meaning{};
    bool incoming = false;  ///< all incoming trajectories (incoming.hpp): no orbit, but `parts`
    bool shares = false;    ///< bounds of the share of each number of collisions instead of what is decided

    [[nodiscard]] bool is_single() const { return meaning.is_single || box.is_point(); }
};

/// The table of collisions, the widths, and the outcome in a sentence; the shares of a subdivision.
[[nodiscard]] std::string to_text(const TraceReport& report);
[[nodiscard]] Json to_json(const TraceReport& report);

/// The corner or the grazing contact that exact arithmetic finds in the first flight of all its starts.
[[nodiscard]] std::optional<ExactEvent> event_of(const TraceReport& report);

/// "exactly k collisions", "between a and b collisions: ...", or "cannot be decided at this precision: ..."
/// with what to do, and the corner or grazing contact next to it; "... at any precision" of a certain corner.
[[nodiscard]] std::string outcome_sentence(const TraceReport& report);

/// The outcome, what it rests on, and what the parts of a box say.
[[nodiscard]] std::string verdict(const TraceReport& report);

}  // namespace dumbbell::starts
