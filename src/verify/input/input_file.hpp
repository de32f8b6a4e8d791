// A file to read, byte by byte as it comes.
#pragma once
#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace dumbbell_verify {

/// A text in memory, which is read as a file is.
struct Memory {
    std::string_view text;
};

/// `-` is the standard input. What is wrong is thrown as std::invalid_argument.
class InputFile {
  public:
    /// A pipe with a name is refused: if nobody writes to it, a reader would wait for ever.
    explicit InputFile(const std::string& path)
        : file_(path == "-" ? ::dup(STDIN_FILENO) : ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
        if (file_ < 0) throw std::invalid_argument(std::strerror(errno));
        struct stat what {};
        const bool unnamed = path == "-" || path.starts_with("/dev/") || path.starts_with("/proc/");
        if (!unnamed && ::fstat(file_, &what) == 0 && S_ISFIFO(what.st_mode)) {
            ::close(file_);
            throw std::invalid_argument("a named pipe: give `-` and let the shell redirect it");
        }
    }
    explicit InputFile(Memory memory) : file_(-1), memory_(memory.text) {}
    ~InputFile() {
        if (file_ >= 0) ::close(file_);
    }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    /// How many bytes there are now, at most as many as fit; waits for the first. 0: the end.
    std::size_t read(std::span<char> into) {
        if (file_ < 0) {
            const std::size_t size = memory_.copy(into.data(), into.size());
            memory_.remove_prefix(size);
            return size;
        }
        for (;;) {
            const ssize_t n = ::read(file_, into.data(), into.size());
            if (n >= 0) return static_cast<std::size_t>(n);
            if (errno == EAGAIN || errno == EWOULDBLOCK) {  // a neighbour has made it so: it stays so
                pollfd more{file_, POLLIN, 0};
                ::poll(&more, 1, -1);
            } else if (errno != EINTR)
                throw std::invalid_argument(std::strerror(errno));
        }
    }

  private:
    const int file_;           ///< -1: none
    std::string_view memory_;  ///< what is left of it
};

}  // namespace dumbbell_verify
