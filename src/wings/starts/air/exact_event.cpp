#include "starts/air/exact_event.hpp"

namespace dumbbell::starts {
namespace {

bool is_exactly(const Box& box, Axis axis, const Rational& value) {
    return box.lower(axis) == value && box.upper(axis) == value;
}

bool is_level(const Box& box, const std::optional<Angle>& phi) {
    return phi && !phi->is_rational() ? denominator(phi->pis) == 1 : is_exactly(box, Axis::phi, 0);
}

bool grazes(const Box& box) {
    const Rational& y = box.lower(Axis::y);
    const Rational q = box.ratio_of_distances();
    return is_exactly(box, Axis::ydot, 0) && is_exactly(box, Axis::y, y) &&
           is_exactly(box, Axis::ratio, box.lower(Axis::ratio)) && y * (1 + q) == q;
}

/// The time of a point's corner.
std::optional<Rational> corner(const Box& box) {
    const Rational& phi = box.lower(Axis::phi);
    const Rational& spin = box.lower(Axis::phidot);
    const Rational& height = box.lower(Axis::y);
    const Rational& climb = box.lower(Axis::ydot);
    const Rational q = box.ratio_of_distances();
    if (!box.is_point() || climb >= 0 || phi * climb != spin * height) {
        return std::nullopt;
    }
    // beta (1 + q) of the mass that could touch before.
    const Rational weight = phi > 0 && phi <= 3 ? Rational(1) : q;
    const bool neither_before = weight * abs(spin) <= -climb * (1 + q);
    return neither_before ? std::optional(Rational(height / -climb)) : std::nullopt;
}

}  // namespace

std::optional<ExactEvent> exact_event(const Box& box, const std::optional<Angle>& phi) {
    if (grazes(box)) {
        return ExactEvent{Obstacle::graze};
    }
    if (is_exactly(box, Axis::phidot, 0) && is_level(box, phi) && box.upper(Axis::ydot) < 0) {
        const Rational& y = box.lower(Axis::y);
        const Rational& ydot = box.lower(Axis::ydot);
        const bool at_once = is_exactly(box, Axis::y, y) && is_exactly(box, Axis::ydot, ydot);
        return ExactEvent{Obstacle::flat, at_once ? std::optional(Rational(y / -ydot)) : std::nullopt};
    }
    const auto time = corner(box);
    return time ? std::optional(ExactEvent{Obstacle::corner, time}) : std::nullopt;
}

}  // namespace dumbbell::starts
