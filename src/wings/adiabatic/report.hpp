#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adiabatic/prove.hpp"
#include "words/json.hpp"

namespace dumbbell::adiabatic {

/// One statement of the paper's section 3 with what was proved of it.
struct Result {
    Proof proof;
    double seconds = 0;
};

/// What `adiabatic` tells its user.
struct Report {
    std::string theorem;  ///< as on the command line
    Rational accuracy;
    std::vector<Result> results;  ///< one for each distance from the vertical, or exponent
    std::optional<std::string> out;
    std::optional<std::string> sha256;
};

/// The hypotheses in words, the statement with its constants, and the orbits; a table if there are several
/// results.
[[nodiscard]] std::string to_text(const Report& report);
/// The constants alone, a line each.
[[nodiscard]] std::string verdict(const Report& report);
[[nodiscard]] Json to_json(const Report& report);

}  // namespace dumbbell::adiabatic
