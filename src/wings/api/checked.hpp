#pragma once

#include <string>

#include "base/error.hpp"

namespace dumbbell::api {

/// A caller's number of this name. Throws InputError.
template <class Whole>
Whole checked(const char* name, Whole number, Whole least, Whole most) {
    if (number < least || number > most) {
        throw dumbbell::InputError(std::string(name) + " is out of range: give " + std::to_string(least) +
                                   " to " + std::to_string(most));
    }
    return number;
}

inline int checked_jobs(int jobs) { return checked("jobs", jobs, 1, 1024); }

}  // namespace dumbbell::api
