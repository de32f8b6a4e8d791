#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "words/json.hpp"

namespace dumbbell::law {

/// What `law` tells of the law for every mass ratio: that its certificate was verified, or made.
struct TheoremReport {
    int digits = 50;                       ///< of the constants, each of them proved
    std::optional<std::string> verdict{};  ///< of the independent verifier; nothing: it was made
    std::size_t leaves = 0;                ///< of the layer, where it was made
    double seconds = 0;
    std::optional<std::string> out{};  ///< where the certificate is
    std::optional<std::string> sha256{};
};

[[nodiscard]] std::string to_text(const TheoremReport& report);
/// What is proved, without the constants.
[[nodiscard]] std::string verdict(const TheoremReport& report);
[[nodiscard]] Json to_json(const TheoremReport& report);

}  // namespace dumbbell::law
