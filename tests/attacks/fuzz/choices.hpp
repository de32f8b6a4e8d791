// The bytes of an input as a row of decisions, for targets that build what they try.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <string>

namespace dumbbell_fuzz {

/// Behind the end of the bytes every choice is 0: the plainest one.
class Choices {
  public:
    Choices(const std::uint8_t* data, std::size_t size) : rest_(data, size) {
        std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
        for (const std::uint8_t byte : rest_) hash = (hash ^ byte) * 0x100000001b3;
        engine_.seed(hash);
    }

    [[nodiscard]] bool none_left() const { return rest_.empty(); }
    /// The bytes that no choice has taken yet.
    [[nodiscard]] std::string rest() const { return {rest_.begin(), rest_.end()}; }

    /// 0 to n - 1; 1 <= n <= 2^16.
    std::size_t below(std::size_t n) { return n <= 1 ? 0 : (n <= 256 ? byte() : 256 * byte() + byte()) % n; }
    /// lo to hi.
    long between(long lo, long hi) {
        return lo + static_cast<long>(below(static_cast<std::size_t>(hi - lo + 1)));
    }
    bool coin() { return below(2) == 1; }

    /// In [0, 1], ends included; from the hash of all bytes, so that it costs the input nothing. For samples.
    double sample() {
        switch (engine_() % 4) {
            case 0:
                return 0;
            case 1:
                return 1;
            default:
                return std::uniform_real_distribution<double>(0, 1)(engine_);
        }
    }
    std::size_t sample_below(std::size_t n) { return engine_() % n; }

  private:
    std::size_t byte() {
        if (rest_.empty()) return 0;
        const std::uint8_t first = rest_.front();
        rest_ = rest_.subspan(1);
        return first;
    }

    std::span<const std::uint8_t> rest_;
    std::mt19937_64 engine_;
};

}  // namespace dumbbell_fuzz
