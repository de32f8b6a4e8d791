#include "verify/macro/macro.hpp"

#include <algorithm>
#include <cmath>

#include "verify/macro/orbit.hpp"
#include "verify/number/big.hpp"
#include "verify/number/interval.hpp"

namespace dumbbell_verify {
namespace {

/// Gives the thread its precision back.
struct Precision {
    Precision() = default;
    Precision(const Precision&) = delete;
    Precision& operator=(const Precision&) = delete;
    ~Precision() { Big::precision = before; }
    mpfr_prec_t before = Big::precision;
};

/// x as a multiple of 2^-places, rounded.
mpz_class fixed(Round d, const mpq_class& x, long places) {
    const mpz_class numerator = shifted(x.get_num(), places);
    mpz_class result;
    (d == down ? mpz_fdiv_q : mpz_cdiv_q)(result.get_mpz_t(), numerator.get_mpz_t(), x.get_den_mpz_t());
    return result;
}
mpz_class fixed(Round d, const Big& x, long places) {
    mpq_class exact;
    mpfr_get_q(exact.get_mpq_t(), x.get());
    return fixed(d, exact, places);
}

/// Bounds of |sine - sin x| and |cosine - cos x| on [-1, 1], as the errors of the series: Z = cosine + i sine
/// has Z' = i x' Z but for a residual, which is all that can move it away from exp(i x), and starts near
/// exp(i x(0)). (L42, on its polynomials)
void enclose_sine(Orbit& orbit) {
    const std::size_t n = orbit.x.term.size();
    const long one = orbit.x.places;
    Big::precision = one + 32;
    const auto [s, c] = sin_cos(Big::rounded(down, mpfr_set_z_2exp, orbit.x.term[0].get_mpz_t(), -one));
    const auto apart = [&](const mpz_class& guess, const Interval<Big>& value) {
        return mpz_class(std::max(abs(guess - fixed(down, value.lo, one)), abs(guess - fixed(up, value.hi, one))));
    };
    mpz_class error = apart(orbit.sine.term[0], s) + apart(orbit.cosine.term[0], c);
    // The derivatives are exact, and so are the products' terms up to degree 2 n, at 2 one places.
    std::vector<mpz_class> sine(2 * n), cosine(2 * n);
    Work::spend(64 * n * n);
    for (std::size_t i = 0; i + 1 < n; ++i) {
        sine[i] += shifted(orbit.sine.term[i + 1] * mpz_class(i + 1), one);
        cosine[i] += shifted(orbit.cosine.term[i + 1] * mpz_class(i + 1), one);
        const mpz_class speed = orbit.x.term[i + 1] * mpz_class(i + 1);
        for (std::size_t j = 0; j < n; ++j) {
            mpz_submul(sine[i + j].get_mpz_t(), speed.get_mpz_t(), orbit.cosine.term[j].get_mpz_t());
            mpz_addmul(cosine[i + j].get_mpz_t(), speed.get_mpz_t(), orbit.sine.term[j].get_mpz_t());
        }
    }
    mpz_class residual = 0;
    for (std::size_t i = 0; i < 2 * n; ++i) residual += abs(sine[i]) + abs(cosine[i]);
    error += shifted_up(residual, -one);
    orbit.sine.error = orbit.cosine.error = error;
}

/// f > 0 (up), or f < 0 (down), on all of [-1, 1].
bool has_sign(Round d, const Series& f) {
    return (d == up ? f.term[0] : mpz_class(-f.term[0])) > f.size(1) + f.error;
}

/// What L42 demands of the polynomials.
bool follows(Round d, Orbit orbit, const Start& start) {
    enclose_sine(orbit);
    const Excess found = excess(orbit, start);
    if (!has_sign(d, found.height) || !has_sign(d, found.turn)) return false;
    const long one = start.places;
    const mpz_class cosine = orbit.cosine.term[0] - orbit.cosine.size(1) - orbit.cosine.error,
                    slope = orbit.slope.term[0] + orbit.slope.size(1),
                    room = cosine - shifted_up(slope, 1 - start.root);
    const bool inside = cosine > 0 && room > 0 && cosine * room > shifted_up(start.r, one - start.root) &&
                        orbit.x.size() < shifted(start.pi - 1, -1);
    if (d == up) return inside;
    // The bounds climb: the two expressions are not too far below 0.
    const mpz_class height = found.height.size() + found.height.error, turn = found.turn.size() + found.turn.error;
    return inside && start.x >= 0 && height < shifted(start.slope * start.k, -1 - start.root) &&
           turn < shifted(start.r * cosine * start.k, -one);
}

}  // namespace

std::uint64_t macro_step(Round d, WallBound& bound, std::uint64_t most, long bits) {
    const Precision restored;
    const double r = bound.r.get_d(), depth = M_PI / 2 - bound.x.get_d(), kappa = bound.kappa.get_d();
    const double root_bits = -std::log2(r) / 2, half = std::sin(depth / 2);
    const double left = std::min(2 * half * half / (kappa * 2 * (M_PI - depth)), 0.5 / std::sqrt(r));
    const double length = std::min(0.25 * left, static_cast<double>(most));
    // What is lost of a collision in all, and what that takes.
    const double share = std::clamp(static_cast<double>(bits) - root_bits - 4, 8., std::max(12., static_cast<double>(bits) / 4 - 20));
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
    start.pi = fixed(down, pi_bound(down, Big()), one);
    if (start.x <= 0 || start.slope <= 0 || start.r <= 0) return 0;
    Orbit orbit{start.series(), start.series(), start.series(), start.series()};
    for (auto k = static_cast<std::uint64_t>(length); static_cast<double>(k) >= least; k /= 2) {
        start.k = mpz_class(std::to_string(k));
        const mpz_class excess = shifted(start.k * start.r, -1 - start.root - std::lround(share));
        start.excess = d == up ? excess : mpz_class(-excess);
        if (!guess_orbit(start, orbit) || !follows(d, orbit, start)) continue;
        bound.x = mpq_class(orbit.x.at(1), shifted(1, one));
        bound.kappa = mpq_class(orbit.slope.at(1), shifted(1, one + start.root));
        bound.x.canonicalize();
        bound.kappa.canonicalize();
        return k;
    }
    return 0;
}

}  // namespace dumbbell_verify
