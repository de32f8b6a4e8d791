#include "campaign/password.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "base/error.hpp"
#include "base/hexadecimal.hpp"
#include "file/atomic_file.hpp"
#include "file/descriptor.hpp"

namespace dumbbell::campaign {
namespace {

constexpr std::size_t least_characters = 16;
constexpr std::size_t most_characters = 256;

[[noreturn]] void fail(const char* doing, const std::string& file) {
    throw InputError(fmt::format("cannot {} '{}': {}", doing, file, std::strerror(errno)));
}

/// Gives `file` a secret, all of it at once, unless something of that name is there.
void make(const std::string& file) {
    const std::string temporary = temporary_name(file);
    ::unlink(temporary.c_str());  // a killed program may have left one
    const Descriptor made(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
    if (made.get() < 0) {
        fail("create", file);
    }
    const std::string line = random_digits() + '\n';
    const bool written = ::write(made.get(), line.data(), line.size()) == static_cast<ssize_t>(line.size()) &&
                         ::fsync(made.get()) == 0;
    // Of the open file, not of its name: another program may have made that its own meanwhile.
    const std::string itself = fmt::format("/proc/self/fd/{}", made.get());
    const bool named =
        written && (::linkat(AT_FDCWD, itself.c_str(), AT_FDCWD, file.c_str(), AT_SYMLINK_FOLLOW) == 0 ||
                    errno == EEXIST);
    const int cause = errno;
    ::unlink(temporary.c_str());
    if (!named) {
        errno = cause;
        fail("create", file);
    }
}

}  // namespace

std::string random_digits() {
    std::array<unsigned char, 32> bytes{};
    require(::getentropy(bytes.data(), bytes.size()) == 0, "no random numbers");
    return hexadecimal(bytes.data(), bytes.size());
}

std::string password_file(const std::string& folder) {
    std::string file = folder + "/password";
    struct stat there {};
    if (::lstat(file.c_str(), &there) != 0) {
        if (errno != ENOENT) {
            fail("read", file);
        }
        make(file);
    }
    (void)read_password(file);
    return file;
}

std::string read_password(const std::string& file) {
    const Descriptor opened(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    struct stat status {};
    if (opened.get() < 0 || ::fstat(opened.get(), &status) != 0) {
        fail("read", file);
    }
    if (!S_ISREG(status.st_mode)) {
        throw InputError(
            fmt::format("'{}' is not a regular file: give the file that holds the password", file));
    }
    if ((status.st_mode & 077) != 0) {
        throw InputError(fmt::format(
            "others than its owner have access to '{}': type  chmod 600 '{}'  (or remove it, for a "
            "new password, if one of them may have read it)",
            file, file));
    }
    std::array<char, most_characters + 2> buffer{};  // room for its newline, and to see that it is longer
    const ssize_t size = ::read(opened.get(), buffer.data(), buffer.size());
    if (size < 0) {
        fail("read", file);
    }
    std::string line(buffer.data(), static_cast<std::size_t>(size));
    const std::size_t characters = line.size() - (line.ends_with('\n') ? 1 : 0);
    if (characters < least_characters || characters > most_characters ||
        !std::all_of(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(characters),
                     [](char c) { return c >= ' ' && c <= '~'; })) {
        throw InputError(fmt::format(
            "'{}' holds no password (one line of {} to {} printable characters): remove it, and a "
            "new one is made",
            file, least_characters, most_characters));
    }
    return line;
}

}  // namespace dumbbell::campaign
