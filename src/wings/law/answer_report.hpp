#pragma once

#include <string>
#include <variant>

#include "law/at_ratio.hpp"
#include "words/json.hpp"

namespace dumbbell::law {

/// q_c(n), enclosed by Theorem A.
struct CriticalRatio {
    Integer n;
    BigInterval q_c;
};

/// What `law --ratio` or `law --count` tells its user. It rests on the certificate of the law that comes with
/// the program (`certificate_sha256`).
struct Answer {
    std::variant<AtRatio, CriticalRatio> found;
    std::string file;  ///< where that certificate is
};

[[nodiscard]] std::string to_text(const Answer& answer);
/// Its first line alone.
[[nodiscard]] std::string verdict(const Answer& answer);
[[nodiscard]] Json to_json(const Answer& answer);

}  // namespace dumbbell::law
