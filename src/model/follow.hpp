#pragma once

#include <algorithm>
#include <vector>

#include "model/first_flight.hpp"
#include "model/later_count.hpp"

/// The orbits of a box of initial states, collision by collision, as far as all of them share it.
namespace dumbbell {

/// What was found: the collisions that every state of the box has, in order, enclosed; and bounds of their
/// number.
template <class S>
struct Followed {
    std::vector<Bounce<S>> bounces;
    LaterCount total;  ///< of all collisions; may be exact beyond the enclosed ones

    [[nodiscard]] bool complete() const { return total.most == static_cast<long>(bounces.size()); }
};

struct FollowOptions {
    long most_spans = 20000;         ///< of the first flight's proof
    bool stop_when_counted = false;  ///< the number is all that is wanted
};

/// The orbits from their first event on, which is given.
template <class S>
[[nodiscard]] Followed<S> follow_from(const State<S>& start, Event<S> event, const FollowOptions& options) {
    Followed<S> result;
    LaterCount& total = result.total;
    State<S> s = start;
    if (event.next == Next::unknown) {
        total = {certainly_positive(-range(s.yhatdot)) ? 1 : 0, most_collisions(range(s.r))};
        return result;
    }
    const auto done = [&] { return static_cast<long>(result.bounces.size()); };
    while (event.next == Next::contact) {
        result.bounces.push_back(bounce(s, event.mass, *event.time));
        s = result.bounces.back().after;
        if (options.stop_when_counted) {
            const LaterCount later = later_collisions(s, event.mass);
            if (later.exact()) {
                total = {done() + later.least, done() + later.least};
                return result;
            }
        }
        event = event_after_contact(s, event.mass);
    }
    if (event.next == Next::none) {
        total = {done(), done()};
        return result;
    }
    // Undecided here: the monotone counts may still know, from here or from an earlier collision on.
    total.most = most_collisions(range(s.r));
    for (long i = 0; i < done() && !total.exact(); ++i) {
        const auto& b = result.bounces[static_cast<std::size_t>(i)];
        const LaterCount later = later_collisions(b.after, b.mass);
        total.least = std::max({total.least, done(), i + 1 + later.least});
        if (later.most) {
            total.most = std::min(total.most.value_or(i + 1 + *later.most), i + 1 + *later.most);
        }
    }
    return result;
}

/// Precondition: both masses of every state are above the floor, and none is at rest.
template <class S>
[[nodiscard]] Followed<S> follow(const State<S>& start, const FollowOptions& options) {
    return follow_from(start, event_from_air(start, options.most_spans), options);
}

}  // namespace dumbbell
