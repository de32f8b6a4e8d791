#pragma once

#if defined(__linux__)
#include <sys/mman.h>
#else
#include <cstdlib>
#include <filesystem>
#endif
#include <unistd.h>

#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>

namespace dumbbell::api {

/// A text as a file that nobody else sees, in memory on Linux, for what reads files by their name.
class MemoryFile {
  public:
    /// Throws std::system_error if there is no memory for it, or no descriptor.
    explicit MemoryFile(std::string_view text) : file_(opened()) {
        // Elsewhere than on Linux who opens it shares the place.
        if (file_ < 0 || !holds(text) || ::lseek(file_, 0, SEEK_SET) != 0) {
            const int error = errno;
            ::close(file_);
            throw std::system_error(error, std::generic_category(), "a text as a file in memory");
        }
    }
    ~MemoryFile() { ::close(file_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] std::string path() const { return "/dev/fd/" + std::to_string(file_); }

  private:
    static int opened() {
#if defined(__linux__)
        return ::memfd_create("certificate", MFD_CLOEXEC);
#else
        std::string name = (std::filesystem::temp_directory_path() / "dumbbell-XXXXXX").string();
        const int file = ::mkstemp(name.data());
        ::unlink(name.c_str());
        return file;
#endif
    }

    /// Puts the text into it.
    [[nodiscard]] bool holds(std::string_view text) const {
        while (!text.empty()) {
            const ssize_t written = ::write(file_, text.data(), text.size());
            if (written < 0 && errno != EINTR) {
                return false;
            }
            text.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
        }
        return true;
    }

    int file_;
};

}  // namespace dumbbell::api
