#include "certificate/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "arith/error.hpp"

namespace dumbbell {
namespace {

/// One gzip member without time or name, so that the bytes depend on nothing but the contents.
std::string gzipped(const std::string& contents) {
    z_stream stream{};
    require(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) == Z_OK,
            "zlib failed");
    std::string result(deflateBound(&stream, static_cast<uLong>(contents.size())) + 32, '\0');
    std::string input = contents;
    stream.next_in = reinterpret_cast<Bytef*>(input.data());
    stream.avail_in = static_cast<uInt>(input.size());
    stream.next_out = reinterpret_cast<Bytef*>(result.data());
    stream.avail_out = static_cast<uInt>(result.size());
    const int status = deflate(&stream, Z_FINISH);
    result.resize(stream.total_out);
    deflateEnd(&stream);
    require(status == Z_STREAM_END, "zlib failed");
    return result;
}

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)) {
    // A rename would replace whatever stands there, a device like /dev/null too.
    std::error_code unreadable;
    const auto target = std::filesystem::status(path_, unreadable);
    if (std::filesystem::is_directory(target)) {
        throw InputError(fmt::format("cannot write '{}': it is a directory; give a file name", path_));
    }
    if (std::filesystem::exists(target) && !std::filesystem::is_regular_file(target)) {
        throw InputError(fmt::format("cannot write '{}': it is no regular file; give a file name", path_));
    }
    temporary_ = fmt::format("{}.tmp-{}", path_, ::getpid());
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
        temporary_.clear();
        fail("create");
    }
}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
    if (!temporary_.empty()) {
        ::unlink(temporary_.c_str());
    }
}

void AtomicFile::fail(const char* doing) const {
    throw InputError(
        fmt::format("cannot {} '{}': {}; nothing is left under that name that was not there before", doing,
                    path_, std::strerror(errno)));
}

void AtomicFile::commit(const std::string& contents) {
    const bool compress = path_.ends_with(".gz");
    const std::string packed = compress ? gzipped(contents) : std::string();
    const std::string& bytes = compress ? packed : contents;
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t n = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            fail("write");
        }
        done += static_cast<std::size_t>(n);
    }
    if (::fsync(descriptor_) != 0) {
        fail("sync");
    }
    if (::close(std::exchange(descriptor_, -1)) != 0) {
        fail("close");
    }
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) {
        fail("rename to");
    }
    temporary_.clear();
    // The new name is durable once its directory is synced; if that cannot be done the file is still
    // complete.
    const auto parent = std::filesystem::path(path_).parent_path();
    const int directory = ::open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (directory >= 0) {
        ::fsync(directory);
        ::close(directory);
    }
}

}  // namespace dumbbell
