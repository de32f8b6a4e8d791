// The bytes of a file, unpacked if it is compressed. Memory does not grow with the file.
#pragma once
#include <zlib.h>

#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/core/text.hpp"
#include "verify/input/foreign.hpp"
#include "verify/input/input_file.hpp"

namespace dumbbell_verify {

/// Throws std::bad_alloc if there was not enough.
inline void need_memory(bool enough) {
    if (!enough) throw std::bad_alloc();
}

/// Blocks of bytes, one after the other. At most one gzip member, and nothing after it.
class Bytes : public Source {
  public:
    /// Of a path, or of Memory. Throws Failure if the file cannot be read, here and below.
    template <class From>
    explicit Bytes(const From& from) try : file_(from) {
        first_ = read();
        if (first_ == "\x1f")
            first_ = {raw_.data(), 1 + file_.read(std::span(raw_).subspan(1))};  // of a pipe
        gzip_ = first_.starts_with("\x1f\x8b");
        if (!gzip_) return;
        feed(std::exchange(first_, {}));
        need_memory(inflateInit2(&stream_, 15 + 16) == Z_OK);
    } catch (const std::invalid_argument& why) {
        throw Failure{Verdict::unreadable, 0, "unreadable", why.what()};
    }
    ~Bytes() override { inflateEnd(&stream_); }

    std::string_view next(std::uint64_t line) override {
        const std::string_view block = unpacked(line);
        Watched::bytes += block.size();
        return block;
    }
    [[nodiscard]] std::string foreign(std::string_view line, bool is_first) const override {
        return foreign_text(line, is_first);
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
    std::string_view read() try {
        return {raw_.data(), file_.read(raw_)};
    } catch (const std::invalid_argument& why) {
        throw Failure{Verdict::unreadable, 0, "unreadable", why.what()};
    }
    void feed(std::string_view bytes) {
        stream_.next_in = reinterpret_cast<Bytef*>(raw_.data());
        stream_.avail_in = static_cast<uInt>(bytes.size());
    }

    InputFile file_;
    z_stream stream_{};
    bool gzip_ = false, ended_ = false;
    std::vector<char> raw_ = std::vector<char>(1 << 16), block_ = raw_;  ///< not on the stack
    std::string_view first_;  ///< of a plain file: what was read to see that it is one
};

}  // namespace dumbbell_verify
