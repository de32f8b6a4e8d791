// A file for functions that want a path.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace dumbbell_fuzz {

/// A file that exists in memory only.
class MemoryFile {
  public:
    MemoryFile() : descriptor_(::memfd_create("input", MFD_CLOEXEC)) { need(descriptor_ >= 0); }
    ~MemoryFile() { ::close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    /// The path of a file with these bytes and no others; until the next call.
    const std::string& holding(const std::string& bytes) {
        need(::ftruncate(descriptor_, 0) == 0);
        for (std::size_t done = 0; done < bytes.size();) {
            const ssize_t n =
                ::pwrite(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
            need(n > 0);
            done += static_cast<std::size_t>(n);
        }
        return path_;
    }

  private:
    static void need(bool done) {
        if (!done) throw std::system_error(errno, std::generic_category(), "a file in memory");
    }

    int descriptor_;
    std::string path_ = "/proc/self/fd/" + std::to_string(descriptor_);
};

}  // namespace dumbbell_fuzz
