#include "file/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>

#include <cerrno>
#include <cstring>

#include "base/error.hpp"

namespace dumbbell {
namespace {

[[noreturn]] void cannot_take(const char* doing, const std::string& folder) {
    throw InputError(fmt::format("cannot {} the folder '{}': {}", doing, folder, std::strerror(errno)));
}

}  // namespace

bool FolderLock::take(const std::string& folder) {
    folder_ = Descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder_.get() < 0) {
        cannot_take("open", folder);
    }
    if (::flock(folder_.get(), LOCK_EX | LOCK_NB) == 0) {
        return true;
    }
    if (errno != EWOULDBLOCK) {
        cannot_take("lock", folder);
    }
    return false;
}

}  // namespace dumbbell
