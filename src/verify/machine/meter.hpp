// The work on the leaves that are judged at the same time.
#pragma once
#include <atomic>
#include <cstdint>
#include <vector>

#include "verify/core/outside.hpp"

namespace dumbbell_verify {

/// The shares of leaves that are judged at the same time, in the order of their lines. A leaf is over if it
/// and those before it take more than there is, whichever threads work on them, and when.
class Shares {
  public:
    inline static void (*watch)() = nullptr;  ///< is told that there is more; of a program without threads

    Shares(std::size_t leaves, std::uint64_t units) : units_(units), done_(leaves) {}

    /// `units` were done for leaf i so far. False if it certainly is over.
    [[nodiscard]] bool note(std::size_t i, std::uint64_t units) {
        const std::uint64_t more = units - done_[i].exchange(units);
        Watched::work += more;
        if (watch) watch();
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

/// Counts the work of this thread on its present leaf.
class Meter {
  public:
    /// Of a leaf without a share there is no bound.
    static void begin(Shares* shares = nullptr, std::size_t leaf = 0);
    [[nodiscard]] static std::uint64_t done();
    /// Throws std::length_error if the leaf's share is used up.
    static void spend(std::uint64_t units);
};

}  // namespace dumbbell_verify
