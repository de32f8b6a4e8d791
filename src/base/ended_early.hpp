#pragma once

#include "base/interrupted.hpp"

namespace dumbbell {

/// Thrown by work that is interrupted where it has nothing to give back.
struct EndedEarly {};

inline void go_on(const Interrupted& interrupted) {
    if (interrupted()) {
        throw EndedEarly();
    }
}

}  // namespace dumbbell
