#pragma once

#include <optional>
#include <string>

#include "law/at_ratio_report.hpp"
#include "words/json.hpp"

namespace dumbbell::law {

/// What `certify --by law` tells its user.
struct CertifiedReport {
    AtRatioReport answer;
    std::optional<std::string> law{};     ///< the law's certificate as it was named; nothing: the shipped one
    std::optional<std::string> out{};     ///< where the certificate is
    std::optional<std::string> sha256{};  ///< of it
};

[[nodiscard]] std::string to_text(const CertifiedReport& report);
/// The first line alone.
[[nodiscard]] std::string verdict(const CertifiedReport& report);
[[nodiscard]] Json to_json(const CertifiedReport& report);

}  // namespace dumbbell::law
