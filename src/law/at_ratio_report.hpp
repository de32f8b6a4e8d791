#pragma once

#include <string>

#include "law/at_ratio.hpp"
#include "words/json.hpp"

namespace dumbbell::law {

/// What `law --ratio` tells its user.
struct AtRatioReport {
    AtRatio at;
    std::string file;    ///< the certificate that the law rests on
    std::string sha256;  ///< of it
};

[[nodiscard]] std::string to_text(const AtRatioReport& report);
/// The first line alone.
[[nodiscard]] std::string verdict(const AtRatioReport& report);
[[nodiscard]] Json to_json(const AtRatioReport& report);

}  // namespace dumbbell::law
