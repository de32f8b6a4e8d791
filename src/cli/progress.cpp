#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace dumbbell {

using namespace std::chrono_literals;

Progress::Progress(std::string_view unit) : unit_(unit), terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (shown_) {
        fmt::print(stderr, "\r\033[K");
    }
}

void Progress::update(std::size_t done, std::size_t total) {
    if (!terminal_) {
        return;
    }
    const std::scoped_lock lock(mutex_);
    const auto now = Clock::now();
    if (now - start_ < 1s || now - last_ < 100ms) {
        return;
    }
    last_ = now;
    shown_ = true;
    constexpr std::size_t bar = 30;
    const std::size_t filled = bar * done / total;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const double left = elapsed * static_cast<double>(total - done) / static_cast<double>(done);
    fmt::print(stderr, "\r[{}{}] {}/{} {}, about {:.0f} s left\033[K", std::string(filled, '#'),
               std::string(bar - filled, '.'), done, total, unit_, left);
    std::fflush(stderr);
}

}  // namespace dumbbell
