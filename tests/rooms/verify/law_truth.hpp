// Steps near a critical ratio, in 80 digits, from the reflection law and the clock as proofs/law.md defines
// them: no formula of the covers is used.
#pragma once
#include <boost/multiprecision/mpfr.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "attacks/oracle/scalar.hpp"

namespace law_truth {

using Real = dumbbell_oracle::Digits80;
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
inline Real k0() { return pow(Real(3), Real(-7) / 4) / sqrt(pi()); }

/// Gauss-Legendre with 60 nodes.
inline Real integral(const std::function<Real(Real)>& f, const Real& a, const Real& b) {
    static constexpr int n = 60;
    static const auto nodes = [] {
        std::vector<std::pair<Real, Real>> table;
        for (int i = 1; i <= n; ++i) {
            Real x = cos(pi() * (i - Real(1) / 4) / (n + Real(1) / 2)), slope;
            for (int round = 0; round < 9; ++round) {
                Real before = 1, p = x;
                for (int k = 2; k <= n; ++k)
                    before = std::exchange(p, ((2 * k - 1) * x * p - (k - 1) * before) / k);
                slope = n * (x * p - before) / (x * x - 1);
                x -= p / slope;
            }
            table.emplace_back(x, 2 / ((1 - x * x) * slope * slope));
        }
        return table;
    }();
    Real sum = 0;
    for (const auto& [x, weight] : nodes) sum += weight * f((a + b) / 2 + (b - a) / 2 * x);
    return sum * (b - a) / 2;
}
/// tau(u, J), for u well below pi - J.
inline Real clock(const Real& u, const Real& J) {
    return integral(
        [&](const Real& x) { return sin(x) * J / ((pi() - x) * sqrt((pi() - x) * (pi() - x) - J * J)); }, 0,
        u);
}
/// The same for any alpha >= 0, J = (pi - u) cos alpha.
inline Real clock_by_angle(const Real& alpha, const Real& J) {
    return integral([&](const Real& a) { return sin(J / cos(a)); }, alpha, acos(J / pi()));
}

/// A step of middle U, half-length d and flight angle th.
struct Step {
    Real eps, u, u_last, alpha, alpha_last, J, J_last;
    Step(const Real& U, const Real& d, const Real& th) {
        u = U + d, u_last = U - d;
        eps = (cos(u_last) - cos(u)) / (tan(th) * (2 * pi() - u - u_last));
        alpha = th - atan(eps / sin(u)), alpha_last = th + atan(eps / sin(u_last));
        J = (pi() - u) * cos(alpha), J_last = (pi() - u_last) * cos(alpha_last);
    }
};
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
