#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <utility>

namespace dumbbell {

using namespace std::chrono_literals;

Progress::Progress(std::string_view unit) : unit_(unit), terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { clear(); }

void Progress::clear() {
    if (std::exchange(shown_, false)) {
        fmt::print(stderr, "\r\033[K");
    }
}

void Progress::note(const std::string& line) {
    const std::scoped_lock lock(mutex_);
    clear();
    fmt::print(stderr, "{}\n", line);
}

bool Progress::is_due() {
    const auto now = Clock::now();
    if (!terminal_ || now - start_ < 1s || now - last_ < 100ms) {
        return false;
    }
    last_ = now;
    shown_ = true;
    return true;
}

void Progress::advance(std::size_t more) {
    const std::scoped_lock lock(mutex_);
    done_ += more;
    if (is_due()) {
        const double elapsed = std::chrono::duration<double>(last_ - start_).count();
        fmt::print(stderr, "\r{} {} in {:.0f} s\033[K", done_, unit_, elapsed);
        std::fflush(stderr);
    }
}

void Progress::update(std::size_t done, std::size_t total) {
    const std::scoped_lock lock(mutex_);
    if (!is_due()) {
        return;
    }
    constexpr std::size_t bar = 30;
    const std::size_t filled = bar * done / total;
    const double elapsed = std::chrono::duration<double>(last_ - start_).count();
    const double left = elapsed * static_cast<double>(total - done) / static_cast<double>(done);
    fmt::print(stderr, "\r[{}{}] {}/{} {}, about {:.0f} s left\033[K", std::string(filled, '#'),
               std::string(bar - filled, '.'), done, total, unit_, left);
    std::fflush(stderr);
}

}  // namespace dumbbell
