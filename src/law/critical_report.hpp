#pragma once

#include <string>

#include "number/big_interval.hpp"
#include "number/integer.hpp"
#include "words/json.hpp"

namespace dumbbell::law {

/// What `critical --by law` tells its user.
struct CriticalByLaw {
    Integer n;
    BigInterval q_c;
    std::string file;    ///< the certificate that the law rests on
    std::string sha256;  ///< of it
};

[[nodiscard]] std::string to_text(const CriticalByLaw& report);
/// The enclosure alone.
[[nodiscard]] std::string verdict(const CriticalByLaw& report);
[[nodiscard]] Json to_json(const CriticalByLaw& report);

}  // namespace dumbbell::law
