#include "dumbbell/trace.hpp"

#include "api/start.hpp"
#include "api/translate.hpp"
#include "starts/answer/trace.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

namespace {

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

Trace trace(const MassRatio& ratio, const InitialCondition& start, int digits, const Stopped& stopped) {
    return guarded([&] {
        const int bits = dumbbell::starts::bits_of_bounds(checked_digits(digits));
        const dumbbell::starts::Trace traced =
            dumbbell::starts::trace(start_of(ratio, start, bits), digits, nobody, stopped ? stopped : never);
        Trace result{.least = traced.least, .most = traced.most, .collisions = {}};
        for (const auto& collision : traced.collisions) {
            result.collisions.push_back(given(collision));
        }
        return result;
    });
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
