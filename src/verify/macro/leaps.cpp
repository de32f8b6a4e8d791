#include "verify/macro/leaps.hpp"

#include "verify/core/ray.hpp"
#include "verify/functions/exact_value.hpp"

namespace dumbbell_verify {

/// Macro steps lose a small part of a collision, more than rounding: where that is what the answer hangs on,
/// one collision after the other, unless they are too many.
bool by_leaps(const mpz_class& collisions, const std::function<bool(Leaps*)>& hits) {
    constexpr unsigned most_one_by_one = 1'000'000;
    Leaps leaps;
    return hits(&leaps) || (collisions <= most_one_by_one && hits(nullptr));
}

template <class N>
bool leap(Leaps& leaps, Round d, RayBound<N>& ray, const N& x, mpz_class& left, Log* log) {
    if (!leaps.may()) return leaps.near(left);
    if (!(ray.kappa < N(1))) return true;
    WallBound wall{exact_value(x), exact_value(ray.kappa), exact_value(ray.r)};
    if (!leaps.over(d, wall, bits(x), left, log)) return true;
    using I = Interval<N>;
    const N at = bound(d, wall.x, N(0));
    ray.kappa = bound(d, wall.kappa, N(0));
    const I c = sin_cos(at).sin + I(ray.kappa) * (I(at) + pi<N>());
    ray.c = std::max(N(0), d == down ? c.lo : c.hi);
    return true;
}

template bool leap(Leaps&, Round, RayBound<double>&, const double&, mpz_class&, Log*);
template bool leap(Leaps&, Round, RayBound<Big>&, const Big&, mpz_class&, Log*);

}  // namespace dumbbell_verify
