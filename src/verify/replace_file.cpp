#include "replace_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace dumbbell_verify {
namespace {

std::string temporary_name(const std::string& path) { return path + ".tmp-" + std::to_string(::getpid()); }

[[noreturn]] void cannot_write(const std::string& path, const std::string& why) {
    throw std::invalid_argument("cannot write " + path + ": " + why);
}

int create(const std::string& path) {
    struct stat there {};
    if (::stat(path.c_str(), &there) == 0 && !S_ISREG(there.st_mode))
        cannot_write(path, "it is no regular file; give a file name");
    const int file = ::open(temporary_name(path).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) cannot_write(path, std::strerror(errno));
    return file;
}

/// 0, or the error.
int write_all(int file, const std::string& text) {
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t n = ::write(file, text.data() + done, text.size() - done);
        if (n > 0) done += static_cast<std::size_t>(n);
        if (n == 0) return EIO;
        if (n < 0 && errno != EINTR) return errno;
    }
    return ::fsync(file) == 0 ? 0 : errno;
}

}  // namespace

void require_replaceable(const std::string& path) {
    ::close(create(path));
    ::unlink(temporary_name(path).c_str());
}

void replace_file(const std::string& path, const std::string& text) {
    const int file = create(path);
    const std::string temporary = temporary_name(path);
    int error = write_all(file, text);
    if (::close(file) != 0 && error == 0) error = errno;
    if (error == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
    if (error == 0) return;
    ::unlink(temporary.c_str());
    cannot_write(path, std::strerror(error));
}

}  // namespace dumbbell_verify
