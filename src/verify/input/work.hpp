// The work on a file is bounded, so that every file comes to a verdict (format.md, section 4). It is counted
// in units, not by a clock: the verdict is the same on every machine and with any number of threads.
#pragma once
#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace dumbbell_verify {

constexpr std::uint64_t units_per_second = 6'000'000'000;  ///< of about one second of a core
constexpr std::uint64_t default_budget = 30 * units_per_second;

/// For people who wait: of all files so far.
struct Watched {
    inline static std::atomic<std::uint64_t> bytes = 0;                       ///< that were read, unpacked
    inline static std::atomic<std::uint64_t> work = 0, read = 0, pieces = 0;  ///< `read` of all `pieces`
};

/// The shares of leaves that are judged at the same time, in the order of their lines. A leaf is over if it
/// and those before it take more than there is, whichever threads work on them, and when.
class Shares {
  public:
    Shares(std::size_t leaves, std::uint64_t units) : units_(units), done_(leaves) {}

    /// `units` were done for leaf i so far. False if it certainly is over.
    [[nodiscard]] bool note(std::size_t i, std::uint64_t units) {
        const std::uint64_t more = units - done_[i].exchange(units);
        Watched::work += more;
        return (all_ += more) <= units_ || up_to(i) <= units_;
    }
    [[nodiscard]] std::uint64_t of(std::size_t i) const { return done_[i]; }

  private:
    [[nodiscard]] std::uint64_t up_to(std::size_t i) const {
        std::uint64_t sum = 0;
        for (std::size_t j = 0; j <= i; ++j) sum += done_[j];
        return sum;
    }

    const std::uint64_t units_;
    std::atomic<std::uint64_t> all_ = 0;
    std::vector<std::atomic<std::uint64_t>> done_;
};

/// What this thread has done for its present leaf.
class Work {
  public:
    /// Of a leaf without a share there is no bound.
    static void begin(Shares* shares = nullptr, std::size_t leaf = 0) {
        done_ = 0;
        shares_ = shares;
        leaf_ = leaf;
        look_ = shares ? step : UINT64_MAX;
        spend(leaf_itself);
    }
    [[nodiscard]] static std::uint64_t done() { return done_; }

    static void spend(std::uint64_t units) {
        done_ += units;
        if (done_ >= look_) look();
    }
    /// One operation in multiple precision.
    static void operation(std::uint64_t bits) { spend(256 + bits); }
    /// Halving between exact numbers of so many words of 64 bits together: mostly a greatest common divisor.
    static constexpr std::uint64_t of_halving(std::uint64_t words) {
        return 512 + 320 * words + words * words / 2;
    }
    /// A box of exact numbers of so many words together, 2^-depth of the root box: bounds of them, and its
    /// share.
    static constexpr std::uint64_t of_box(std::uint64_t words, int depth) {
        return 1024 + 64 * words + static_cast<std::uint64_t>(depth);
    }
    /// One collision of a ray in double precision; with more bits its operations are most of the work.
    static void collision() { spend(4096); }

  private:
    static constexpr std::uint64_t step = 1 << 24;         ///< between two looks at the shares
    static constexpr std::uint64_t leaf_itself = 1 << 14;  ///< its box, and inequalities without a ray

    static void look() {
        look_ = done_ + step;
        if (!shares_->note(leaf_, done_)) throw std::length_error("the budget is used up");
    }

    inline static thread_local std::uint64_t done_ = 0, look_ = UINT64_MAX;
    inline static thread_local Shares* shares_ = nullptr;
    inline static thread_local std::size_t leaf_ = 0;
};

}  // namespace dumbbell_verify
