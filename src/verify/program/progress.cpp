#include "verify/program/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "verify/machine/seconds.hpp"

namespace dumbbell_verify {
namespace {

/// `reads`: what is done at present is reading alone.
std::string line(std::uint64_t budget, bool reads) {
    const std::uint64_t of = Watched::pieces;
    return (reads ? "reading: " + std::to_string(Watched::bytes / 1'000'000) + " MB, "
                  : std::string("verifying: ")) +
           (of > 1 ? std::to_string(Watched::read) + " of " + std::to_string(of) + " pieces, " : "") +
           std::to_string(Watched::work / units_per_second) + " s of work" +
           (reads ? "" : ", at most " + seconds(budget) + " a file");
}

}  // namespace

Progress::Progress(bool wanted, std::uint64_t budget) : budget_(budget) {
    if (wanted && ::isatty(STDERR_FILENO) == 1) crew_.start(1, [this] { watch(); });
}

Progress::~Progress() {
    {
        const auto lock = hidden();
        ended_ = true;
    }
    ends_.notify_all();
}

std::unique_lock<std::mutex> Progress::hidden() {
    std::unique_lock lock(mutex_);
    if (!shown_.empty()) {
        show("");
        std::fputc('\r', stderr);
    }
    return lock;
}

/// In place of the line before.
void Progress::show(const std::string& text) {
    if (text == shown_) return;
    const std::size_t rest = shown_.size() - std::min(shown_.size(), text.size());
    std::fprintf(stderr, "\r%s%s", text.c_str(), std::string(rest, ' ').c_str());
    std::fflush(stderr);
    shown_ = text;
}

void Progress::watch() {
    using namespace std::chrono_literals;
    const auto is_over = [this] { return ended_; };
    std::unique_lock lock(mutex_);
    std::uint64_t read = 0, worked = 0;  // until the line before
    for (auto pause = 1000ms; !ends_.wait_for(lock, pause, is_over); pause = 200ms) {
        const std::uint64_t bytes = Watched::bytes, work = Watched::work;
        show(line(budget_, work == worked && (bytes == 0 || bytes != read)));
        read = bytes;
        worked = work;
    }
}

}  // namespace dumbbell_verify
