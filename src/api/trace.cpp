#include "dumbbell/trace.hpp"

#include "api/exact_ratio.hpp"
#include "api/translate.hpp"
#include "starts/argument.hpp"
#include "starts/initial_state.hpp"
#include "starts/trace.hpp"

namespace dumbbell::api {

using starts::InitialAxis;

namespace {

constexpr int most_digits = 100'000;

starts::InitialBox box_of(const MassRatio& ratio, const InitialCondition& start) {
    starts::InitialBox box;
    const auto set = [&](InitialAxis axis, std::pair<Rational, Rational> ends) {
        box.lo[static_cast<std::size_t>(axis)] = std::move(ends.first);
        box.hi[static_cast<std::size_t>(axis)] = std::move(ends.second);
    };
    set(InitialAxis::phi, starts::parse_quantity("phi", start.phi));
    set(InitialAxis::phidot, starts::parse_quantity("phidot", start.phidot));
    set(InitialAxis::y, starts::parse_quantity("y", start.y));
    set(InitialAxis::ydot, starts::parse_quantity("ydot", start.ydot));
    set(InitialAxis::ratio, {exact_ratio(ratio.lo()), exact_ratio(ratio.hi())});
    require_in_play(box);
    return box;
}

Interval given(const starts::TracedValue& x) { return {x.outward.lo(), x.outward.hi()}; }

Collision given(const dumbbell::flight::Collision<starts::TracedValue>& c) {
    return {.heavy = c.heavy,
            .time = given(c.time),
            .phi = given(c.phi),
            .y = given(c.y),
            .phidot_before = given(c.phidot_before),
            .phidot_after = given(c.phidot_after),
            .ydot_before = given(c.ydot_before),
            .ydot_after = given(c.ydot_after),
            .grazing_sine = given(c.grazing_sine)};
}

}  // namespace

Trace trace(const MassRatio& ratio, const InitialCondition& start, int digits) {
    return guarded([&] {
        if (digits < 0 || digits > most_digits) {
            throw dumbbell::InputError("digits is out of range: give 0 (double precision) to 100000");
        }
        const dumbbell::starts::Trace traced = dumbbell::starts::trace(box_of(ratio, start), digits);
        Trace result{.least = traced.least, .most = traced.most, .collisions = {}};
        for (const auto& collision : traced.collisions) {
            result.collisions.push_back(given(collision));
        }
        return result;
    });
}

}  // namespace dumbbell::api
