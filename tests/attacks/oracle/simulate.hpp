// Event-driven simulation of the dumbbell over the floor, in physical coordinates.
#pragma once

#include <vector>

#include "body.hpp"

namespace dumbbell_oracle {

template <class S>
struct Collision {
    S time;
    Mass mass;
    State<S> before;  // before and after share phi and y; y is the height at which `mass` stands on the floor
    State<S> after;
};

// What makes a count doubtful. The thresholds of `doubtful` are for long double.
template <class S>
struct Care {
    S least_sine = 1;       // least grazing sine of a collision
    S least_clearance = 1;  // least height, in units of the mass's arm, at a minimum that was no contact
    S least_gap = 1;        // least height of the other mass at a contact (the sine of the corner distance)

    void include(const Care& more);
    [[nodiscard]] bool near_corner(double tolerance = 1e-4) const { return least_gap < tolerance; }
    [[nodiscard]] bool near_tangent(double tolerance = 1e-9) const {
        return least_sine < tolerance || least_clearance < tolerance;
    }
    [[nodiscard]] bool doubtful() const { return near_corner() || near_tangent(); }
};

template <class S>
struct Run {
    std::vector<Collision<S>> collisions;
    State<S> last;  // after the last collision, or the given state
    Care<S> care;
};

// All collisions from now on. `touching` names the mass that stands on the floor now and is leaving it.
// Throws std::runtime_error after `limit` collisions.
template <class S>
[[nodiscard]] Run<S> simulate(const Dumbbell<S>& body, State<S> state, Mass touching = Mass::none,
                              std::size_t limit = 10'000'000);

// A state on the floor, just after the collision of `mass`.
template <class S>
struct Contact {
    Mass mass;
    State<S> after;
};

template <class S>
struct Total {
    std::size_t collisions = 0;
    std::size_t light = 0;
    std::size_t heavy = 0;
    Care<S> care;
};

// Backward + 1 + forward.
template <class S>
[[nodiscard]] Total<S> total_collisions(const Dumbbell<S>& body, const Contact<S>& contact);

// Backward + forward of a state in free flight.
template <class S>
[[nodiscard]] Total<S> total_collisions(const Dumbbell<S>& body, const State<S>& flight);

// The whole trajectory in order of time, from its first collision on (times count from the given contact); or
// without what is before or after the contact.
template <class S>
[[nodiscard]] std::vector<Collision<S>> whole_trajectory(const Dumbbell<S>& body, const Contact<S>& contact,
                                                         bool with_earlier = true, bool with_later = true);

}  // namespace dumbbell_oracle
