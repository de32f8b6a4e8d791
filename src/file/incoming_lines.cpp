#include "file/incoming_lines.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/error.hpp"

namespace dumbbell {

IncomingLines::IncomingLines(std::string path) : path_(std::move(path)), block_(1 << 16) {
    if (path_ == "-") {
        return;
    }
    // Not to wait here for somebody who writes to a named pipe.
    file_ = Descriptor(::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat what {};
    if (file_.get() < 0 || ::fstat(file_.get(), &what) != 0) {
        fail(errno == ENOENT ? "no such file" : std::strerror(errno));
    }
    if (S_ISDIR(what.st_mode)) {
        fail("it is a directory");
    }
}

std::optional<std::string> IncomingLines::next(const Interrupted& interrupted) {
    std::string line;
    bool begun = false;
    for (bool whole = false; !whole;) {
        if (rest_.empty()) {
            fill(interrupted);
        }
        if (rest_.empty() && !ended_) {
            return std::nullopt;
        }
        if (rest_.empty()) {
            break;
        }
        begun = true;
        const std::size_t end = rest_.find('\n');
        whole = end != std::string_view::npos;
        line += rest_.substr(0, std::min(end, longest_line - line.size()));
        rest_.remove_prefix(whole ? end + 1 : rest_.size());
    }
    if (!begun) {
        return std::nullopt;
    }
    if (line.ends_with('\r')) {
        line.pop_back();
    }
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (++number_ == 1 && line.starts_with(byte_order_mark)) {
        line.erase(0, byte_order_mark.size());
    }
    return line;
}

void IncomingLines::fill(const Interrupted& interrupted) {
    constexpr int between_questions = 100;  // milliseconds
    const int descriptor = path_ == "-" ? STDIN_FILENO : file_.get();
    while (!ended_ && rest_.empty()) {
        pollfd more{descriptor, POLLIN, 0};
        const int ready = ::poll(&more, 1, between_questions);
        if (interrupted()) {
            return;
        }
        if (ready > 0) {
            const ssize_t n = ::read(descriptor, block_.data(), block_.size());
            if (n < 0 && errno != EINTR && errno != EAGAIN) {
                fail(std::strerror(errno));
            }
            ended_ = n == 0;
            rest_ = {block_.data(), static_cast<std::size_t>(std::max<ssize_t>(n, 0))};
        }
    }
}

void IncomingLines::fail(std::string_view why) const {
    throw InputError(path_ == "-" ? fmt::format("cannot read the standard input: {}", why)
                                  : fmt::format("cannot read '{}': {}", path_, why));
}

}  // namespace dumbbell
