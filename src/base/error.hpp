#pragma once

#include <stdexcept>

namespace dumbbell {

/// The user's input cannot be taken; the message says what to do. Exit code 2.
class InputError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Something that must always hold does not: a defect or an unsound machine. Exit code 1.
class BrokenInvariant : public std::logic_error {
    using std::logic_error::logic_error;
};

/// Throws BrokenInvariant with `what` unless `holds`. Always on, in every build.
inline void require(bool holds, const char* what) {
    if (!holds) {
        throw BrokenInvariant(what);
    }
}

}  // namespace dumbbell
