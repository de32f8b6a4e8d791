// Why a file is not verified, and what verifying it may cost.
#pragma once
#include <cstdint>
#include <string>

#include "verify/input/work.hpp"

namespace dumbbell_verify {

/// With several files the last one of these counts.
enum class Verdict { verified, unreadable, open, unsupported, limit, rejected };

/// Why a file is not verified; thrown, and reported as it is.
struct Failure {
    Verdict verdict;
    std::uint64_t line;
    std::string code, text;
};

/// Units of work as seconds: whole ones, or with three decimals.
inline std::string seconds(std::uint64_t units) {
    const std::uint64_t thousandths = units / (units_per_second / 1000), part = thousandths % 1000;
    const std::string decimals = part == 0 ? "" : "." + std::to_string(1000 + part).substr(1);
    return std::to_string(thousandths / 1000) + decimals + " s";
}

/// What a file may cost, in the units of work.hpp; its reader and what it reads share it.
class Budget {
  public:
    explicit Budget(std::uint64_t units) : all_(units), left_(units) {}
    [[nodiscard]] std::uint64_t left() const { return left_; }
    [[nodiscard]] std::uint64_t taken() const { return all_ - left_; }
    /// Throws Failure if there is not so much; then nothing is left.
    void take(std::uint64_t units, std::uint64_t line) {
        const bool enough = units <= left_;
        left_ -= enough ? units : left_;
        if (!enough)
            throw Failure{Verdict::limit, line, "limit",
                          "more work than the budget of " + seconds(all_) + ": --budget allows more"};
    }

  private:
    std::uint64_t all_, left_;
};

}  // namespace dumbbell_verify
