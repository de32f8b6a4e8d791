#pragma once

#include "base/deadline.hpp"
#include "dumbbell/stopped.hpp"

namespace dumbbell::api {

/// While it lives, work that begins on this thread ends early when the caller says so.
class CallerStops {
  public:
    explicit CallerStops(const Stopped& stopped) { caller_stops = stopped ? &stopped : nullptr; }
    ~CallerStops() { caller_stops = nullptr; }
    CallerStops(const CallerStops&) = delete;
    CallerStops& operator=(const CallerStops&) = delete;
};

}  // namespace dumbbell::api
