#pragma once

#include <string_view>

#include "adiabatic/certificate.hpp"
#include "file/sealed_lines.hpp"

namespace dumbbell::adiabatic {

/// The one canonical spelling (format-adiabatic.md). Throws BrokenInvariant if it, or a tree, is not
/// complete.
[[nodiscard]] SealedText render(const Certificate& certificate);

/// Words for the command line of the verifier, with which it is asked for all that a file says.
[[nodiscard]] std::string claim_options(const Hypotheses& of, const std::vector<Rational>& bounds,
                                        const std::vector<State>& attained);

/// The claim's word in the file.
[[nodiscard]] constexpr std::string_view name(Claim claim) {
    switch (claim) {
        case Claim::bounce:
            return "adiabatic-bounce";
        case Claim::run:
            return "adiabatic-run";
        case Claim::scattering:
            return "adiabatic-scattering";
    }
    return {};
}

}  // namespace dumbbell::adiabatic
