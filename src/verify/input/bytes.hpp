// The bytes of a file, unpacked if it is compressed. Memory does not grow with the file.
#pragma once
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/input/budget.hpp"

namespace dumbbell_verify {

/// A file to read; `-` is the standard input. A pipe with a name is refused: if nobody writes to it, a reader
/// would wait for ever. nullptr: `why` says what is wrong.
inline std::FILE* open_file(const std::string& path, std::string& why) {
    const int file =
        path == "-" ? ::dup(STDIN_FILENO) : ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    struct stat what {};
    const bool unnamed = path == "-" || path.starts_with("/dev/") || path.starts_with("/proc/");
    if (!unnamed && file >= 0 && ::fstat(file, &what) == 0 && S_ISFIFO(what.st_mode)) {
        why = "a named pipe: give `-` and let the shell redirect it";
        ::close(file);
        return nullptr;
    }
    if (file >= 0 && path != "-") ::fcntl(file, F_SETFL, 0);  // from now on it may wait
    std::FILE* stream = file < 0 ? nullptr : ::fdopen(file, "rb");
    if (!stream) why = std::strerror(errno);
    return stream;
}

/// Throws std::bad_alloc if there was not enough.
inline void need_memory(bool enough) {
    if (!enough) throw std::bad_alloc();
}

/// Blocks of bytes, one after the other. At most one gzip member, and nothing after it.
class Bytes {
  public:
    /// Throws Failure if the file cannot be read, here and below.
    explicit Bytes(const std::string& path) : file_(nullptr, std::fclose) {
        std::string why;
        file_.reset(open_file(path, why));
        if (!file_) throw Failure{Verdict::unreadable, 0, "unreadable", why};
        first_ = read();
        gzip_ = first_.starts_with("\x1f\x8b");
        if (!gzip_) return;
        feed(std::exchange(first_, {}));
        need_memory(inflateInit2(&stream_, 15 + 16) == Z_OK);
    }
    ~Bytes() { inflateEnd(&stream_); }
    Bytes(const Bytes&) = delete;
    Bytes& operator=(const Bytes&) = delete;

    /// The next block, good until the one after it; empty at the end. What is wrong is said to be in this
    /// line.
    std::string_view next(std::uint64_t line) {
        const std::string_view block = unpacked(line);
        Watched::bytes += block.size();
        return block;
    }

  private:
    std::string_view unpacked(std::uint64_t line) {
        if (!gzip_) return first_.empty() ? read() : std::exchange(first_, {});
        stream_.next_out = reinterpret_cast<Bytef*>(block_.data());
        stream_.avail_out = static_cast<uInt>(block_.size());
        while (!ended_ && stream_.avail_out == block_.size()) {
            if (stream_.avail_in == 0) feed(read());
            if (stream_.avail_in == 0) reject(line, "the compressed file is truncated");
            const int state = inflate(&stream_, Z_NO_FLUSH);
            need_memory(state != Z_MEM_ERROR);
            if (state != Z_OK && state != Z_STREAM_END) reject(line, "the compressed file is damaged");
            ended_ = state == Z_STREAM_END;
            if (ended_ && (stream_.avail_in > 0 || !read().empty()))
                reject(line, "bytes after the gzip member");
        }
        return {block_.data(), block_.size() - stream_.avail_out};
    }
    [[noreturn]] static void reject(std::uint64_t line, const char* text) {
        throw Failure{Verdict::rejected, line, "gzip", text};
    }
    std::string_view read() {
        const std::size_t n = std::fread(raw_.data(), 1, raw_.size(), file_.get());
        if (std::ferror(file_.get()) != 0)
            throw Failure{Verdict::unreadable, 0, "unreadable", std::strerror(errno)};
        return {raw_.data(), n};
    }
    void feed(std::string_view bytes) {
        stream_.next_in = reinterpret_cast<Bytef*>(raw_.data());
        stream_.avail_in = static_cast<uInt>(bytes.size());
    }

    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    z_stream stream_{};
    bool gzip_ = false, ended_ = false;
    std::vector<char> raw_ = std::vector<char>(1 << 16), block_ = raw_;  ///< not on the stack
    std::string_view first_;  ///< of a plain file: what was read to see that it is one
};

}  // namespace dumbbell_verify
