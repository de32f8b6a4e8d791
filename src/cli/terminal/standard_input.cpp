#include "cli/terminal/standard_input.hpp"

#include <fmt/core.h>
#include <poll.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "file/descriptor.hpp"

namespace dumbbell::cli {
namespace {

constexpr std::string_view kept_file = "/dev/stdin";
bool is_kept = false;

[[noreturn]] void fail() {
    throw InputError(fmt::format("cannot read the standard input: {}", std::strerror(errno)));
}

/// Puts all that the standard input still has in its place.
void keep() {
    const Descriptor memory(::memfd_create("stdin", MFD_CLOEXEC));
    if (memory.get() < 0) {
        fail();
    }
    std::vector<char> block(1 << 16);
    for (;;) {
        const ssize_t n = ::read(STDIN_FILENO, block.data(), block.size());
        if (n == 0) {
            break;
        }
        if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {  // a neighbour has made it so: it stays so
            pollfd more{STDIN_FILENO, POLLIN, 0};
            ::poll(&more, 1, -1);
        } else if (n < 0 && errno != EINTR) {
            fail();
        }
        for (ssize_t done = 0; done < n;) {
            const ssize_t written =
                ::write(memory.get(), block.data() + done, static_cast<std::size_t>(n - done));
            if (written < 0 && errno != EINTR) {
                fail();
            }
            done += written > 0 ? written : 0;
        }
    }
    if (::dup2(memory.get(), STDIN_FILENO) < 0) {
        fail();
    }
}

}  // namespace

std::string input_file(const std::string& name) {
    if (name != "-") {
        return name;
    }
    if (!is_kept) {
        keep();
        is_kept = true;
    }
    return std::string(kept_file);
}

std::string as_named(std::string message) {
    const std::string quoted = fmt::format("'{}'", kept_file);
    for (std::size_t at = 0; is_kept && (at = message.find(quoted, at)) != std::string::npos;) {
        message.replace(at, quoted.size(), "'-'");
    }
    return message;
}

}  // namespace dumbbell::cli
