// Steps near a critical ratio, in 80 digits, from the reflection law and the clock as proofs/law.md defines
// them (tests/attacks/oracle): no formula of the covers is used.
#pragma once
#include <string>
#include <utility>

#include "attacks/oracle/law.hpp"

namespace law_truth {

using Real = dumbbell_oracle::Digits80;
using Step = dumbbell_oracle::law::Step<Real>;
using dumbbell_oracle::law::tau, dumbbell_oracle::law::tau_by_angle;
/// The first 110 digits, from Arb (they are those that `dumbbell law --digits 110` prints).
inline const char* const C =
    "0."
    "88559512945271391141202194891455767300579529460285208340726080557816077824860635006196282336302454044270"
    "037489";
inline const char* const c0 =
    "0."
    "20581158954949559533970656710171431017859449010666863363550570216726753280881521340199369108344103302081"
    "398986";
inline Real pi() { return dumbbell_oracle::pi<Real>(); }
inline Real k0() { return dumbbell_oracle::law::k0<Real>(); }

/// The last contact, u_b = 2 d, and the tangent flight of angle th after it.
struct End {
    Real eps, u, J;
    End(const Real& d, const Real& th) {
        u = 2 * d;
        Real slope = 0;  // cos u + slope (2 pi - u) = sqrt(1 - slope^2) + slope asin slope
        for (int i = 0; i < 60; ++i)
            slope = (sqrt(1 - slope * slope) + slope * asin(slope) - cos(u)) / (2 * pi() - u);
        eps = slope / tan(th);
        J = (pi() - u) * cos(th - atan(eps / sin(u)));
    }
};

/// What stands before the fact `what` in a log: the first interval of that line.
inline std::pair<double, double> enclosure(const std::string& log, const std::string& what) {
    const std::size_t fact = log.find("  " + what);
    if (fact == std::string::npos || fact == 0) return {1, 0};
    const std::size_t line = log.rfind('\n', fact - 2) + 1;
    const std::string text = log.substr(line, fact - line);
    const std::size_t open = text.find_first_not_of(' ');
    if (text[open] != '[') return {std::stod(text), std::stod(text)};
    return {std::stod(text.substr(open + 1)), std::stod(text.substr(text.find(", ") + 2))};
}

/// What stands there if the line is `least <= most`.
inline std::pair<double, double> bounds(const std::string& log, const std::string& what) {
    const std::size_t fact = log.find("  " + what);
    if (fact == std::string::npos || fact == 0) return {1, 0};
    const std::string text = log.substr(log.rfind('\n', fact - 2) + 1);
    return {std::stod(text), std::stod(text.substr(text.find("<= ") + 3))};
}

}  // namespace law_truth
