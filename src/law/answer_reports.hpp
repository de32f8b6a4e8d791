#pragma once

#include <optional>
#include <string>

#include "law/at_ratio.hpp"
#include "words/json.hpp"

/// Answers that rest on the certificate of the law, as their users are told them: `to_text`, its first line
/// alone as `verdict`, and `to_json`.
namespace dumbbell::law {

/// What `law --ratio` tells its user.
struct AtRatioReport {
    AtRatio at;
    std::string file;    ///< the certificate that the law rests on
    std::string sha256;  ///< of it
};

[[nodiscard]] std::string to_text(const AtRatioReport& report);
[[nodiscard]] std::string verdict(const AtRatioReport& report);
[[nodiscard]] Json to_json(const AtRatioReport& report);

/// What `certify --by law` tells its user.
struct CertifiedReport {
    AtRatioReport answer;
    std::optional<std::string> law{};     ///< the law's certificate as it was named; nothing: the shipped one
    std::optional<std::string> out{};     ///< where the certificate is
    std::optional<std::string> sha256{};  ///< of it
};

[[nodiscard]] std::string to_text(const CertifiedReport& report);
[[nodiscard]] std::string verdict(const CertifiedReport& report);
[[nodiscard]] Json to_json(const CertifiedReport& report);

/// What `critical --by law` tells its user.
struct CriticalByLaw {
    Integer n;
    BigInterval q_c;
    std::string file;    ///< the certificate that the law rests on
    std::string sha256;  ///< of it
};

[[nodiscard]] std::string to_text(const CriticalByLaw& report);
[[nodiscard]] std::string verdict(const CriticalByLaw& report);
[[nodiscard]] Json to_json(const CriticalByLaw& report);

}  // namespace dumbbell::law
