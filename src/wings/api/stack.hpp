#pragma once

#include <functional>

namespace dumbbell::api {

/// work(), on this thread if it has the stack for it, else on one of its own. When that thread ends `at_end`
/// gives back what the work keeps for a thread. Throws what `work` throws, and std::system_error if there can
/// be no such thread.
void with_stack(const std::function<void()>& work, void (*at_end)());

}  // namespace dumbbell::api
