#pragma once

#include <string_view>

#include "adiabatic/certificate.hpp"
#include "file/sealed_lines.hpp"

namespace dumbbell::adiabatic {

/// The one canonical spelling (format-adiabatic.md). Throws BrokenInvariant if a tree is not complete.
[[nodiscard]] SealedText render(const Certificate& certificate);

/// The claim's word in the file, e.g. `adiabatic-run`, and back: nothing for an unknown word.
[[nodiscard]] std::string_view name(Claim claim);
[[nodiscard]] std::optional<Claim> claim_named(std::string_view word);

}  // namespace dumbbell::adiabatic
