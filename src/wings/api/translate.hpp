#pragma once

#include <new>
#include <optional>
#include <system_error>
#include <type_traits>
#include <utility>

#include "api/stack.hpp"
#include "api/without_dashes.hpp"
#include "base/error.hpp"
#include "dumbbell/error.hpp"
#include "number/flint.hpp"
#include "number/sound_arithmetic.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

/// f(), which gives a result, with the exceptions of the public headers and no other ones, with stack enough,
/// and with sound arithmetic whatever the caller made of it.
template <class F>
std::invoke_result_t<const F&> guarded(const F& f) {
    std::optional<std::invoke_result_t<const F&>> result;
    try {
        with_stack(
            [&] {
                const SoundArithmetic sound;
                result.emplace(f());
            },
            flint_cleanup);
    } catch (const dumbbell::InputError& error) {
        throw InputError(without_dashes(error.what()));
    } catch (const std::bad_alloc&) {
        throw ResourceError("out of memory");
    } catch (const std::system_error& error) {
        throw ResourceError(error.what());
    } catch (const std::exception& error) {
        throw BrokenInvariant(error.what());
    }
    return std::move(*result);
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
