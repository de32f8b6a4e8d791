#pragma once

#include <functional>

#include "dumbbell/abi.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

/// What work that may take long asks now and then, from any of its threads: whether to end early. What is not
/// decided by then is undecided, never wrong. It must not throw. Empty: never.
using Stopped = std::function<bool()>;

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
