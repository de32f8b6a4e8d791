#include "verify/macro/orbit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "verify/number/big.hpp"
#include "verify/number/interval.hpp"

namespace dumbbell_verify {
namespace {

double to_double(const mpz_class& x, long places) {
    long exponent = 0;
    const double mantissa = mpz_get_d_2exp(&exponent, x.get_mpz_t());
    return std::ldexp(mantissa, static_cast<int>(exponent - places));
}
/// a x, for an a that is not exact anyway.
mpz_class times(double a, const mpz_class& x) {
    int exponent = 0;
    const double mantissa = std::frexp(a, &exponent);
    return shifted(x * mpz_class(std::ldexp(mantissa, 53)), exponent - 53L);
}
mpz_class divided(const mpz_class& x, const mpz_class& y, long places) { return shifted(x, places) / y; }

/// The power series at s = 0 of the flow that the collisions follow, from x(0), slope(0):
///     cos x dx/ds = k/2 kappa (2 x + pi) + f,    (cos^2 x - r) dkappa/ds = k cos x (r + kappa^2) + g.
void follow_flow(const Start& start, const mpz_class& x0, const mpz_class& slope0, const Series& f,
                 const Series& g, Orbit& orbit) {
    const long one = start.places;
    const std::size_t n = start.terms;
    Work::spend(7 * n * n * (40 + static_cast<std::uint64_t>(one) / 4));
    Series &x = orbit.x, &slope = orbit.slope, &sine = orbit.sine, &cosine = orbit.cosine;
    Series dx = start.series(), dslope = dx, reach = dx, square = dx, push = dx;
    x.term[0] = x0;
    slope.term[0] = slope0;
    Big::precision = one + 32;
    const Big at = Big::rounded(down, mpfr_set_z_2exp, x0.get_mpz_t(), -one);
    const auto [s, c] = guess_sin_cos(at);
    mpfr_get_z(sine.term[0].get_mpz_t(), Big::rounded(down, mpfr_mul_2si, s.get(), one).get(), MPFR_RNDN);
    mpfr_get_z(cosine.term[0].get_mpz_t(), Big::rounded(down, mpfr_mul_2si, c.get(), one).get(), MPFR_RNDN);
    for (std::size_t i = 0;; ++i) {
        reach.term[i] = 2 * x.term[i];
        square.term[i] = coefficient(cosine, cosine, i);
        push.term[i] = shifted(coefficient(slope, slope, i) * start.k, -1 - start.root);
        if (i == 0) {
            reach.term[0] += start.pi;
            square.term[0] -= shifted(start.r, -2 * start.root);
            push.term[0] += shifted(start.r * start.k, -1 - start.root);
        }
        if (i + 1 == n) return;
        const mpz_class next(i + 1);
        const mpz_class climb = shifted(coefficient(slope, reach, i) * start.k, -1 - start.root) + f.term[i];
        sine.term[i + 1] = climb / next;
        dx.term[i] = divided(climb - coefficient(cosine, dx, i, 1), cosine.term[0], one);
        x.term[i + 1] = dx.term[i] / next;
        const mpz_class turn = 2 * coefficient(cosine, push, i) + g.term[i];
        dslope.term[i] = divided(turn - coefficient(square, dslope, i, 1), square.term[0], one);
        slope.term[i + 1] = dslope.term[i] / next;
        cosine.term[i + 1] = -coefficient(dx, sine, i) / next;
    }
}

/// The flow in double from s = -1 to 0, and how its end moves with its beginning.
struct Middle {
    double depth, slope;  ///< pi/2 - x, kappa 2^root
};
struct Flow {
    double half, r, scale;  ///< k/2, r 2^root, 2^-root

