// The claim kinds `law` and `collisions-by-law`: what a file says of all mass ratios, and of one of them.
#pragma once
#include <string_view>
#include <vector>

#include "verify/format/claim.hpp"

namespace dumbbell_verify {

/// The steps N of the staircase that a file proves one by one. Beyond the last the covers do.
constexpr std::uint64_t first_step = 3, last_step = 902;
/// From the step to this N on the law gives N*(q) by a formula, up to 1.
constexpr std::uint64_t law_step = 9;

/// For every mass ratio q >= q_c(9): 2 + floor(C sqrt q - c0 q^(-1/4)) <= N*(q) <= 2 + floor(C sqrt q); for
/// every q >= 1: 0.980 <= N*(q) - C sqrt q <= 2.115 (proofs/law.md).
struct Law {
    static constexpr std::string_view leaves = "9:light.01, 9:witness, layer.01, bulk1.1, end.1, ...";
    /// q_c(N) lies in [lo, hi].
    struct Step {
        mpq_class lo, hi;
    };
    std::vector<Step> steps;  ///< from the first to the last
    [[nodiscard]] const Step& step(std::uint64_t n) const { return steps.at(n - first_step); }

    [[nodiscard]] std::string text() const;
    /// The claim in words, lines that begin with two spaces.
    [[nodiscard]] static std::string paragraph();
    [[nodiscard]] std::string json() const;
};

/// lower <= N*(q) <= upper, by the law and the file of it with the SHA-256 `law`.
struct LawAtRatio {
    static constexpr std::string_view kind = "collisions-by-law", leaves = "upper and lower";
    mpq_class q;
    mpz_class lower, upper;
    std::string law;

    /// Empty if this proves the bounds at the ratio that are demanded.
    [[nodiscard]] std::string missing(const Collisions& demand) const;
    [[nodiscard]] std::string text() const;
    /// What it rests on, in words, lines that begin with two spaces.
    [[nodiscard]] static std::string paragraph();
    [[nodiscard]] std::string json() const;
};

}  // namespace dumbbell_verify
