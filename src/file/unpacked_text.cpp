#include "file/unpacked_text.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <new>

#include "base/error.hpp"

namespace dumbbell {
namespace {

constexpr std::size_t block_size = 1 << 16;
constexpr int gzip_only = 16 + MAX_WBITS;  // for inflateInit2

}  // namespace

UnpackedText::UnpackedText(const NamedFile& file) : file_(file), read_(block_size) {
    const std::string_view first = file_.next(read_);
    if (!first.starts_with("\x1f\x8b")) {
        rest_ = first;
        return;
    }
    unpacked_.resize(block_size);
    stream_.reset(new z_stream_s{});
    if (inflateInit2(stream_.get(), gzip_only) != Z_OK) {
        throw std::bad_alloc();
    }
    feed(first);
}

void UnpackedText::End::operator()(z_stream_s* stream) const {
    inflateEnd(stream);
    delete stream;
}

std::string_view UnpackedText::next_line() {
    line_.clear();
    while (line_.size() < longest_line && !line_.ends_with('\n')) {
        if (rest_.empty()) {
            rest_ = next_block();
        }
        if (rest_.empty()) {
            break;
        }
        const std::string_view most = rest_.substr(0, longest_line - line_.size());
        const std::string_view part = most.substr(0, std::min(most.find('\n'), most.size() - 1) + 1);
        line_ += part;
        rest_.remove_prefix(part.size());
    }
    return line_;
}

/// Empty at the end.
std::string_view UnpackedText::next_block() {
    if (!stream_) {
        return file_.next(read_);
    }
    stream_->next_out = reinterpret_cast<Bytef*>(unpacked_.data());
    stream_->avail_out = static_cast<uInt>(block_size);
    while (!ended_ && stream_->avail_out == block_size) {
        if (stream_->avail_in == 0) {
            feed(file_.next(read_));
        }
        if (stream_->avail_in == 0) {
            damaged("the compressed file is truncated");
        }
        const int state = inflate(stream_.get(), Z_NO_FLUSH);
        if (state == Z_MEM_ERROR) {
            throw std::bad_alloc();
        }
        if (state != Z_OK && state != Z_STREAM_END) {
            damaged("it cannot be unpacked");
        }
        ended_ = state == Z_STREAM_END;
        if (ended_ && (stream_->avail_in > 0 || !file_.next(read_).empty())) {
            damaged("bytes after the gzip member");
        }
    }
    return {unpacked_.data(), block_size - stream_->avail_out};
}

void UnpackedText::feed(std::string_view packed) {
    stream_->next_in = reinterpret_cast<Bytef*>(read_.data());
    stream_->avail_in = static_cast<uInt>(packed.size());
}

void UnpackedText::damaged(std::string_view how) const {
    throw InputError(fmt::format("'{}' is damaged: {}", file_.path(), how));
}

}  // namespace dumbbell
