#include "starts/air/first_flight.hpp"

#include <algorithm>
#include <cmath>

namespace dumbbell::starts {

std::optional<FirstContactGuess> guess_first_contact(double phi, double yhat, double phidot, double yhatdot,
                                                     double r) noexcept {
    // The floor rises by at most |phidot| per unit of time under the dumbbell: steps that cannot pass a
    // contact, until Newton's iteration is near enough.
    const double fastest = std::abs(phidot) + std::max(0.0, -yhatdot);
    double t = yhatdot < 0 && yhat > 1 ? (yhat - 1) / -yhatdot : 0;
    constexpr double near = 1e-9;
    for (int step = 0; step < 20000; ++step) {
        const double height = yhat + yhatdot * t;
        if (fastest == 0 || (height > 1 && yhatdot >= 0)) {
            return std::nullopt;
        }
        const double sine = std::sin(phi + phidot * t);
        const flight::End end = sine < 0 ? flight::End::light : flight::End::heavy;
        const double gap = height - std::max(-sine, r * sine);
        if (gap < near) {
            return FirstContactGuess{end, t};
        }
        // Over the convex stretches of the clearance a Newton step does not pass the contact either.
        const double turning = phidot * std::cos(phi + phidot * t);
        const double rate = yhatdot + (end == flight::End::light ? turning : -r * turning);
        const double safe = gap / fastest;
        double advance = safe;
        if (rate < 0) {
            const double newton = gap / -rate;
            const double ahead = std::sin(phi + phidot * (t + newton));
            const bool same_hump = (ahead < 0) == (sine < 0) && newton * std::abs(phidot) < 3;
            advance = same_hump ? std::max(newton, safe) : safe;
        }
        t += advance;
    }
    return std::nullopt;
}

}  // namespace dumbbell::starts
