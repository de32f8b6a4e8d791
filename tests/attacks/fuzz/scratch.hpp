// Files for functions that want a path.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
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

/// A folder for scratch files, removed at the end of the program.
class ScratchFolder {
  public:
    ScratchFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "dumbbell-fuzz-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw std::system_error(errno, std::generic_category(), "a scratch folder");
        path_ = name;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace dumbbell_fuzz
