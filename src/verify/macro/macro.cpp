#include "verify/macro/macro.hpp"

#include <algorithm>
#include <cmath>

#include "verify/macro/orbit.hpp"
#include "verify/number/big.hpp"
#include "verify/number/interval.hpp"

namespace dumbbell_verify {

std::uint64_t macro_step(Round d, WallBound& bound, std::uint64_t most, long bits) {
    const PrecisionKept kept;
    const double r = bound.r.get_d(), depth = M_PI / 2 - bound.x.get_d(), kappa = bound.kappa.get_d();
    const double root_bits = -std::log2(r) / 2, half = std::sin(depth / 2);
    const double left = std::min(2 * half * half / (kappa * 2 * (M_PI - depth)), 0.5 / std::sqrt(r));
    const double length = std::min(0.25 * left, static_cast<double>(most));
    // What is lost of a collision in all, and what that takes.
    const double share = std::clamp(static_cast<double>(bits) - root_bits - 4, 8.,
                                    std::max(12., static_cast<double>(bits) / 4 - 20));
    Start start;
    start.root = std::lround(std::floor(root_bits));
    start.places = std::lround(2 * root_bits + share) + 24;
    start.terms = static_cast<std::size_t>((2 * root_bits + share) / 2.6) + 4;
    const double least = static_cast<double>(40 + start.terms);
    if (!(length >= least && length < 0x1p63)) return 0;

    const long one = start.places;
    start.x = fixed(d, bound.x, one);
    start.slope = fixed(d, bound.kappa, one + start.root);
    start.r = fixed(d, bound.r, one + start.root);
    Big::precision = one + 32;
    start.pi = fixed(down, exact_value(pi_bound(down, Big())), one);
    if (start.x <= 0 || start.slope <= 0 || start.r <= 0) return 0;
    Orbit orbit{start.series(), start.series(), start.series(), start.series()};
    for (auto k = static_cast<std::uint64_t>(length); static_cast<double>(k) >= least; k /= 2) {
        start.k = mpz_class(std::to_string(k));
        const mpz_class excess = shifted(start.k * start.r, -1 - start.root - std::lround(share));
        start.excess = d == up ? excess : mpz_class(-excess);
        if (!guess_orbit(start, orbit) || !is_macro_step(d, orbit, start)) continue;
        bound.x = mpq_class(orbit.x.at(1), shifted(1, one));
        bound.kappa = mpq_class(orbit.slope.at(1), shifted(1, one + start.root));
        bound.x.canonicalize();
        bound.kappa.canonicalize();
        return k;
    }
    return 0;
}

}  // namespace dumbbell_verify
