// The claim kind `law`: what a file says of all mass ratios.
#pragma once
#include <string_view>
#include <utility>

#include "verify/kinds/other_claim.hpp"

namespace dumbbell_verify::law {

/// The steps N of the staircase that a file proves one by one. Beyond the last the covers do.
constexpr unsigned first_step = 3, last_step = 902;
/// From the step to this N on the law gives N*(q) by a formula, up to 1.
constexpr unsigned law_step = 9;

/// For every mass ratio q >= q_c(9): 2 + floor(C sqrt q - c0 q^(-1/4)) <= N*(q) <= 2 + floor(C sqrt q); for
/// every q >= 1: 0.980 <= N*(q) - C sqrt q <= 2.115 (proofs/law.md).
struct Claim : OtherClaim {
    std::pair<mpq_class, mpq_class> from;  ///< q_c(9) lies between these

    [[nodiscard]] std::string_view kind_name() const override { return "law"; }
    [[nodiscard]] std::string_view leaves() const override {
        return "9:light.01, 9:witness, layer.01, bulk1.1, end.1, ...";
    }
    [[nodiscard]] std::string text() const override;
    /// The claim in words, lines that begin with two spaces.
    [[nodiscard]] std::string paragraph() const override;
    [[nodiscard]] std::string json() const override;
};

}  // namespace dumbbell_verify::law
