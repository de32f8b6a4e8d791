#pragma once

#include "adiabatic/bounce_leaf.hpp"

/// One orbit of the light mass from collision to collision, enclosed (format-adiabatic.md, section 6).
namespace dumbbell::adiabatic {

template <class I>
class Orbit {
  public:
    /// Before collision 0, at angle u from the vertical, |phidot| = 1 and ydot = -delta s.
    Orbit(const I& u, const I& s, const I& delta)
        : masses_(delta),
          at_(light_contact(half_pi<I>() - u, masses_.beta2)),
          kappa_(-(delta * s) / masses_.beta2),
          energy_(I(1) + sqr(s) / masses_.beta2),
          first_x_(at_.x),
          first_f_(at_.f),
          first_kappa_(kappa_) {}

    [[nodiscard]] const Masses<I>& masses() const { return masses_; }
    /// The collision that is reached.
    [[nodiscard]] const LightContact<I>& at() const { return at_; }
    [[nodiscard]] I angle() const { return half_pi<I>() - at_.x; }

    /// I before the collision, less that before the first.
    [[nodiscard]] I change() const { return speed() * at_.f - first_f_; }
    /// I after the collision, less that before the first.
    [[nodiscard]] I change_behind() const {
        return at_.f * speed() * abs(reflection().denominator) / (sqr(at_.w) + masses_.r) - first_f_;
    }

    /// Whether the first collision certainly is the first: the reversed incoming ray misses the light wall.
    [[nodiscard]] bool certainly_begins() const {
        const I slope = -first_kappa_;
        const I& x = first_x_;
        return certainly_misses(sin(x) + slope * (x + pi<I>()), slope);
    }
    /// Whether the collision that is reached certainly is the last.
    [[nodiscard]] bool certainly_ends() const {
        const auto reflected = reflection();
        if (certainly_less(reflected.denominator, I(0))) {
            return true;
        }
        if (!certainly_positive(reflected.denominator)) {
            return false;
        }
        const I slope = outgoing();
        return certainly_at_most(I(1), slope) ||
               (certainly_at_most(I(0), slope) && certainly_misses(height(slope), slope));
    }
    /// Goes to the next collision; false, and nothing changes, if it is not certain that there is one, of the
    /// light mass, with the flight above the bridge.
    [[nodiscard]] bool advance() {
        if (!certainly_positive(reflection().denominator)) {
            return false;
        }
        const I slope = outgoing();
        const I c = height(slope);
        const I& r = masses_.r;
        if (!certainly_less(r, at_.s) || !certainly_less(r, c) || !certainly_less(slope, I(1))) {
            return false;
        }
        const auto least = flight::lowest_contact(low_end(c), low_end(slope));
        const auto greatest = flight::highest_contact(high_end(c), high_end(slope));
        if (!least || !greatest) {
            return false;
        }
        at_ = light_contact(hull(least->x, greatest->x), masses_.beta2);
        kappa_ = slope;
        return true;
    }

  private:
    /// |phidot| before the collision.
    [[nodiscard]] I speed() const { return sqrt(energy_ / (I(1) + sqr(kappa_ / masses_.root_r))); }
    [[nodiscard]] flight::LightReflection<I> reflection() const {
        return flight::reflect_at_light_wall(kappa_, at_.w, masses_.r);
    }

    /// The slope after the collision, from two opposite ends (L5 (b)).
    [[nodiscard]] I outgoing() const {
        const auto low = flight::reflect_at_light_wall(low_end(kappa_), high_end(at_.w), masses_.r);
        const auto high = flight::reflect_at_light_wall(high_end(kappa_), low_end(at_.w), masses_.r);
        return hull(low.numerator / low.denominator, high.numerator / high.denominator);
    }
    [[nodiscard]] I height(const I& slope) const { return at_.s + slope * (at_.x + pi<I>()); }

    [[nodiscard]] static bool certainly_misses(const I& c, const I& slope) {
        return !flight::lowest_contact(low_end(c), low_end(slope)).has_value();
    }

    Masses<I> masses_;
    LightContact<I> at_;
    I kappa_;
    I energy_;  ///< 1 + q kappa_0^2
    I first_x_;
    I first_f_;
    I first_kappa_;
};

}  // namespace dumbbell::adiabatic
