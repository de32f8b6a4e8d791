#pragma once

#include <functional>

namespace dumbbell::api {

/// work(), on this thread if it has the stack for it, else on one of its own, at whose end `at_end` is
/// called. Throws what `work` throws, and std::system_error if there can be no such thread.
void with_stack(const std::function<void()>& work, void (*at_end)());

}  // namespace dumbbell::api
