#include "starts/cover/spread.hpp"

#include <cmath>
#include <utility>

#include "number/elementary.hpp"
#include "starts/air/box_state.hpp"
#include "starts/air/first_flight.hpp"
#include "starts/air/jet.hpp"

namespace dumbbell::starts {
namespace {

/// A number that depends on the five quantities of a start, with its derivatives, in doubles: no bound of
/// anything, for guesses only.
struct Tangent {
    double value;
    Gradient<double> gradient;

    explicit Tangent(double constant) : Tangent(constant, Gradient<double>::Zero()) {}
    Tangent(double at, Gradient<double> derivatives) : value(at), gradient(std::move(derivatives)) {}

    friend Tangent operator-(const Tangent& a) { return {-a.value, -a.gradient}; }
    friend Tangent operator+(const Tangent& a, const Tangent& b) {
        return {a.value + b.value, a.gradient + b.gradient};
    }
    friend Tangent operator-(const Tangent& a, const Tangent& b) {
        return {a.value - b.value, a.gradient - b.gradient};
    }
    friend Tangent operator*(const Tangent& a, const Tangent& b) {
        return {a.value * b.value, a.gradient * b.value + b.gradient * a.value};
    }
    friend Tangent operator/(const Tangent& a, const Tangent& b) {
        const double quotient = a.value / b.value;
        return {quotient, (a.gradient - b.gradient * quotient) / b.value};
    }
    friend Tangent sqr(const Tangent& a) { return a * a; }
    /// By the program's own sine, so that guesses are the same on every machine.
    friend SinCos<Tangent> sin_cos(const Tangent& a) {
        const SinCos<Interval> at = dumbbell::sin_cos(Interval(a.value));
        const double sine = approximate(at.sin);
        const double cosine = approximate(at.cos);
        return {{sine, a.gradient * cosine}, {cosine, a.gradient * -sine}};
    }
};

State<Tangent> centre_of(const Box& box) {
    const auto side = [&](std::size_t i) {
        const Rational& lo = box.lo[i];
        const Rational centre = lo == box.hi[i] ? lo : (lo + box.hi[i]) / 2;
        return Tangent(centre.convert_to<double>(), Gradient<double>::Unit(static_cast<int>(i)));
    };
    return state_of(box, side, Tangent(box.rho.value_or(1).convert_to<double>()));
}

/// The state itself, where an enclosure is asked for.
State<Interval> point(const State<Tangent>& s) {
    return mapped(s, [](const Tangent& x) { return Interval(x.value); });
}

/// After a contact at about this time: the derivatives of the time are those of a root of the clearance.
State<Tangent> after_contact(const State<Tangent>& s, flight::End end, double time) {
    const Moment<Tangent> then(s, Tangent(time));
    return bounce(s, end, {time, then.clearance(end).gradient / -then.clearance_rate(end).value}).after;
}

/// The first contact, if it seems that there is one and that it is no corner, where no orbit goes on.
Event<Interval> first_contact(const State<Tangent>& s) {
    const auto guess =
        guess_first_contact(s.phi.value, s.yhat.value, s.phidot.value, s.yhatdot.value, s.body.rho.value);
    if (!guess) {
        return {};
    }
    const State<Interval> at = point(s);
    const Interval time = detail::polished_guess(at, guess->end, Interval(guess->time));
    const bool corner = std::abs(approximate(clearance(at, other(guess->end), time))) < 1e-9;
    return corner ? Event<Interval>{} : Event<Interval>{Next::contact, guess->end, time};
}

/// The orbit of the centre after so many collisions, or as far as it can be followed.
State<Tangent> follow_centre(const Box& box, long collisions) {
    State<Tangent> s = centre_of(box);
    Event<Interval> event = first_contact(s);
    for (long done = 0; done < collisions && event.next == Next::contact; ++done) {
        s = after_contact(s, event.end, approximate(*event.time));
        event = event_after_contact(point(s), event.end);
    }
    return s;
}

}  // namespace

std::array<double, axis_count> spreads(const Box& box, long shared) {
    const State<Tangent> s = follow_centre(box, shared);
    const double r = s.body.r.value;
    const double speed = std::hypot(s.phidot.value, s.yhatdot.value / std::sqrt(r));
    std::array<double, axis_count> spread{};
    for (std::size_t i = 0; i < axis_count; ++i) {
        if (box.lo[i] == box.hi[i]) {
            continue;
        }
        const auto change = [&](const Tangent& x) { return std::abs(x.gradient[static_cast<int>(i)]); };
        const double sum =
            change(s.phi) + change(s.yhat) + (change(s.phidot) + change(s.yhatdot) / r) / speed;
        spread[i] = (box.hi[i] - box.lo[i]).convert_to<double>() * (std::isfinite(sum) ? sum : 1);
    }
    return spread;
}

}  // namespace dumbbell::starts
