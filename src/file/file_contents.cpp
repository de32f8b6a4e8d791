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

FileToRead::FileToRead(NamedFile file) : named_(std::move(file)) {
    if (named_.contents) {
        return;
    }
    struct stat what {};
    // Before it is opened: who opens a named pipe waits for somebody who writes to it.
    if (::stat(path().c_str(), &what) != 0) {
        fail(errno == ENOENT ? "no such file" : std::strerror(errno));
    }
    if (!S_ISREG(what.st_mode)) {
        fail(S_ISDIR(what.st_mode) ? "it is a directory" : "not a regular file");
    }
    file_ = Descriptor(::open(path().c_str(), O_RDONLY | O_CLOEXEC));
    if (file_.get() < 0) {
        fail(std::strerror(errno));
    }
}

std::string_view FileToRead::next(std::span<char> room) {
    if (named_.contents) {
        const std::size_t n = named_.contents->copy(room.data(), room.size());
        named_.contents->remove_prefix(n);
        return {room.data(), n};
    }
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
    throw InputError(fmt::format("cannot read '{}': {}", path(), why));
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
