#pragma once

#include <stdexcept>

namespace dumbbell::api {

/// An argument cannot be taken; the message is one line that says what to do.
class [[gnu::visibility("default")]] InputError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Something that must always hold does not: a defect, or a thread whose arithmetic is not sound (another
/// rounding mode, flush to zero). No result is given then.
class [[gnu::visibility("default")]] BrokenInvariant : public std::logic_error {
    using std::logic_error::logic_error;
};

}  // namespace dumbbell::api
