#pragma once

#include <string>

#include "staircase/law.hpp"
#include "words/json.hpp"

namespace dumbbell::staircase {

/// What `law` tells its user of a verified file.
struct LawReport {
    std::string file;
    std::string verdict;  ///< of the independent verifier
    int digits = 50;      ///< of C, each of them proved
    Law law;
};

/// Whether all that the command is asked for is proved.
[[nodiscard]] bool all_proved(const Law& law);

[[nodiscard]] std::string to_text(const LawReport& report);
/// What is proved or not, without the constant.
[[nodiscard]] std::string verdict(const LawReport& report);
[[nodiscard]] Json to_json(const LawReport& report);

}  // namespace dumbbell::staircase
