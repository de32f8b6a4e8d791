#include "cli/terminal/progress.hpp"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include "cli/terminal/messages.hpp"
#include "words/printed.hpp"

namespace dumbbell::cli {
namespace {

using namespace std::chrono_literals;

std::size_t columns() {
    winsize size{};
    return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

/// In place of the line before. The last column stays free: some terminals would begin a new line there.
void show(const std::string& line) {
    say(fmt::format("\r{}\033[K", line.substr(0, columns() - 1)));
    std::fflush(stderr);
}

std::string rate_text(std::size_t done, double seconds) {
    const double rate = static_cast<double>(done) / seconds;
    return rate < 10 ? fmt::format("{:.1f}/s", rate) : fmt::format("{:.0f}/s", rate);
}

constexpr std::size_t shortest = 5, longest = 30, frame = 4;
constexpr std::size_t shortest_bar = shortest + frame;

/// `[###......] `, as long as there is room for it.
std::string bar(std::size_t done, std::size_t total, std::size_t room) {
    const std::size_t length = std::min(longest, std::max(room, frame) - frame);
    if (length < shortest) {
        return "";
    }
    const std::size_t filled = length * done / total;
    return fmt::format("[{}{}] ", std::string(filled, '#'), std::string(length - filled, '.'));
}

}  // namespace

Progress::Progress(std::string_view unit, Verbosity verbosity, std::string_view phase)
    : unit_(unit), phase_(phase), shows_(verbosity == Verbosity::normal && stderr_is_terminal()) {
    if (!shows_) {
        return;
    }
    sigset_t all, before;  // a signal is for the thread that works
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_BLOCK, &all, &before);
    try {
        ticker_ = std::thread([this] { tick(); });
    } catch (const std::system_error&) {  // no more threads may start: the line goes on with the work alone
    }
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

Progress::~Progress() {
    if (ticker_.joinable()) {
        {
            const std::scoped_lock lock(mutex_);
            ends_ = true;
        }
        end_.notify_one();
        ticker_.join();
    }
    clear();
}

void Progress::clear() {
    if (std::exchange(shown_, false)) {
        say("\r\033[K");
    }
}

void Progress::tick() {
    constexpr auto between = 500ms;
    std::unique_lock lock(mutex_);
    while (!end_.wait_for(lock, between, [this] { return ends_; })) {
        show_if_due();
    }
}

void Progress::enter(std::string_view phase, std::string_view unit) {
    const std::scoped_lock lock(mutex_);
    if (phase != phase_) {
        phase_ = phase;
        unit_ = unit;
        phase_start_ = Clock::now();
        done_ = total_ = 0;
        count_.reset();
    }
}

void Progress::note(const std::string& line) {
    const std::scoped_lock lock(mutex_);
    clear();
    remark(line);
}

void Progress::show_if_due() {
    const auto now = Clock::now();
    if (!shows_ || now - start_ < 1s || now - last_ < 100ms) {
        return;
    }
    last_ = now;
    shown_ = true;
    show(line(columns()));
}

double Progress::elapsed() const {
    constexpr double least = 1e-3;  // a rate is a number
    return std::max(least, std::chrono::duration<double>(last_ - phase_start_).count());
}

std::string Progress::line(std::size_t room) const {
    if (done_ == 0) {
        return fmt::format("{}, {}", phase_, time_text(elapsed()));
    }
    const std::string phase = fmt::format("{}: ", phase_), rate = rate_text(done_, elapsed());
    if (total_ == 0) {
        return fmt::format("{}{} {} in {}, {}", phase, done_, unit_, time_text(elapsed()), rate);
    }
    const double share = static_cast<double>(done_) / static_cast<double>(total_);
    const double left = elapsed() * (1 - share) / share;
    const std::string text =
        fmt::format("{}/{} {}, about {} left, {}{}", done_, total_, unit_, time_text(left), rate,
                    count_ ? fmt::format(", N = {}", *count_) : "");
    if (phase.size() + text.size() + shortest_bar < room) {
        return phase + bar(done_, total_, room - phase.size() - text.size()) + text;
    }
    return bar(done_, total_, room - std::min(room, text.size())) + text;
}

void Progress::advance(std::size_t more) {
    const std::scoped_lock lock(mutex_);
    done_ += more;
    show_if_due();
}

void Progress::update(std::size_t done, std::size_t total, std::optional<long> count) {
    const std::scoped_lock lock(mutex_);
    done_ = done;
    total_ = total;
    count_ = count;
    show_if_due();
}

}  // namespace dumbbell::cli
