// The work on one leaf is bounded, so that every file comes to a verdict (format.md, section 4).
#pragma once
#include <cstdint>
#include <stdexcept>

namespace dumbbell_verify {

/// What this thread has done for its present leaf, in units of about a sixth of a nanosecond.
class Work {
  public:
    static constexpr std::uint64_t most = std::uint64_t{1} << 39;

    static void begin() { done_ = 0; }
    [[nodiscard]] static std::uint64_t done() { return done_; }

    static void spend(std::uint64_t units) {
        done_ += units;
        if (done_ > most) throw std::length_error("too many collisions in too high a precision");
    }
    /// One operation in multiple precision.
    static void operation(std::uint64_t bits) { spend(256 + bits); }
    /// One collision of a ray in double precision; with more bits its operations are most of the work.
    static void collision() { spend(4096); }

  private:
    inline static thread_local std::uint64_t done_ = 0;
};

}  // namespace dumbbell_verify
