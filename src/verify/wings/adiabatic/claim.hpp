// The claim kinds `adiabatic-*`: what a file says of the adiabatic invariant, in words and numbers.
#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "verify/kinds/other_claim.hpp"

namespace dumbbell_verify::adiabatic {

/// For every delta in [D1, D2], epsilon = delta^2, and the states that section 1 of format-adiabatic.md
/// describes: the error or change is at most `bounds` in the unit of that section, and the states `attained`
/// have at least their `value` in it.
struct Claim : OtherClaim {
    enum Kind { bounce, run, scattering };
    static constexpr std::array<std::string_view, 3> names{"adiabatic-bounce", "adiabatic-run",
                                                           "adiabatic-scattering"};
    struct Attained {
        mpq_class u, s, delta;
        std::uint64_t collisions = 0;
        mpq_class value;
    };

    Kind kind = bounce;
    mpq_class delta_lo, delta_hi, y_lo, y_hi, margin;
    std::uint64_t exponent = 0;      ///< the margin is `margin` delta^(exponent/16)
    std::vector<mpq_class> bounds;   ///< C, or C1 and C2
    std::vector<Attained> attained;  ///< one, or one for each of C1 and C2

    [[nodiscard]] std::string_view kind_name() const override { return names.at(kind); }
    [[nodiscard]] std::string_view leaves() const override { return "box.01, class0.01, attained1, ..."; }
    [[nodiscard]] bool has_heights() const { return kind == bounce || kind == run; }
    [[nodiscard]] bool has_classes() const { return kind != bounce; }

    /// Of each attained value in decimals: C rounded up, B rounded down, C/B rounded up; empty if B is 0.
    struct Summary {
        std::string bound, attained, ratio;
    };
    [[nodiscard]] std::vector<Summary> summaries() const;
    /// For the verdict: kind and numbers, exact but for those of the summaries.
    [[nodiscard]] std::string text() const override;
    /// The claim in words, lines that begin with two spaces.
    [[nodiscard]] std::string paragraph() const override;
    [[nodiscard]] std::string json() const override;
};

}  // namespace dumbbell_verify::adiabatic
