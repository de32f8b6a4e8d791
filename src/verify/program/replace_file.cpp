#include "verify/program/replace_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace dumbbell_verify {
namespace {

std::string temporary_name(const std::string& path) { return path + ".tmp-" + std::to_string(::getpid()); }

[[noreturn]] void cannot_write(const std::string& path, const std::string& why) {
    throw std::invalid_argument("cannot write " + path + ": " + why);
}

/// Where links lead, which stay; their end need not be there. Below /dev and /proc there are no files.
std::string target_of(const std::string& path) {
    std::filesystem::path target = path;
    std::error_code failed;
    for (int links = 0; links < 40; ++links) {
        const std::string folder =
            std::filesystem::weakly_canonical(std::filesystem::absolute(target).parent_path(), failed)
                .string() +
            "/";
        if (folder.starts_with("/proc/") || (folder.starts_with("/dev/") && !folder.starts_with("/dev/shm/")))
            cannot_write(path, "what lies below " + folder + " is not a file");
        const std::filesystem::path link = std::filesystem::read_symlink(target, failed);
        if (failed) return target.string();
        target = target.parent_path() / link;
    }
    cannot_write(path, "its links lead in a circle");
}

int create(const std::string& path, const std::string& target) {
    struct stat there {};
    const bool replaces = ::stat(target.c_str(), &there) == 0;
    if (replaces && !S_ISREG(there.st_mode)) cannot_write(path, "it is not a regular file; give a file name");
    if (replaces && (there.st_mode & 0222U) == 0)
        cannot_write(path, "it is read-only; give another name, or make it writable");
    const std::string temporary = temporary_name(target);
    ::unlink(temporary.c_str());  // a killed program of the same number may have left it
    const int file =
        ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, replaces ? 0600 : 0666);
    if (file < 0) cannot_write(path, std::strerror(errno));
    if (replaces) {
        (void)!::fchown(file, there.st_uid, there.st_gid);  // as far as this program may
        (void)!::fchmod(file, there.st_mode & 0777U);
    }
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

/// What the program reads under this name; `-` is the standard input.
bool is_there(const std::string& input, struct stat& found) {
    return (input == "-" ? ::fstat(STDIN_FILENO, &found) : ::stat(input.c_str(), &found)) == 0;
}

}  // namespace

void require_replaceable(const std::string& path, const std::vector<std::string>& inputs) {
    const std::string target = target_of(path);
    struct stat out {};
    struct stat in {};
    for (const std::string& input : inputs)
        if (::stat(target.c_str(), &out) == 0 && is_there(input, in) && out.st_dev == in.st_dev &&
            out.st_ino == in.st_ino)
            cannot_write(path, "it is " + (input == "-" ? "the standard input" : input) + ", which is read");
    ::close(create(path, target));
    ::unlink(temporary_name(target).c_str());
}

void replace_file(const std::string& path, const std::string& text) {
    const std::string target = target_of(path), temporary = temporary_name(target);
    const int file = create(path, target);
    int error = write_all(file, text);
    if (::close(file) != 0 && error == 0) error = errno;
    if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
    if (error == 0) return;
    ::unlink(temporary.c_str());
    cannot_write(path, std::strerror(error));
}

}  // namespace dumbbell_verify
