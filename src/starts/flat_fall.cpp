#include "starts/flat_fall.hpp"

namespace dumbbell::starts {

std::optional<Rational> flat_fall(const InitialBox& box) {
    const Rational& phi = box.lower(InitialAxis::phi);
    const Rational& spin = box.lower(InitialAxis::phidot);
    const Rational& height = box.lower(InitialAxis::y);
    const Rational& climb = box.lower(InitialAxis::ydot);
    const Rational& q = box.lower(InitialAxis::ratio);
    if (!box.is_point() || climb >= 0 || phi * climb != spin * height) {
        return std::nullopt;
    }
    // beta (1 + q) of the mass that could touch before.
    const Rational weight = phi > 0 && phi <= 3 ? Rational(1) : q;
    const bool neither_before = weight * abs(spin) <= -climb * (1 + q);
    return neither_before ? std::optional(Rational(height / -climb)) : std::nullopt;
}

}  // namespace dumbbell::starts
