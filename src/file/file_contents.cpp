#include "file/file_contents.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace dumbbell {

FileToRead::FileToRead(std::string path) : path_(std::move(path)) {
    struct stat what {};
    // Before it is opened: who opens a named pipe waits for somebody who writes to it.
    if (::stat(path_.c_str(), &what) != 0) {
        fail(errno == ENOENT ? "no such file" : std::strerror(errno));
    }
    if (!S_ISREG(what.st_mode)) {
        fail(S_ISDIR(what.st_mode) ? "it is a directory" : "not a regular file");
    }
    file_ = Descriptor(::open(path_.c_str(), O_RDONLY | O_CLOEXEC));
    if (file_.get() < 0) {
        fail(std::strerror(errno));
    }
}

std::string_view FileToRead::next(std::span<char> room) {
    ssize_t n = -1;
    do {
        n = ::read(file_.get(), room.data(), room.size());
    } while (n < 0 && errno == EINTR);
    if (n < 0) {
        fail(std::strerror(errno));
    }
    return {room.data(), static_cast<std::size_t>(n)};
}

void FileToRead::fail(std::string_view why) const {
    throw InputError(fmt::format("cannot read '{}': {}", path_, why));
}

std::string file_contents(const std::string& path) {
    FileToRead file(path);
    std::vector<char> room(1 << 16);
    std::string all;
    for (std::string_view part = file.next(room); !part.empty(); part = file.next(room)) {
        all += part;
    }
    return all;
}

}  // namespace dumbbell
