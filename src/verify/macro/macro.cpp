#include "verify/macro/macro.hpp"

#include <algorithm>
#include <cmath>

#include "verify/functions/exact_value.hpp"
#include "verify/guess/numbers.hpp"
#include "verify/macro/orbit.hpp"

namespace dumbbell_verify {

namespace {

/// About how many collisions are left before the peak is reached: with the angle th, kappa = root tan th, the
/// orbit nearly keeps P = (2 x + pi) cos th, which leaves an integral over x = pi/2 - depth + u^2.
double collisions_left(double depth, double kappa, double root) {
    constexpr int nodes = 32;
    const double end = M_PI - depth, angle = std::atan(kappa / root), range = std::sqrt(depth),
                 least = end * end * std::sin(angle) * std::sin(angle);
    double sum = 0;
    for (int i = 0; i < nodes; ++i) {
        const double u = range * (i + 0.5) / nodes, further = end + u * u;
        sum += std::sin(depth - u * u) * u / (further * std::sqrt(u * u * (end + further) + least));
    }
    return end * std::cos(angle) * sum * range / nodes / root;
}

}  // namespace

mpz_class macro_step(Round d, WallBound& bound, const mpz_class& most, long bits) {
    const PrecisionKept kept;
    const double r = bound.r.get_d(), x = bound.x.get_d();
    Big::precision = bits + 32;
    const Big rest = pi_bound(down, Big()) / Big(2) - Big::rounded(down, mpfr_set_q, bound.x.get_mpq_t());
    const double depth = to_double(down, rest);
    const double root = std::sqrt(r), root_bits = -std::log2(root);
    if (!(depth > 0 && r > 0x1p-1000)) return 0;
    const double left = collisions_left(depth, bound.kappa.get_d(), root);
    const double length = std::min(0.33 * left, most.get_d());
    // What is lost of a collision in all, and what that takes.
    const double share = std::clamp(static_cast<double>(bits) - root_bits - 4, 8.,
                                    std::max(12., static_cast<double>(bits) / 8 - 20));
    const double finest = 2 * root_bits + share + 1, least = 44 + finest / 2.2;
    if (!std::isfinite(length)) return 0;

    Start start;
    start.root = std::lround(std::floor(root_bits));
    const double at_start = 8 - std::log2(std::clamp(x, r, 1.));  // x must not be rounded away
    for (double k = std::floor(length); k >= least; k = std::floor(k / 2)) {
        const double resolution = finest - std::log2(k);
        const long one = start.places = std::lround(std::max(resolution + 24, at_start));
        start.terms = static_cast<std::size_t>(resolution / 2.2) + 4;
        start.x = fixed(d, bound.x, one);
        start.slope = fixed(d, bound.kappa, one + start.root);
        start.r = fixed(d, bound.r, one + 2 * start.root);
        Big::precision = one + 32;
        start.pi = fixed(down, exact_value(pi_bound(down, Big())), one);
        if (start.x <= 0 || start.slope <= 0 || start.r <= 0) return 0;
        Orbit orbit = start.orbit();
        start.k = mpz_class(k);
        const mpz_class excess = shifted(start.k * start.r, -1 - 2 * start.root - std::lround(share));
        start.excess = d == up ? excess : mpz_class(-excess);
        if (!guess_orbit(start, orbit) || !is_macro_step(d, orbit, start)) continue;
        bound.x = mpq_class(orbit.x.at(1), shifted(1, one));
        bound.kappa = mpq_class(orbit.slope.at(1), shifted(1, one + start.root));
        bound.x.canonicalize();
        bound.kappa.canonicalize();
        return start.k;
    }
    return 0;
}

}  // namespace dumbbell_verify
