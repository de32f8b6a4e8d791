#pragma once

#include <optional>
#include <string>

#include "adiabatic/prove.hpp"
#include "words/json.hpp"

namespace dumbbell::adiabatic {

/// What `adiabatic` tells its user: one statement of the paper's section 3 with what was proved of it.
struct Report {
    std::string theorem;  ///< as on the command line
    Rational accuracy;
    Proof proof{};
    double seconds = 0;
    std::optional<std::string> out{}, sha256{};
};

/// The hypotheses in words, the statement with its constants, and the orbits.
[[nodiscard]] std::string to_text(const Report& report);
/// The constants alone, a line each.
[[nodiscard]] std::string verdict(const Report& report);
[[nodiscard]] Json to_json(const Report& report);

}  // namespace dumbbell::adiabatic