    [[nodiscard]] Middle rate(const Middle& at) const {
        const double w = std::sin(at.depth), push = r + at.slope * at.slope * scale;
        return {-half * scale * at.slope * 2 * (M_PI - at.depth) / w,
                2 * half * w * push / (w * w - r * scale)};
    }
    [[nodiscard]] Middle operator()(Middle at) const {
        constexpr int steps = 64;
        constexpr double h = 1. / steps;
        const auto moved = [](const Middle& p, const Middle& v, double t) -> Middle {
            return {p.depth + t * v.depth, p.slope + t * v.slope};
        };
        for (int i = 0; i < steps; ++i) {
            const Middle a = rate(at), b = rate(moved(at, a, h / 2)), c = rate(moved(at, b, h / 2)),
                         d = rate(moved(at, c, h));
            at = moved(moved(moved(moved(at, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
        }
        return at;
    }
};

}  // namespace

bool guess_orbit(const Start& start, Orbit& orbit) {
    const long one = start.places;
    const Flow flow{to_double(start.k, 0) / 2, to_double(start.r, one + start.root),
                    std::ldexp(1., static_cast<int>(-start.root))};
    const Middle from{to_double(shifted(start.pi, -1) - start.x, one), to_double(start.slope, one)};
    if (!(from.depth > 0 && from.slope > 0)) return false;
    const Middle to = flow(from);
    if (!(to.depth > 0 && to.depth <= from.depth && to.slope >= from.slope)) return false;
    std::array<Middle, 2> by{};  // the derivatives of `to` by x and by slope
    for (int i = 0; i < 2; ++i) {
        const double step = 3e-5 * (i == 0 ? from.depth : to.slope);
        const double depth = i == 0 ? -step : 0, slope = i == 0 ? 0 : step;
        const Middle above = flow({from.depth + depth, from.slope + slope}),
                     below = flow({from.depth - depth, from.slope - slope});
        by.at(i) = {(below.depth - above.depth) / (2 * step), (above.slope - below.slope) / (2 * step)};
    }

    // A shift of the orbit by that much changes the excess by less than it should be: dx/ds cos x too, by no
    // more than the shift times the depth.
    const mpz_class enough = abs(shifted(start.excess, start.root + 1) / start.k) / 10 + 1,
                    enough_x = std::min(enough, mpz_class(times(0.1 / to.depth, abs(start.excess)) + 1));
    const auto far = [](const mpz_class& x, const mpz_class& limit) { return abs(x) > limit; };
    mpz_class x = start.x + times(from.depth - to.depth, shifted(1, one)),
              slope = start.slope + times(to.slope - from.slope, shifted(1, one));
    Series f = start.series(), g = f;
    for (int sweep = 0; sweep < 40; ++sweep) {
        follow_flow(start, x, slope, f, g, orbit);
        const mpz_class missed_x = start.x - orbit.x.at(-1), missed_slope = start.slope - orbit.slope.at(-1);
        Excess found = excess(orbit, start);
        found.height.term[0] -= start.excess;
        found.turn.term[0] -= start.excess;
        const mpz_class limit = abs(start.excess) / 2, lost = shifted(1, one);
        if (!far(missed_x, enough_x) && !far(missed_slope, enough) && found.height.size() < limit &&
            found.turn.size() < limit) {
            orbit.x.term[0] += missed_x;  // so that it begins there exactly; sine and cosine follow
            orbit.slope.term[0] += missed_slope;
            const Series sine = orbit.sine;
            orbit.sine = orbit.sine + orbit.cosine.times(missed_x, -one);
            orbit.cosine = orbit.cosine - sine.times(missed_x, -one);
            return true;
        }
        if (far(missed_x, lost) || far(missed_slope, lost)) return false;
        x += times(by[0].depth, missed_x) + times(by[1].depth, missed_slope);
        slope += times(by[0].slope, missed_x) + times(by[1].slope, missed_slope);
        f = f - found.height;
        g = g - found.turn;
        f.term.back() = g.term.back() = 0;  // they were cut off
    }
    return false;
}

}  // namespace dumbbell_verify
