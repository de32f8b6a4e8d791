#pragma once

#include "base/error.hpp"

namespace dumbbell::api {

/// A caller's number of threads. Throws InputError.
inline int checked_jobs(int jobs) {
    if (jobs < 1 || jobs > 1024) {
        throw dumbbell::InputError("jobs is out of range: give a number of threads from 1 to 1024");
    }
    return jobs;
}

}  // namespace dumbbell::api
