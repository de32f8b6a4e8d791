#include "file/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "base/error.hpp"

namespace dumbbell {
namespace {

Descriptor opened(const std::string& folder) {
    return Descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
}

[[noreturn]] void cannot_take(const char* doing, const std::string& folder) {
    throw InputError(fmt::format("cannot {} the folder '{}': {}", doing, folder, std::strerror(errno)));
}

}  // namespace

bool FolderLock::take(const std::string& folder) {
    folder_ = opened(folder);
    if (folder_.get() < 0) {
        cannot_take("open", folder);
    }
    // A program that asks whether it is taken has it for a moment.
    for (int tries = 0; tries < 10; ++tries) {
        if (::flock(folder_.get(), LOCK_EX | LOCK_NB) == 0) {
            return true;
        }
        if (errno != EWOULDBLOCK) {
            cannot_take("lock", folder);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
}

bool FolderLock::is_taken(const std::string& folder) {
    const Descriptor descriptor = opened(folder);
    return descriptor.get() >= 0 && ::flock(descriptor.get(), LOCK_SH | LOCK_NB) != 0;
}

}  // namespace dumbbell
