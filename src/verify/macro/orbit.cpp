#include "verify/macro/orbit.hpp"

#include <algorithm>
#include <optional>

#include "verify/guess/numbers.hpp"

namespace dumbbell_verify {
namespace {

mpz_class divided(const mpz_class& x, const mpz_class& y, long places) { return shifted(x, places) / y; }

/// The power series at s = 0 of the flow that the collisions follow, from x(0), slope(0):
///     cos x dx/ds = k/2 kappa (2 x + pi) + f,    (cos^2 x - r) dkappa/ds = k cos x (r + kappa^2) + g.
/// False where it is no such orbit: its terms are not small.
bool follow_flow(const Start& start, const mpz_class& x0, const mpz_class& slope0, const Series& f,
                 const Series& g, Orbit& orbit) {
    const long one = start.places;
    const std::size_t n = start.terms;
    Series &x = orbit.x, &slope = orbit.slope, &sine = orbit.sine, &cosine = orbit.cosine;
    Series dx = start.series(), dslope = dx, reach = dx, square = dx, push = dx;
    x.term[0] = x0;
    slope.term[0] = slope0;
    Big::precision = one + 32;
    const Big at = Big::rounded(down, mpfr_set_z_2exp, x0.get_mpz_t(), -one);
    const auto [s, c] = guess_sin_cos(at);
    mpfr_get_z(sine.term[0].get_mpz_t(), Big::rounded(down, mpfr_mul_2si, s.get(), one).get(), MPFR_RNDN);
    mpfr_get_z(cosine.term[0].get_mpz_t(), Big::rounded(down, mpfr_mul_2si, c.get(), one).get(), MPFR_RNDN);
    const auto great = [&](const mpz_class& term) {
        return mpz_sizeinbase(term.get_mpz_t(), 2) > static_cast<std::size_t>(one) + 16;
    };
    for (std::size_t i = 0;; ++i) {
        reach.term[i] = 2 * x.term[i];
        square.term[i] = coefficient(cosine, cosine, i);
        push.term[i] = shifted(coefficient(slope, slope, i) * start.k, -1 - start.root);
        if (i == 0) {
            reach.term[0] += start.pi;
            square.term[0] -= shifted(start.r, -2 * start.root);
            push.term[0] += shifted(start.r * start.k, -1 - start.root);
        }
        if (i + 1 == n) return true;
        if (cosine.term[0] <= 0 || square.term[0] <= 0) return false;
        const mpz_class next(i + 1);
        const mpz_class climb = shifted(coefficient(slope, reach, i) * start.k, -1 - start.root) + f.term[i];
        sine.term[i + 1] = climb / next;
        dx.term[i] = divided(climb - coefficient(cosine, dx, i, 1), cosine.term[0], one);
        x.term[i + 1] = dx.term[i] / next;
        const mpz_class turn = 2 * coefficient(cosine, push, i) + g.term[i];
        dslope.term[i] = divided(turn - coefficient(square, dslope, i, 1), square.term[0], one);
        slope.term[i + 1] = dslope.term[i] / next;
        cosine.term[i + 1] = -coefficient(dx, sine, i) / next;
        if (great(dx.term[i]) || great(dslope.term[i])) return false;
    }
}

/// The same with so many places, and as many terms as they are worth.
Start resized(Start start, long places) {
    for (mpz_class* number : {&start.x, &start.slope, &start.r, &start.pi, &start.excess})
        *number = shifted(*number, places - start.places);
    const auto more = static_cast<std::size_t>(places), all = static_cast<std::size_t>(start.places);
    start.terms = 4 + (start.terms - 4) * more / all;
    start.places = places;
    return start;
}
/// The guess with the terms and places of `start`.
Series refitted(const Series& f, const Start& start) {
    Series result = start.series();
    for (std::size_t i = 0; i < std::min(f.term.size(), result.term.size()); ++i)
        result.term[i] = shifted(f.term[i], start.places - f.places);
    return result;
}
/// f(s + h/k), but for the third power of 1/k.
Series moved(const Series& f, long h, const mpz_class& k) {
    Series result = f;
    const mpz_class twice = 2 * k * k;
    for (std::size_t i = 0; i + 1 < f.term.size(); ++i) {
        result.term[i] += mpz_class(f.term[i + 1] * mpz_class(h * static_cast<long>(i + 1))) / k;
        if (i + 2 < f.term.size())
            result.term[i] +=
                mpz_class(f.term[i + 2] * mpz_class(h * h * static_cast<long>((i + 1) * (i + 2)))) / twice;
    }
    return result;
}
/// f(s - 1).
Series from_the_start(Series f) {
    std::size_t n = f.term.size();
    while (n > 0 && f.term[n - 1] == 0) --n;
    Meter::spend(n * n * std::uint64_t{24});
    for (std::size_t i = 0; i + 1 < n; ++i)
        for (std::size_t j = n - 1; j-- > i;) f.term[j] -= f.term[j + 1];
    return f;
}

/// The greatest n known with |x| 2^-places < 2^-n.
long leading_zeros(const mpz_class& x, long places) {
    return places - static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2));
}

