#include "verify/macro/check.hpp"

#include <algorithm>

#include "verify/functions/exact_value.hpp"

namespace dumbbell_verify {
namespace {

mpz_class fixed(Round d, const Big& x, long places) {
    return dumbbell_verify::fixed(d, exact_value(x), places);
}

/// Bounds of |sine - sin x| and |cosine - cos x| on [-1, 1], as the errors of the series, and of the
/// derivative of the former: Z = cosine + i sine has Z' = i x' Z but for a residual, which is all that can
/// move it away from exp(i x), and starts near exp(i x(0)). (L42, on its polynomials)
void enclose_sine(Orbit& orbit) {
    const std::size_t n = orbit.x.term.size();
    const long one = orbit.x.places;
    Big::precision = one + 32;
    const auto [s, c] = sin_cos(Big::rounded(down, mpfr_set_z_2exp, orbit.x.term[0].get_mpz_t(), -one));
    const auto apart = [&](const mpz_class& guess, const Interval<Big>& value) {
        return mpz_class(
            std::max(abs(guess - fixed(down, value.lo, one)), abs(guess - fixed(up, value.hi, one))));
    };
    mpz_class error = apart(orbit.sine.term[0], s) + apart(orbit.cosine.term[0], c);
    // The derivatives are exact, and so are the products' terms up to degree 2 n, at 2 one places.
    std::vector<mpz_class> sine(2 * n), cosine(2 * n);
    mpz_class fastest = 0;
    for (std::size_t i = 0; i + 1 < n; ++i) {
        sine[i] += shifted(orbit.sine.term[i + 1] * mpz_class(i + 1), one);
        cosine[i] += shifted(orbit.cosine.term[i + 1] * mpz_class(i + 1), one);
        const mpz_class speed = orbit.x.term[i + 1] * mpz_class(i + 1), back = -speed;
        fastest += abs(speed);
        for (std::size_t j = 0; j < n; ++j) {
            add_product(sine[i + j], back, orbit.cosine.term[j]);
            add_product(cosine[i + j], speed, orbit.sine.term[j]);
        }
    }
    mpz_class residual = 0;
    for (std::size_t i = 0; i < 2 * n; ++i) residual += abs(sine[i]) + abs(cosine[i]);
    error += shifted_up(residual, -one);
    orbit.sine.error = orbit.cosine.error = error;
    orbit.sine_slope_error = shifted_up(residual, -one) + shifted_up(fastest * error, -one);
}

/// f > 0 (up), or f < 0 (down), on all of [-1, 1].
bool has_sign(Round d, const Series& f) {
    return (d == up ? f.term[0] : mpz_class(-f.term[0])) > f.size(1) + f.error;
}

}  // namespace

mpz_class fixed(Round d, const mpq_class& x, long places) {
    const mpz_class numerator = shifted(x.get_num(), places);
    mpz_class result;
    (d == down ? mpz_fdiv_q : mpz_cdiv_q)(result.get_mpz_t(), numerator.get_mpz_t(), x.get_den_mpz_t());
    return result;
}

PrecisionKept::PrecisionKept() : before_(Big::precision) {}
PrecisionKept::~PrecisionKept() { Big::precision = before_; }

Excess excess(const Orbit& orbit, const Start& start) {
    const mpz_class& k = start.k;
    const long scale = -1 - start.root;
    const auto next = [&](const Series& f, const Series& slope) {  // f(s + 2/k), from its slope over 2/k
        Series result = start.series();
        for (std::size_t i = 0; i < start.terms; ++i) {
            const mpz_class twice = 2 * slope.term[i];
            mpz_fdiv_q(result.term[i].get_mpz_t(), twice.get_mpz_t(), k.get_mpz_t());
        }
        result.error = 2 * slope.error / k + 1 + start.terms;
        return f + result;
    };
    const Difference slope(start.terms, start.places, k);
    const Series dx = slope.of(orbit.x), dslope = slope.of(orbit.slope), dcosine = slope.of(orbit.cosine);
    Series dsine = slope.of(orbit.sine);
    dsine.error += orbit.sine_slope_error;
    const Series w = next(orbit.cosine, dcosine);
    Series reach = orbit.x + next(orbit.x, dx);
    reach.term[0] += start.pi;
    reach.error += 1;
    Series square = w * w;
    square.term[0] -= shifted(start.r, -2 * start.root);
    square.error += 1;
    Series push = (orbit.slope * next(orbit.slope, dslope)).times(k, scale);
    push.term[0] += shifted(start.r * k, scale);
    push.error += 1;
    return {dsine - (orbit.slope * reach).times(k, scale), square * dslope - (w * push).times(2, 0)};
}

bool is_macro_step(Round d, Orbit orbit, const Start& start) {
    if (orbit.x.at(-1) != start.x || orbit.slope.at(-1) != start.slope) return false;
    enclose_sine(orbit);
    const Excess found = excess(orbit, start);
    if (!has_sign(d, found.height) || !has_sign(d, found.turn)) return false;
    const long one = start.places;
    const mpz_class cosine = orbit.cosine.term[0] - orbit.cosine.size(1) - orbit.cosine.error,
                    slope = orbit.slope.term[0] + orbit.slope.size(1),
                    room = cosine - shifted_up(slope, 1 - start.root);
    const bool inside = cosine > 0 && room > 0 && cosine * room > shifted_up(start.r, one - 2 * start.root) &&
                        orbit.x.size() < shifted(start.pi - 1, -1);
    if (d == up) return inside;
    // The bounds climb: the two expressions are not too far below 0.
    const mpz_class height = found.height.size() + found.height.error,
                    turn = found.turn.size() + found.turn.error;
    return inside && start.x >= 0 && height < shifted(start.slope * start.k, -1 - start.root) &&
           turn < shifted(start.r * cosine * start.k, -one - start.root);
}

}  // namespace dumbbell_verify
