#include "prove/initial_leaf.hpp"

#include <cmath>
#include <utility>

#include "model/falling.hpp"
#include "model/follow.hpp"
#include "prove/initial_state.hpp"

namespace dumbbell {
namespace {

constexpr long most_spans = 1024;

/// A side of the box, wider by 2^-16 of its width and 2^-46 of its size on both ends.
Interval with_slack(const Rational& lo, const Rational& hi) {
    const Interval side = hull(enclose<Interval>(lo), enclose<Interval>(hi));
    const double pad = (side.hi() - side.lo()) * 0x1p-16 + magnitude(side).hi() * 0x1p-46;
    return side + Interval(-pad, pad);
}

State<Interval> wider_state(const InitialBox& box) {
    const auto side = [&](std::size_t i) { return with_slack(box.lo[i], box.hi[i]); };
    State<Interval> s = state_of(side(0), side(1), side(2), side(3), side(4));
    s.r = min(s.r, Interval(1));
    return s;
}

/// An interval of times around T with short dyadic ends, wider by `margin` steps of about a 16th of its
/// width.
std::optional<FirstContact> window(const Interval& times, bool heavy, int margin) {
    const double size = std::max(times.hi() - times.lo(), times.hi() * 0x1p-40);
    const double step = std::ldexp(1.0, std::ilogb(size) - 4);
    const double from = (std::floor(times.lo() / step) - margin) * step;
    const double until = (std::ceil(times.hi() / step) + margin) * step;
    if (!(from > 0) || !std::isfinite(until)) {
        return std::nullopt;
    }
    return FirstContact{heavy, exact(from), exact(until)};
}

/// The conditions of format-initial.md, section 4: the clearance of the mass is positive at the window's
/// beginning, negative at its end and falls in between, and it is the first contact.
bool certainly_in_window(const State<Interval>& s, Mass mass, const Interval& times) {
    return certainly_positive(clearance(s, mass, low_end(times))) &&
           certainly_positive(-clearance(s, mass, high_end(times))) &&
           certainly_positive(-clearance_rate(s, mass, times)) &&
           certainly_first(s, {mass}, times, most_spans);
}

/// A window in which the first contact certainly lies, as do all times of `event`.
std::optional<FirstContact> certain_window(const State<Interval>& s, Event<Interval>& event) {
    for (const int margin : {0, 1, 4}) {
        const auto contact = window(*event.time, event.mass == Mass::heavy, margin);
        if (!contact) {
            return std::nullopt;
        }
        const Interval times = hull(enclose<Interval>(contact->from), enclose<Interval>(contact->until));
        if (certainly_in_window(s, event.mass, times)) {
            event.time = times;
            return contact;
        }
    }
    return std::nullopt;
}

}  // namespace

InitialLeaf judge_initial(const InitialBox& box) {
    const State<Interval> s = wider_state(box);
    Event<Interval> event = event_from_air(s, most_spans);
    std::optional<FirstContact> first;
    if (event.next == Next::contact) {
        first = certain_window(s, event);
        if (!first) {
            event = {};
        }
    }
    LaterCount closed;
    if (first && certainly_positive(-s.yhatdot)) {
        closed = collisions_behind_first(s, event.mass, *event.time);
        if (closed.exact()) {
            return {1 + closed.least, 1 + closed.least, first};
        }
    }
    const auto followed = follow_from(s, event, {.most_spans = most_spans, .stop_when_counted = true});
    return {followed.total.least, followed.total.most, first};
}

}  // namespace dumbbell
