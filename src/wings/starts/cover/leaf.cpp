#include "starts/cover/leaf.hpp"

#include <cmath>
#include <utility>

#include "starts/air/box_state.hpp"
#include "starts/air/first_flight.hpp"
#include "starts/walls/falling.hpp"

namespace dumbbell::starts {
namespace {

constexpr int most_exponent = 400;  ///< of a dyadic in the file, and of a window's end over its step

/// 2^(7 - bits).
template <class I>
I slack_unit(int bits) {
    return enclose<I>(Rational(1, Integer(1) << static_cast<unsigned>(bits - 7)));
}

/// A side of the box, wider by 2^-16 of its width and `unit` of its size on both ends.
template <class I>
I with_slack(const Rational& lo, const Rational& hi, const I& unit) {
    const I low = enclose<I>(lo);
    const I side = lo == hi ? low : hull(low, enclose<I>(hi));
    const I pad = (high_end(side) - low_end(side)) * I(0x1p-16) + magnitude(side) * unit;
    return hull(side - pad, side + pad);
}

template <class I>
State<I> wider_state(const Box& box, int bits) {
    const I unit = slack_unit<I>(bits);
    const auto side = [&](std::size_t i) { return with_slack<I>(box.lo[i], box.hi[i], unit); };
    return state_of(box, side, rho_of<I>(box), [&](const I& r) { return box.rho ? r : min(r, I(1)); });
}

std::pair<Rational, Rational> exact_ends(const Interval& x) { return {exact(x.lo()), exact(x.hi())}; }
std::pair<Rational, Rational> exact_ends(const BigInterval& x) { return {exact_lo(x), exact_hi(x)}; }

/// An interval of positive times around T with short dyadic ends, wider by `margin` steps of about a 16th of
/// its width.
template <class I>
std::optional<FirstContact> window(const I& times, bool heavy, int margin, int bits) {
    const double end = times.hi();
    const double size = width(times);
    if (!certainly_positive(times) || !(end < std::ldexp(1.0, most_exponent)) || !(end > 0x1p-300)) {
        return std::nullopt;
    }
    const int relative = std::ilogb(end) + std::max(13 - bits, 4 - most_exponent);
    const int exponent = std::max({size > 0 ? std::ilogb(size) : relative, relative, 4 - most_exponent}) - 4;
    const Rational step = exact(std::ldexp(1.0, exponent));
    const auto steps = [&](const Rational& time) {
        const Rational count = time / step;
        return Integer(numerator(count) / denominator(count));
    };
    const auto [lo, hi] = exact_ends(times);
    const Rational from = Rational(steps(lo) - margin) * step;
    const Rational until = Rational(steps(hi) + 1 + margin) * step;
    return from > 0 ? std::optional(FirstContact{heavy, from, until}) : std::nullopt;
}

/// The conditions of format-initial.md, section 3: the clearance of the mass is positive at the window's
/// beginning, negative at its end and falls in between, and it is the first contact.
template <class I>
bool certainly_in_window(const State<I>& s, flight::End end, const I& times) {
    return certainly_positive(clearance(s, end, low_end(times))) &&
           certainly_positive(-clearance(s, end, high_end(times))) &&
           certainly_positive(-clearance_rate(s, end, times)) &&
           certainly_first(s, {end}, times, spans_of_a_box);
}

/// A window in which the first contact certainly lies, as do all times of `event`.
template <class I>
std::optional<FirstContact> certain_window(const State<I>& s, Event<I>& event, int bits) {
    for (const int margin : {0, 1, 4}) {
        auto contact = window(*event.time, event.end == flight::End::heavy, margin, bits);
        if (!contact) {
            return std::nullopt;
        }
        const I times = hull(enclose<I>(contact->from), enclose<I>(contact->until));
        if (certainly_in_window(s, event.end, times)) {
            event.time = times;
            return contact;
        }
    }
    return std::nullopt;
}

template <class I>
Leaf judge_in(const Box& box, int bits) {
    const State<I> s = wider_state<I>(box, bits);
    Event<I> event = event_from_air(s, spans_of_a_box);
    if (event.next == Next::none) {
        return {0, 0};
    }
    std::optional<FirstContact> first;
    if (event.next == Next::contact) {
        first = certain_window(s, event, bits);
    }
    const auto bound = box.rho ? most_of_all(box) : most_collisions(s.body.r);
    if (!first) {
        return {certainly_positive(-s.yhatdot) ? 1 : 0, bound};
    }
    const LaterCount later = collisions_behind_first(s, event.end, *event.time);
    Leaf result{1 + later.least, bound, first};
    if (later.most) {
        result.most = std::min(bound.value_or(1 + *later.most), 1 + *later.most);
    }
    return result;
}

/// r = 1/q, with slack.
Interval inverse(const Rational& q) {
    return q == 1 ? Interval(1) : Interval(1) / with_slack(q, q, slack_unit<Interval>(double_bits));
}

}  // namespace

Leaf judge_falling(const Box& box) {
    return {1, box.rho ? most_of_all(box) : most_collisions(inverse(box.upper(Axis::ratio)))};
}

std::optional<long> most_of_all(const Box& box) {
    const Rational& q = box.upper(Axis::ratio);
    return box.rho ? most_collisions_of_body(q, *box.rho) : most_collisions(inverse(q), 1L << 53U);
}

Leaf judge(const Box& box, int bits) {
    Leaf leaf = judge_in<Interval>(box, double_bits);
    if (leaf.most == leaf.least || bits == double_bits) {
        return leaf;
    }
    const PrecisionScope scope(bits);
    return judge_in<BigInterval>(box, bits);
}

}  // namespace dumbbell::starts
