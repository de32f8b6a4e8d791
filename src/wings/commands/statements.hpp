#pragma once

#include <array>
#include <vector>

#include "adiabatic/certificate.hpp"
#include "cli/options/given.hpp"

namespace dumbbell::cli {

/// What `adiabatic` is to prove.
inline constexpr std::array statement_options{
    Option{"--delta", "D|D1:D2", "square root of the light mass, or closed range D1:D2"}.required(),
    Option{"--theorem", "lemma3.1|cor3.2|thm3.3|thm3.5", "the statement", "thm3.3"},
    Option{"--y", "Y1:Y2",
           "heights of the centre of mass before the first collision; default 0:1, thm3.3: 0:0.9"},
    Option{"--phi-margin", "M[,M...]",
           "distance from the vertical: m of m delta^k (default 1), u_* (thm3.3: 0.3) or c of c "
           "sqrt(delta) (thm3.5: 1/2); radians, or like 30deg, pi/6, 0.1pi (cut down to 12 "
           "digits); or a list of them"},
    Option{"--k", "K[,K...]", "cor3.2: the exponent, a multiple of 1/16 from 0 to 1; or a list"},
    Option{"--accuracy", "A", "how far the bound may exceed what is attained, relatively", "0.1"}};

/// All statements asked for: one for each exponent and distance from the vertical, the distance running
/// fastest. Throws InputError, which names the option, if one of them makes no sense.
[[nodiscard]] std::vector<adiabatic::Hypotheses> statements_of(const Given& given);

/// Of --accuracy: greater than 0, at most 1. Throws InputError.
[[nodiscard]] Rational accuracy_of(const Given& given);

}  // namespace dumbbell::cli
