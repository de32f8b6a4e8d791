#pragma once

#include <stdexcept>

#include "dumbbell/abi.hpp"

/// All that functions of dumbbell::prove throw. Those of dumbbell::verify throw std::invalid_argument alone.
namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

/// An argument cannot be taken; the message is one line that says what to do.
class [[gnu::visibility("default")]] InputError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// There is not enough memory, or the calling thread has too little stack (docs/library) and no other one may
/// start.
class [[gnu::visibility("default")]] ResourceError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Something that must always hold does not: a defect, or a machine whose arithmetic is not sound. No result
/// is given then.
class [[gnu::visibility("default")]] BrokenInvariant : public std::logic_error {
    using std::logic_error::logic_error;
};

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
