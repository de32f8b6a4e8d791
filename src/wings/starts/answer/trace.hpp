#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/interrupted.hpp"
#include "base/observer.hpp"
#include "flight/orbit.hpp"
#include "starts/cover/certificate.hpp"
#include "starts/walls/obstacle.hpp"

/// The rigorous orbits of a box of initial conditions.
namespace dumbbell::starts {

/// An enclosure for people and programs: outward in doubles, and in decimals as `value+-radius` and by its
/// bounds (rounded outward).
struct TracedValue {
    Interval outward;
    std::string text;
    std::string lo;
    std::string hi;
};

/// The greatest width of phi, y and their velocities after a collision.
struct TracedWidths {
    std::optional<double> natural;  ///< nothing if plain intervals do not get as far
    double correlated = 0;
};

struct Trace {
    std::vector<flight::Collision<TracedValue>>
        collisions;  ///< those that all orbits of the box share, until it splits
    long least = 0;
    std::optional<long> most;
    int bits = 53;
    std::optional<TracedWidths> widths;  ///< after the last of `collisions`; none for a point
    std::optional<Obstacle> obstacle{};  ///< what is not excluded after them; none if the number is exact

    [[nodiscard]] bool exact() const { return most == least; }
};

/// The precision for this number of digits: 53 for 0.
[[nodiscard]] int working_bits(int digits);

/// With digits = 0 in double precision, shown with 12 digits; otherwise with a precision chosen from the
/// digits wanted. `observer` is told of the collisions; interrupted it knows those so far, and that there are
/// as many. Precondition: require_in_play(box).
[[nodiscard]] Trace trace(const Box& box, int digits, Observer& observer = nobody,
                          const Interrupted& interrupted = never);

}  // namespace dumbbell::starts
