#pragma once

#include "base/error.hpp"
#include "dumbbell/error.hpp"
#include "number/self_test.hpp"

namespace dumbbell::api {

/// f(), with the exceptions of the public headers, on a thread whose arithmetic is sound.
template <class F>
auto guarded(const F& f) {
    try {
        require_sound_arithmetic();
        return f();
    } catch (const dumbbell::InputError& error) {
        throw InputError(error.what());
    } catch (const dumbbell::BrokenInvariant& error) {
        throw BrokenInvariant(error.what());
    }
}

}  // namespace dumbbell::api
