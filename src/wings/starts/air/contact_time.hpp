#pragma once

#include <optional>

#include "starts/air/jet.hpp"
#include "starts/air/state.hpp"

/// The time of a contact over a box of states, by the interval Newton method.
namespace dumbbell::starts {
namespace detail {

template <class S>
[[nodiscard]] State<Enclosure<S>> middle_of(const State<S>& s) {
    return mapped(s, [](const S& x) { return midpoint(range(x)); });
}

/// A better guess: Newton steps from the middle of the box, as many as the working precision needs.
template <class S, class I>
I polished_guess(const State<S>& s, flight::End end, I t) {
    int steps = 3;
    for (int bits = 53; bits < PrecisionScope::current(); bits *= 2) {
        ++steps;
    }
    const State<I> middle = middle_of(s);
    for (; steps > 0; --steps) {
        const Moment<I> now(middle, t);
        const I next = midpoint(t - now.clearance(end) / now.clearance_rate(end));
        if (!certainly_less(I(0), next)) {
            break;
        }
        t = next;
    }
    return t;
}

}  // namespace detail

/// An interval that contains, for each state of the box, exactly one time at which `end` reaches the floor
/// moving downwards. `guess` is where to look for it. Nothing if that cannot be proved: Newton's operator
/// N(T) = t - c(t)/c'(T), t in T, must map T into itself with c' < 0 on T.
template <class S>
[[nodiscard]] std::optional<Enclosure<S>> contact_times(const State<S>& s, flight::End end,
                                                        const Enclosure<S>& guess) {
    using I = Enclosure<S>;
    const I t = detail::polished_guess(s, end, guess);
    const Moment<S> now(s, S(t));
    const I value = range(now.clearance(end));
    I fall = -range(now.clearance_rate(end));
    if (!certainly_positive(fall)) {
        return std::nullopt;
    }
    I radius = magnitude(value / fall) * I(1.125) + magnitude(t) * I(0x1p-50);
    for (int attempt = 0; attempt < 6; ++attempt) {
        const I wide = hull(t - radius, t + radius);
        fall = -range(clearance_rate(s, end, S(wide)));
        if (!certainly_positive(fall)) {
            return std::nullopt;
        }
        I inner = t + value / fall;
        if (certainly_less(low_end(wide), inner) && certainly_less(inner, high_end(wide))) {
            fall = -range(clearance_rate(s, end, S(inner)));
            return intersection(inner, t + value / fall);
        }
        radius = magnitude(inner - t) * I(1.25) + radius * I(0.125);
    }
    return std::nullopt;
}

/// The contact's time as a value: in natural form the interval itself.
template <class I>
[[nodiscard]] std::optional<I> contact_time(const State<I>& s, flight::End end, const I& guess) {
    return contact_times(s, end, guess);
}

/// In mean value form also the centre's own contact and the gradient, by implicit differentiation of c(t(p),
/// p) = 0: the contact times of the box are roots with c' < 0 throughout, so t is differentiable.
template <class I>
[[nodiscard]] std::optional<Jet<I>> contact_time(const State<Jet<I>>& s, flight::End end, const I& guess) {
    const auto times = contact_times(s, end, guess);
    if (!times) {
        return std::nullopt;
    }
    const State<I> centre = mapped(s, [](const Jet<I>& x) { return I(x.centre()); });
    const auto centre_times = contact_times(centre, end, midpoint(*times));
    if (!centre_times || !certainly_at_most(low_end(*times), high_end(*centre_times)) ||
        !certainly_at_most(low_end(*centre_times), high_end(*times))) {
        return std::nullopt;
    }
    const Moment<Jet<I>> then(s, Jet<I>(*times));
    const Jet<I> at = then.clearance(end);
    return Jet<I>(intersection(*centre_times, *times), *times,
                  at.gradient() * (I(-1) / range(then.clearance_rate(end))), at.displacement());
}

}  // namespace dumbbell::starts
