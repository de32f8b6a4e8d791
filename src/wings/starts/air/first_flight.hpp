#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "base/interrupted.hpp"
#include "starts/air/flight.hpp"

/// The first flight, from the air: proofs for a whole box of states, in time (lemmas L0, L3).
namespace dumbbell::starts {

/// Where a flight from the air seems to end; a guess that proves nothing.
struct FirstContactGuess {
    flight::End end;
    double time;
};
[[nodiscard]] std::optional<FirstContactGuess> guess_first_contact(double phi, double yhat, double phidot,
                                                                   double yhatdot, double r) noexcept;

/// Spans that one of many boxes may cost.
inline constexpr long spans_of_a_box = 1024;

namespace detail {

/// One span of a flight: both masses above the floor, from their clearance at its beginning and the least
/// rate; or, for the mass that touches first (if any), its clearance falling.
template <class S, class I>
bool span_closes(const State<S>& s, std::optional<flight::End> first, const I& a, const I& b) {
    const S span(hull(a, b));
    if (certainly_less(I(1), range(s.yhat + s.yhatdot * span))) {
        return true;  // above every wall
    }
    const Moment<S> begin(s, S(a));
    const Moment<S> within(s, span);
    return std::ranges::all_of(std::array{flight::End::light, flight::End::heavy}, [&](flight::End end) {
        const I rate = range(within.clearance_rate(end));
        return (first == end && certainly_positive(-rate)) ||
               certainly_positive(low_end(range(begin.clearance(end))) + min(I(0), low_end(rate)) * (b - a));
    });
}

}  // namespace detail

/// Whether [0, end] certainly divides into spans on each of which the other mass stays above the floor and
/// the mass `first` stays above it or falls. Then the only contact in [0, end] is one of `first`, and it is
/// its only zero there: once it is down in a span where it falls, it stays below in the spans that follow.
/// Halves the spans, at most `most_spans` of them. False if interrupted.
template <class S, class I>
[[nodiscard]] bool certainly_first(const State<S>& s, std::optional<flight::End> first, const I& end,
                                   long most_spans, const Interrupted& interrupted = never) {
    std::vector<std::pair<I, I>> spans{{I(0), high_end(end)}};
    for (long used = 0; !spans.empty(); ++used) {
        const auto [a, b] = spans.back();
        if (used > most_spans || interrupted()) {
            return false;
        }
        spans.pop_back();
        if (!detail::span_closes(s, first, a, b)) {
            const I middle = midpoint(hull(a, b));
            if (!certainly_less(a, middle) || !certainly_less(middle, b) ||
                !detail::span_closes(s, first, middle, middle)) {
                return false;  // nor does any span from there on
            }
            spans.emplace_back(middle, b);
            spans.emplace_back(a, middle);
        }
    }
    return true;
}

/// The mass that seems to touch first: next to a corner, where both nearly do, not always that of the guess.
template <class S>
[[nodiscard]] flight::End seemingly_first(const State<S>& s, const FirstContactGuess& guess) {
    using I = Enclosure<S>;
    const flight::End opposite = other(guess.end);
    const I time = detail::polished_guess(s, guess.end, I(guess.time));
    const I before = detail::polished_guess(s, opposite, I(guess.time));
    const State<I> middle = detail::middle_of(s);
    const Moment<I> then(middle, before);
    const bool is_contact = certainly_less(magnitude(then.clearance(opposite)), I(0x1p-26)) &&
                            certainly_positive(-then.clearance_rate(opposite));
    return is_contact && certainly_less(before, time) ? opposite : guess.end;
}

/// What is certain without looking for a contact: every state ascends steeply (L3), or from above every wall.
template <class S>
[[nodiscard]] bool certainly_leaves_air(const State<S>& s) {
    using I = Enclosure<S>;
    return certainly_too_steep(s) ||
           (certainly_at_most(I(0), range(s.yhatdot)) && certainly_less(I(1), range(s.yhat)));
}

/// The next event of states in the air, both masses above the floor; unknown if interrupted.
template <class S>
[[nodiscard]] Event<S> event_from_air(const State<S>& s, long most_spans,
                                      const Interrupted& interrupted = never) {
    using I = Enclosure<S>;
    if (certainly_leaves_air(s)) {
        return {Next::none};
    }
    const auto guess = guess_first_contact(approximate(range(s.phi)), approximate(range(s.yhat)),
                                           approximate(range(s.phidot)), approximate(range(s.yhatdot)),
                                           approximate(range(s.body.rho)));
    if (guess) {
        const flight::End end = seemingly_first(s, *guess);
        auto time = contact_time(s, end, I(guess->time));
        if (time && certainly_positive(range(*time)) &&
            certainly_first(s, end, range(*time), most_spans, interrupted)) {
            return {Next::contact, end, std::move(time)};
        }
        return {};
    }
    // Ascending: above every wall from height 1 on.
    if (certainly_positive(range(s.yhatdot)) &&
        certainly_first(s, std::nullopt, range((S(1) - s.yhat) / s.yhatdot), most_spans, interrupted)) {
        return {Next::none};
    }
    return {};
}

}  // namespace dumbbell::starts
