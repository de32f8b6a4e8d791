#include "flight/macro/check.hpp"

#include <algorithm>
#include <cmath>

#include "base/ended_early.hpp"

namespace dumbbell::flight::macro {
namespace {

/// p with a radius in place of an error of at most this size.
Series widened(Series p, const Ball& error) {
    Ball first = p[0];
    arb_add_error(first.raw(), error.raw());
    p.set(0, first);
    return p;
}

/// A product on [-1, 1]: its terms of degree < `length`, and in the radius of the first one what is cut off.
Series product(const Series& a, const Series& b, slong length) {
    mag_t tail, cut, size;  // tail: the sizes of b's terms from degree length - i on
    mag_init(tail);
    mag_init(cut);
    mag_init(size);
    slong j = b.raw()->length;
    for (slong i = 0; i < a.raw()->length; ++i) {
        while (j > 0 && j > length - i) {
            arb_get_mag(size, b.raw()->coeffs + --j);
            mag_add(tail, tail, size);
        }
        arb_get_mag(size, a.raw()->coeffs + i);
        mag_addmul(cut, size, tail);
    }
    Ball left_out;
    arf_set_mag(arb_midref(left_out.raw()), cut);
    mag_clear(tail);
    mag_clear(cut);
    mag_clear(size);
    return widened(a.times(b, length), left_out);
}

/// Z = cosine + i sine solves Z' = i x' Z but for a residual, and starts near exp(i x(0)).
SineError sine_error(const Orbit& orbit) {
    const slong length = orbit.x.raw()->length;
    const Series speed = orbit.x.derivative();
    Ball sine, cosine;
    const Ball centre = orbit.x[0];
    arb_sin_cos(sine.raw(), cosine.raw(), centre.raw(), bits());
    const Ball start = greatest_size(orbit.sine[0] - sine) + greatest_size(orbit.cosine[0] - cosine);
    const Ball residual = size_from(orbit.sine.derivative() - product(speed, orbit.cosine, length), 0) +
                          size_from(orbit.cosine.derivative() + product(speed, orbit.sine, length), 0);
    const Ball value = end(start + residual, true);
    return {value, end(residual + size_from(speed, 0) * value, true)};
}

/// (p(s + eta) - p(s))/eta on [-1, 1 - eta], eta <= 1, by Taylor's formula.
class Slope {
  public:
    /// Of polynomials with at most so many terms.
    Slope(Ball eta, slong terms, const Interrupted& interrupted)
        : eta_(std::move(eta)), interrupted_(interrupted) {
        const auto worth = static_cast<double>(bits() + terms) / std::max(1., -std::log2(approximate(eta_)));
        kept_ = std::clamp(static_cast<slong>(worth) + 2, 2L, terms);
        Ball power(1);
        for (slong j = 1; j <= kept_; ++j) {
            weights_.set(j - 1, power = j == 1 ? power : power * eta_ / whole(j));
        }
        left_out_ = power_of_two(terms);
        for (slong j = 0; j < kept_; ++j) {
            left_out_ = left_out_ * eta_;
        }
    }

    /// The sum of p^(j)(s)/j! eta^(j - 1) over j <= kept. As (m over j) <= 2^terms, the rest is at most
    /// eta^kept 2^terms times the sum of p's coefficients.
    [[nodiscard]] Series of(const Series& p) const {
        Series scaled,
            sum;  // a_m m!; in the sum, term i is that of a_(i + j) (i + j)!/j! eta^(j - 1), over i!
        arb_poly_inv_borel_transform(scaled.raw(), p.raw(), bits());
        const slong terms = scaled.raw()->length;
        for (slong i = terms - 2; i >= 0; --i) {
            go_on(interrupted_);
            Ball term;
            arb_dot(term.raw(), nullptr, 0, scaled.raw()->coeffs + i + 1, 1, weights_.raw()->coeffs, 1,
                    std::min(kept_, terms - 1 - i), bits());
            sum.set(i, term);
        }
        arb_poly_borel_transform(sum.raw(), sum.raw(), bits());
        return widened(std::move(sum), left_out_ * size_from(p, 0));
    }

  private:
    Ball eta_, left_out_;
    const Interrupted& interrupted_;
    slong kept_ = 0;
    Series weights_;  ///< eta^(j - 1)/j! for j from 1 to kept
};

/// All of a polynomial's values on [-1, 1] have this sign.
bool certainly_signed(const Series& p, bool above) {
    const Ball first = above ? p[0] : Ball(-1) * p[0];
    return positive(first - size_from(p, 1));
}

}  // namespace

Excess excess(const Orbit& orbit, const Task& task, slong length, const SineError& error) {
    const Ball collisions = whole(task.collisions);
    const Ball eta = Ball(2) / collisions;
    const Ball half_length = collisions * Ball(0.5);
    const Slope slope(eta,
                      std::max({orbit.x.raw()->length, orbit.kappa.raw()->length, orbit.sine.raw()->length,
                                orbit.cosine.raw()->length, 2L}),
                      task.interrupted);
    const Series climb = widened(slope.of(orbit.sine), error.slope);
    const Series turn = slope.of(orbit.kappa);
    const Series next_x = orbit.x + slope.of(orbit.x).times(eta);
    const Series next_kappa = orbit.kappa + turn.times(eta);
    const Series w = widened(orbit.cosine + slope.of(orbit.cosine).times(eta), error.value);
    const Series reach = (orbit.x + next_x).plus(pi());
    const Series push = product(orbit.kappa, next_kappa, length).plus(task.r).times(half_length);
    return {climb - product(orbit.kappa, reach, length).times(half_length),
            product(turn, product(w, w, length).plus(Ball(-1) * task.r), length) -
                product(w, push, length).times(Ball(2))};
}

bool is_macro_step(BoundSide side, const Orbit& orbit, const Task& task) {
    const bool above = side == BoundSide::upper;
    if (task.collisions < 2) {
        return false;
    }
    const SineError error = sine_error(orbit);
    const Excess found = excess(orbit, task, task.terms, error);
    if (!certainly_signed(found.height, above) || !certainly_signed(found.slope, above)) return false;

    const Ball half_length = whole(task.collisions) * Ball(0.5);
    const Ball least_cosine = end(orbit.cosine[0] - size_from(orbit.cosine, 1) - error.value, false);
    const Ball steepest = end(orbit.kappa[0] + size_from(orbit.kappa, 1), true);
    const Ball room = least_cosine - Ball(2) * steepest;
    // The first term by itself: the sizes of all are added with 30 bits, and x comes close to pi/2.
    const Ball farthest = greatest_size(orbit.x[0]) + size_from(orbit.x, 1);
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
