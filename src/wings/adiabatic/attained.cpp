#include "adiabatic/box.hpp"
#include "adiabatic/orbit.hpp"
#include "adiabatic/search.hpp"
#include "number/decimal.hpp"

namespace dumbbell::adiabatic {
namespace {

constexpr double smaller = 1 - 0x1p-18;
constexpr int value_digits = 6;

/// The error's lower bound in the claim's unit.
Interval low(const Interval& error, const Interval& unit) { return low_end(abs(error) / unit); }

std::optional<Interval> bounce_error(const Search& search, const Interval& u, const Interval& s,
                                     const Interval& delta) {
    const Bounce<Interval> bounce(u, s, Masses<Interval>(delta));
    const Interval k = delta_power(delta, search.of.exponent);
    const Interval square = sqr(delta);
    Orbit<Interval> orbit(u, s, delta);
    if (!orbit.advance()) {
        return std::nullopt;
    }
    if (!search.height_error) {
        return low(bounce.speed_error(), square / sqr(k));
    }
    const auto next = next_contact(bounce);
    if (!next || next->none) {
        return std::nullopt;
    }
    return low_end(height_error(bounce, *next) / (Interval(2) * square / k));
}

std::optional<Interval> orbit_error(const Search& search, const Sample& sample, const Interval& u,
                                    const Interval& s, const Interval& delta, const Interval& margin) {
    Orbit<Interval> orbit(u, s, delta);
    const bool run = search.of.claim == Claim::run;
    if (!run && !orbit.certainly_begins()) {
        return std::nullopt;
    }
    for (long n = 0; n < sample.n; ++n) {
        if (ends_early(n, search.interrupted) || !orbit.advance() ||
            (run && !certainly_at_most(margin, orbit.angle()))) {
            return std::nullopt;
        }
    }
    if (run) {
        return low(orbit.change(), delta);
    }
    if (!orbit.certainly_ends() || !certainly_at_most(margin, orbit.angle())) {
        return std::nullopt;
    }
    return low(orbit.change_behind(), sqrt(delta));
}

}  // namespace

std::optional<State> attained(const Search& search, const Sample& sample) {
    const auto& [lo, hi] = search.of.delta;
    const Rational exact_delta = lo + (hi - lo) * exact(sample.share);
    const Interval delta = enclose<Interval>(exact_delta);
    const Interval u(sample.u);
    const Interval s(sample.s);
    const Sides sides(search.of);
    const Masses<Interval> masses(delta);
    const Interval margin = sides.margin(masses);
    if (!certainly_positive(delta) || !certainly_at_most(margin, u) ||
        !sides.certainly_of_height(u, masses)) {
        return std::nullopt;
    }
    const auto error = search.of.claim == Claim::bounce ? bounce_error(search, u, s, delta)
                                                        : orbit_error(search, sample, u, s, delta, margin);
    if (!error || !certainly_positive(*error)) {
        return std::nullopt;
    }
    const Rational value = exact(cut_down(exact(error->lo()) * exact(smaller), value_digits));
    return State{exact(sample.u), exact(sample.s), exact_delta, sample.n, value};
}

}  // namespace dumbbell::adiabatic