/// The slope before the collision at s = -1 that makes start.slope the one after it, with f and g from there.
std::optional<mpz_class> first_slope(const Start& start, const Series& f, const Series& g) {
    Start few = start;
    few.terms = 3;
    mpz_class slope = start.slope;
    for (int i = 0; i < 100; ++i) {
        Orbit begin = few.orbit();
        if (!follow_flow(few, start.x, slope, refitted(f, few), refitted(g, few), begin)) return std::nullopt;
        const mpz_class missed = start.slope - moved(begin.slope, 1, start.k).term[0];
        slope += missed;
        if (abs(missed) <= 1) break;
    }
    return slope;
}

/// The flow with f and g, from start.x and start.slope at s = -1. For its slope half a collision counts: with
/// that it is the same forwards and backwards, as the collisions are, and misses them by the square of 1/k.
bool follow_collisions(const Start& start, const Series& f, const Series& g, Orbit& orbit) {
    const Series f0 = from_the_start(f), g0 = from_the_start(g);
    const auto slope0 = first_slope(start, f0, g0);
    if (!slope0 || !follow_flow(start, start.x, *slope0, f0, g0, orbit)) return false;
    const mpz_class x = orbit.x.at(1), slope = orbit.slope.at(1);
    if (!follow_flow(start, x, slope, f, g, orbit)) return false;
    orbit.slope = moved(orbit.slope, 1, start.k);
    return true;
}

/// The orbit rounded to the places of `start`, and moved so that it begins exactly there.
void settle(const Start& start, Orbit& orbit) {
    for (Series* p : {&orbit.x, &orbit.slope, &orbit.sine, &orbit.cosine}) *p = refitted(*p, start);
    const mpz_class missed = start.x - orbit.x.at(-1);
    const Series sine = orbit.sine;
    orbit.x.term[0] += missed;
    orbit.slope.term[0] += start.slope - orbit.slope.at(-1);
    orbit.sine = sine + orbit.cosine.times(missed, -start.places);
    orbit.cosine = orbit.cosine - sine.times(missed, -start.places);
}

}  // namespace

bool guess_orbit(const Start& start, Orbit& orbit) {
    // Bits of the excess: a sweep finds 2 log k more, a few less to be sure, and needs some to spare. Nearer
    // the peak the first one has more, for the orbit is nearer to that of a ball that falls, but to begin at
    // x with what the last one finds takes more places.
    constexpr long spare = 24;
    const long of_k = static_cast<long>(mpz_sizeinbase(start.k.get_mpz_t(), 2)), won = 2 * of_k - 8;
    const long wanted = leading_zeros(start.excess, start.places) + 4;
    const long depth = leading_zeros(shifted(start.pi, -1) - start.x, start.places);
    const long full = start.places + std::max(0L, depth) / 2;
    long known = std::max(0L, 3 * (start.root - of_k) / 2), first = 0;
    Series f(1, start.places);  // a flow with f and g exceeds the collisions by about as much
    f.term[0] = start.excess;
    Series g = f;
    for (int sweep = 0; sweep < 60; ++sweep) {
        const bool last = known + won >= wanted;
        const Start now =
            resized(start, last ? full : std::min(full, std::max(64L, known + 2 * won + spare)));
        f = refitted(f, now);
        g = refitted(g, now);
        orbit = now.orbit();
        if (!follow_collisions(now, f, g, orbit)) return false;
        if (last) {
            settle(start, orbit);
            return true;
        }
        Excess found = excess(orbit, now);
        found.height.term[0] -= now.excess;
        found.turn.term[0] -= now.excess;
        const long before = known;
        known = std::min(leading_zeros(found.height.size() + found.turn.size(), now.places),
                         now.places - spare - won + 8);
        if (sweep == 0)
            first = known;
        else if (known < before + 2)
            return false;
        // Beyond that degree there is nothing but rounding.
        const long degree = std::max(0L, known - first + won + 8) / 2 + 4;
        for (auto i = static_cast<std::size_t>(degree); i < now.terms; ++i)
            found.height.term[i] = found.turn.term[i] = 0;
        f = f - moved(found.height, -1, now.k);
        g = g - moved(found.turn, -2, now.k);
    }
    return false;
}

}  // namespace dumbbell_verify
