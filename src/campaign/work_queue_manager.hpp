#pragma once

#include <memory>
#include <string>

struct work_queue;  // of the library, see work_queue_api.hpp

namespace dumbbell::campaign {

struct WorkQueueDeleter {
    void operator()(work_queue* queue) const;
};
using WorkQueueManager = std::unique_ptr<work_queue, WorkQueueDeleter>;

/// A manager that listens on this numeric address (IPv4 or IPv6) and port (0: any free one from 1024 to
/// 32767), and lets nobody in without the password. Silent, except when it dies of a lack of memory. Throws
/// InputError (saying what to do) if it cannot listen there.
///
/// It departs from the library in two ways. The library listens on all addresses. And its password check can
/// be passed without the password: it answers its peer's challenge before the peer has answered its own, so
/// the peer sends back the manager's challenge and then the manager's answer. Here the manager answers last.
///
/// The library sets a handler of SIGPIPE that does nothing, when the first worker comes: from then on writing
/// to a closed pipe fails instead of ending the program.
[[nodiscard]] WorkQueueManager make_work_queue_manager(const std::string& address, int port,
                                                       const std::string& password);

}  // namespace dumbbell::campaign
