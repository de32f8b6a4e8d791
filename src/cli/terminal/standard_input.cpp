#include "cli/terminal/standard_input.hpp"

#include <fmt/core.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "base/error.hpp"
#include "file/descriptor.hpp"

namespace dumbbell::cli {
namespace {

[[noreturn]] void fail() {
    throw InputError(fmt::format("cannot read the standard input: {}", std::strerror(errno)));
}

/// Puts all that the standard input still has in its place.
void keep() {
    const Descriptor memory(::memfd_create("stdin", MFD_CLOEXEC));
    if (memory.get() < 0) {
        fail();
    }
    std::array<char, 65536> block{};
    for (;;) {
        const ssize_t n = ::read(STDIN_FILENO, block.data(), block.size());
        if (n == 0) {
            break;
        }
        if (n < 0 && errno != EINTR) {
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
    static const bool kept = (keep(), true);
    (void)kept;
    return "/dev/stdin";
}

}  // namespace dumbbell::cli
