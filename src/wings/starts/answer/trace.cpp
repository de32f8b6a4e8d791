#include "starts/answer/trace.hpp"

#include <mpfr.h>

#include <algorithm>
#include <string>

#include "starts/air/box_state.hpp"
#include "starts/air/exact_event.hpp"
#include "starts/walls/falling.hpp"
#include "starts/walls/find_obstacle.hpp"
#include "starts/walls/follow.hpp"

namespace dumbbell::starts {
namespace {

constexpr int shown_digits = 12;

std::string decimal(arf_srcptr x, const char* format, int digits) {
    mpfr_t same;
    mpfr_init2(same,
               std::max(static_cast<mpfr_prec_t>(arf_bits(x)), static_cast<mpfr_prec_t>(MPFR_PREC_MIN)));
    arf_get_mpfr(same, x, MPFR_RNDN);
    char* text = nullptr;
    mpfr_asprintf(&text, format, digits, same);
    mpfr_clear(same);
    std::string result(text);
    mpfr_free_str(text);
    return result;
}

/// The number that `text` is, at the working precision.
BigInterval enclose_text(const std::string& text) {
    BigInterval result;
    mpfr_t bound;
    mpfr_init2(bound, PrecisionScope::current());
    mpfr_set_str(bound, text.c_str(), 10, MPFR_RNDD);
    arf_set_mpfr(result.lower(), bound);
    mpfr_set_str(bound, text.c_str(), 10, MPFR_RNDU);
    arf_set_mpfr(result.upper(), bound);
    mpfr_clear(bound);
    return result;
}

/// The greatest |x - y|, x in X, y in Y.
BigInterval greatest_distance(const BigInterval& x, const BigInterval& y) {
    const BigInterval distance = x - y;
    return high_end(max(distance, -distance));
}

/// An enclosure with `digits` decimal digits: `text` is a decimal and a radius that together cover it, `lo`
/// and `hi` cover it too.
TracedValue traced_value(const BigInterval& x, int digits) {
    const Interval outward(x.lo(), x.hi());
    const BigInterval middle = midpoint(x);
    const std::string value = decimal(middle.lower(), "%.*RNg", digits);
    const BigInterval distance = greatest_distance(x, enclose_text(value));
    return {outward, value + "+-" + decimal(distance.upper(), "%.*RUe", 1),
            decimal(x.lower(), "%.*RDg", digits), decimal(x.upper(), "%.*RUg", digits)};
}

TracedValue traced_value(const Interval& x, int digits) {
    const PrecisionScope scope(128);
    return traced_value(BigInterval(x.lo(), x.hi()), digits);
}

/// |N.v| over |v| |N| in the kinetic metric, before the collision.
template <class S>
Enclosure<S> grazing_sine(const Bounce<S>& b) {
    using I = Enclosure<S>;
    const State<I> s = ranges_of(b.before);
    const I c = range(sin_cos(b.before.phi).cos);
    const I speed = sqrt(sqr(s.phidot) + sqr(s.yhatdot) / s.body.r);
    const I normal = s.body.leveraged(b.end, s.body.resistance(b.end, c));  // |N|^2
    return -rise_of(s, b.end, c) / (speed * sqrt(normal));
}

template <class S>
flight::Collision<TracedValue> shown(const Bounce<S>& b, int digits) {
    const auto value = [&](const Enclosure<S>& x) { return traced_value(x, digits); };
    const auto physical = [&](const S& hat) { return value(range(hat / (S(1) + b.before.body.rho))); };
    return {b.end == flight::End::heavy,   value(range(b.after.time)),   value(range(b.after.phi)),
            physical(b.after.yhat),        physical(b.before.yhatdot),   physical(b.after.yhatdot),
            value(range(b.before.phidot)), value(range(b.after.phidot)), value(grazing_sine(b))};
}

template <class S>
double greatest_width(const State<S>& s) {
    const S scale = S(1) + s.body.rho;
    return std::max({width(range(s.phi)), width(range(s.phidot)), width(range(s.yhat / scale)),
                     width(range(s.yhatdot / scale))});
}

/// The number of collisions, if it is certain: of orbits that cannot be followed to the end, perhaps from
/// their first contact on.
template <class S, class I>
LaterCount count(const Followed<S>& followed, const State<I>& start, const Interrupted& interrupted) {
    if (followed.total.exact() || followed.bounces.empty() || followed.interrupted) {
        return followed.total;
    }
    const auto& first = followed.bounces.front();
    const LaterCount later = collisions_behind_first(start, first.end, range(first.before.time), interrupted);
    return later.exact() ? LaterCount{1 + later.least, 1 + later.least} : followed.total;
}

template <class S, class I>
Trace described(const Followed<S>& followed, const State<I>& start, int bits, int digits,
                const Interrupted& interrupted) {
    const LaterCount total = count(followed, start, interrupted);
    Trace result{.collisions = {}, .least = total.least, .most = total.most, .bits = bits, .widths = {}};
    for (const auto& b : followed.bounces) {
        if (interrupted()) {
            result.most.reset();
            return result;
        }
        result.collisions.push_back(shown(b, digits));
    }
    if (!total.exact() && !interrupted()) {
        result.obstacle = find_obstacle(followed, start);
    }
    return result;
}

template <class I>
Trace trace_in(const Box& box, int bits, int digits, Observer& observer, const Interrupted& interrupted) {
    const State<I> start = natural_state<I>(box);
    const BoxJets<I> jets(box);
    const auto correlated = follow(jets.state(), most_first_spans, observer, interrupted);
    Trace result = described(correlated, start, bits, digits, interrupted);
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

Trace trace(const Box& box, int digits, Observer& observer, const Interrupted& interrupted) {
    const int bits = working_bits(digits);
    const auto event = exact_event(box);
    if (event && event->kind == Obstacle::graze) {
        return {.collisions = {}, .least = 0, .most = 0, .bits = bits, .widths = {}};
    }
    if (digits == 0) {
        return trace_in<Interval>(box, bits, shown_digits, observer, interrupted);
    }
    const PrecisionScope scope(bits);
    return trace_in<BigInterval>(box, bits, digits, observer, interrupted);
}

}  // namespace dumbbell::starts
