#pragma once

#include <cstddef>

namespace dumbbell::starts {

/// What enclosures that decide nothing are on or near to: they do not exclude the event, or hardly.
enum class Obstacle {
    flat,             ///< a flat fall: both masses at once, the rod not turning
    corner,           ///< both masses at once
    graze,            ///< a contact that is tangential
    corner_or_graze,  ///< each of the two
    other             ///< neither
};
inline constexpr std::size_t obstacles = 5;

}  // namespace dumbbell::starts
