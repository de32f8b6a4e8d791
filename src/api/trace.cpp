#include "dumbbell/trace.hpp"

#include "api/exact_ratio.hpp"
#include "api/translate.hpp"
#include "starts/given_start.hpp"
#include "starts/trace.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

namespace {

constexpr int most_digits = 100'000;

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
        const dumbbell::starts::GivenStart read = dumbbell::starts::read_start(
            {.phi = start.phi, .phidot = start.phidot, .y = start.y, .ydot = start.ydot},
            exact_ratio(ratio.lo()), exact_ratio(ratio.hi()), "", dumbbell::starts::bits_of_bounds(digits));
        const dumbbell::starts::Trace traced = dumbbell::starts::trace(read.box, digits);
        Trace result{.least = traced.least, .most = traced.most, .collisions = {}};
        for (const auto& collision : traced.collisions) {
            result.collisions.push_back(given(collision));
        }
        return result;
    });
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
