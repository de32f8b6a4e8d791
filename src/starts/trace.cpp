#include "starts/trace.hpp"

#include <algorithm>

#include "starts/exact_event.hpp"
#include "starts/falling.hpp"
#include "starts/find_obstacle.hpp"
#include "starts/follow.hpp"
#include "starts/initial_state.hpp"
#include "starts/traced_value.hpp"

namespace dumbbell::starts {
namespace {

constexpr int shown_digits = 12;

/// |N.v| over |v| |N| in the kinetic metric, before the collision.
template <class S>
Enclosure<S> grazing_sine(const Bounce<S>& b) {
    using I = Enclosure<S>;
    const I& r = range(b.before.r);
    const I& spin = range(b.before.phidot);
    const I& climb = range(b.before.yhatdot);
    const I c = range(sin_cos(b.before.phi).cos);
    const I speed = sqrt(sqr(spin) + sqr(climb) / r);
    return b.mass == Mass::light ? -(climb + c * spin) / (speed * sqrt(sqr(c) + r))
                                 : -(climb - r * c * spin) / (speed * sqrt(r * (I(1) + r * sqr(c))));
}

template <class S>
flight::Collision<TracedValue> shown(const Bounce<S>& b, int digits) {
    const auto value = [&](const Enclosure<S>& x) { return traced_value(x, digits); };
    const auto physical = [&](const S& hat) { return value(range(hat / (S(1) + b.before.r))); };
    return {b.mass == Mass::heavy,         value(range(b.after.time)),   value(range(b.after.phi)),
            physical(b.after.yhat),        physical(b.before.yhatdot),   physical(b.after.yhatdot),
            value(range(b.before.phidot)), value(range(b.after.phidot)), value(grazing_sine(b))};
}

template <class S>
double greatest_width(const State<S>& s) {
    const S scale = S(1) + s.r;
    return std::max({width(range(s.phi)), width(range(s.phidot)), width(range(s.yhat / scale)),
                     width(range(s.yhatdot / scale))});
}

/// The number of collisions, if it is certain: of orbits that cannot be followed to the end, perhaps from
/// their first contact on.
template <class S, class I>
LaterCount count(const Followed<S>& followed, const State<I>& start) {
    if (followed.total.exact() || followed.bounces.empty() || followed.interrupted) {
        return followed.total;
    }
    const auto& first = followed.bounces.front();
    const LaterCount later = collisions_behind_first(start, first.mass, range(first.before.time));
    return later.exact() ? LaterCount{1 + later.least, 1 + later.least} : followed.total;
}

template <class S, class I>
Trace described(const Followed<S>& followed, const State<I>& start, int bits, int digits) {
    const LaterCount total = count(followed, start);
    Trace result{.collisions = {}, .least = total.least, .most = total.most, .bits = bits, .widths = {}};
    for (const auto& b : followed.bounces) {
        result.collisions.push_back(shown(b, digits));
    }
    if (!total.exact() && !followed.interrupted) {
        result.obstacle = find_obstacle(followed, start);
    }
    return result;
}

template <class I>
Trace trace_in(const InitialBox& box, int bits, int digits, Observer& observer,
               const Interrupted& interrupted) {
    const State<I> start = natural_state<I>(box);
    const BoxJets<I> jets(box);
    const auto correlated = follow(jets.state(), most_first_spans, observer, interrupted);
    Trace result = described(correlated, start, bits, digits);
    if (!box.is_point() && !correlated.bounces.empty()) {
        const auto natural = follow(start, most_first_spans, nobody, interrupted);
        const std::size_t last = correlated.bounces.size() - 1;
        result.widths = TracedWidths{{}, greatest_width(correlated.bounces[last].after)};
        if (natural.bounces.size() > last) {
            result.widths->natural = greatest_width(natural.bounces[last].after);
        }
    }
    return result;
}

}  // namespace

int working_bits(int digits) {
    // log2(10) bits per digit, and as many again up to 128 for what the collisions lose.
    return digits == 0 ? double_bits : static_cast<int>(digits * 3.33) + 1 + std::min(128, 64 + digits * 2);
}

Trace trace(const InitialBox& box, int digits, Observer& observer, const Interrupted& interrupted) {
    const int bits = working_bits(digits);
    const auto event = exact_event(box);
    if (event && event->kind == ExactKind::graze) {
        return {.collisions = {}, .least = 0, .most = 0, .bits = bits, .widths = {}};
    }
    if (digits == 0) {
        return trace_in<Interval>(box, bits, shown_digits, observer, interrupted);
    }
    const PrecisionScope scope(bits);
    return trace_in<BigInterval>(box, bits, digits, observer, interrupted);
}

}  // namespace dumbbell::starts
