#pragma once

#include <algorithm>
#include <vector>

#include "base/interrupted.hpp"
#include "base/observer.hpp"
#include "starts/air/first_flight.hpp"
#include "starts/air/jet.hpp"
#include "starts/walls/body_count.hpp"
#include "starts/walls/wall_to_wall.hpp"

/// The orbits of a box of initial states, collision by collision, as far as all of them share it.
namespace dumbbell::starts {

/// What was found: the collisions that every state of the box has, in order, enclosed; and bounds of their
/// number.
template <class S>
struct Followed {
    std::vector<Bounce<S>> bounces;
    LaterCount total;  ///< of all collisions; may be exact beyond the enclosed ones
    bool interrupted = false;

    [[nodiscard]] bool complete() const { return total.most == static_cast<long>(bounces.size()); }
};

inline constexpr long most_first_spans = 20000;

/// No dumbbell with such a ratio has more; of bodies nothing is said.
template <class S>
[[nodiscard]] std::optional<long> most_of_all(const State<S>& s, const Interrupted& interrupted) {
    return s.body.is_massless ? most_collisions(range(s.body.r), count_cap, interrupted) : std::nullopt;
}

/// Precondition: both masses of every state are above the floor, and none is at rest. `most_spans`: of the
/// first flight's proof. `observer` is told of each collision. Interrupted it knows those so far, and that
/// there are as many.
template <class S>
[[nodiscard]] Followed<S> follow(const State<S>& start, long most_spans = most_first_spans,
                                 Observer& observer = nobody, const Interrupted& interrupted = never) {
    Followed<S> result;
    LaterCount& total = result.total;
    const Event<S> first = event_from_air(start, most_spans, interrupted);
    if (first.next == Next::none) {
        total = {0, 0};
        return result;
    }
    if (first.next == Next::unknown) {
        total = {certainly_positive(-range(start.yhatdot)) ? 1 : 0, most_of_all(start, interrupted)};
        return result;
    }
    const auto done = [&] { return static_cast<long>(result.bounces.size()); };
    WallToWall<S> orbit(bounce(start, first.end, *first.time));
    Next next = Next::contact;
    while (next == Next::contact) {
        result.bounces.push_back(orbit.last());
        observer.advance(1);
        if (interrupted()) {
            result.interrupted = true;
            total = {done()};
            return result;
        }
        next = orbit.advance();
    }
    if (next == Next::none) {
        total = {done(), done()};
        return result;
    }
    // Undecided here: the monotone counts may still know, from here or from an earlier collision on.
    total = {done(), most_of_all(start, interrupted)};
    for (long i = 0; i < done() && !total.exact() && !interrupted(); ++i) {
        const auto& b = result.bounces[static_cast<std::size_t>(i)];
        const LaterCount later = later_collisions(b.after, b.end, interrupted);
        total.least = std::max(total.least, i + 1 + later.least);
        if (later.most) {
            total.most = std::min(total.most.value_or(i + 1 + *later.most), i + 1 + *later.most);
        }
    }
    return result;
}

// Instantiated once, in follow.cpp, as the largest part of what the room takes to compile.
extern template Followed<Interval> follow(const State<Interval>&, long, Observer&, const Interrupted&);
extern template Followed<BigInterval> follow(const State<BigInterval>&, long, Observer&, const Interrupted&);
extern template Followed<Jet<Interval>> follow(const State<Jet<Interval>>&, long, Observer&,
                                               const Interrupted&);
extern template Followed<Jet<BigInterval>> follow(const State<Jet<BigInterval>>&, long, Observer&,
                                                  const Interrupted&);

}  // namespace dumbbell::starts
