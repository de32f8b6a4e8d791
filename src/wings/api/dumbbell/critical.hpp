#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "dumbbell/stopped.hpp"

/// The critical ratios, where N(q) steps up: N(q) = n - 1 just below q_c(n), and n from there on.
namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

struct CriticalOptions {
    int digits = 15;  ///< significant digits, 1 to 1000
    std::optional<std::chrono::duration<double>> budget = std::nullopt;
    Stopped stopped = {};
};

/// lo <= q_c(n) <= hi: decimals with two digits more than are proved, rounded outward; MassRatio takes them.
struct CriticalRatio {
    std::string lo;
    std::string hi;
    std::string digits;  ///< the first digits of q_c(n), as many as were asked for, not rounded
};

/// q_c(n), by Theorem 2 of proofs/theorem.md; nothing if it is not enclosed in time. Throws InputError unless
/// 3 <= n <= 10^17, and for digits out of range.
[[nodiscard]] [[gnu::visibility("default")]] std::optional<CriticalRatio> critical(
    long n, const CriticalOptions& options = {});

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
