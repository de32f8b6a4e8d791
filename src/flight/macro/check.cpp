#include "flight/macro/check.hpp"

namespace dumbbell::flight::macro {
namespace {

/// An upper bound of |sine - sin x| and |cosine - cos x| on [-1, 1]: Z = cosine + i sine solves Z' = i x' Z
/// but for a residual, and starts near exp(i x(0)).
Ball trigonometric_error(const Orbit& orbit) {
    const slong all = 2 * orbit.x.raw()->length;
    const Series speed = orbit.x.derivative();
    Ball sine, cosine;
    const Ball centre = orbit.x[0];
    arb_sin_cos(sine.raw(), cosine.raw(), centre.raw(), bits());
    const Ball start = greatest_size(orbit.sine[0] - sine) + greatest_size(orbit.cosine[0] - cosine);
    const Ball residual = size_from(orbit.sine.derivative() - speed.times(orbit.cosine, all), 0) +
                          size_from(orbit.cosine.derivative() + speed.times(orbit.sine, all), 0);
    return end(start + residual, true);
}

/// x with a radius in place of an error of at most this size.
Series widened(Series p, const Ball& error) {
    Ball first = p[0];
    arb_add_error(first.raw(), error.raw());
    p.set(0, first);
    return p;
}

/// All of a polynomial's values on [-1, 1] have this sign.
bool certainly_signed(const Series& p, bool above) {
    const Ball first = above ? p[0] : Ball(-1) * p[0];
    return positive(first - size_from(p, 1));
}

}  // namespace

Excess excess(const Orbit& orbit, const Task& task, slong length) {
    const Ball collisions = whole(task.collisions);
    const Ball eta = Ball(2) / collisions;
    const Ball half_length = collisions * Ball(0.5);
    const Series next_x = orbit.x.shifted(eta);
    const Series next_kappa = orbit.kappa.shifted(eta);
    const Series w = orbit.cosine.shifted(eta);
    const Series climb = (orbit.sine.shifted(eta) - orbit.sine).times(half_length);
    const Series turn = (next_kappa - orbit.kappa).times(half_length);
    const Series reach = (orbit.x + next_x).plus(pi());
    const Series push = orbit.kappa.times(next_kappa, length).plus(task.r).times(half_length);
    return {climb - orbit.kappa.times(reach, length).times(half_length),
            turn.times(w.times(w, length).plus(Ball(-1) * task.r), length) -
                w.times(push, length).times(Ball(2))};
}

bool is_macro_step(BoundSide side, Orbit orbit, const Task& task) {
    const bool above = side == BoundSide::upper;
    const Ball error = trigonometric_error(orbit);
    orbit.sine = widened(std::move(orbit.sine), error);
    orbit.cosine = widened(std::move(orbit.cosine), error);
    const Excess found = excess(orbit, task, 4 * task.terms);
    if (!certainly_signed(found.height, above) || !certainly_signed(found.slope, above)) return false;

    const Ball half_length = whole(task.collisions) * Ball(0.5);
    const Ball least_cosine = end(orbit.cosine[0] - size_from(orbit.cosine, 1), false);
    const Ball steepest = end(orbit.kappa[0] + size_from(orbit.kappa, 1), true);
    const Ball room = least_cosine - Ball(2) * steepest;
    const Ball farthest = size_from(orbit.x, 0);
    const bool inside = positive(least_cosine) && positive(room) && positive(least_cosine * room - task.r) &&
                        positive(pi() * Ball(0.5) - farthest);
    const Ball start = orbit.kappa.at(Ball(-1));
    const bool climbs =  // L42 (c)
        above || (positive(orbit.x.at(Ball(-1))) &&
                  positive(half_length * start * pi() * Ball(0.5) - size_from(found.height, 0)) &&
                  positive(half_length * Ball(2) * task.r * least_cosine - size_from(found.slope, 0)));
    return inside && climbs;
}

}  // namespace dumbbell::flight::macro
