#include "dumbbell/bounce.hpp"

#include <algorithm>
#include <cmath>

#include "api/translate.hpp"
#include "flight/contact.hpp"
#include "flight/reflection.hpp"
#include "number/elementary.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {
namespace {

using I = dumbbell::Interval;

I taken(const Interval& x, const char* name) {
    if (!std::isfinite(x.lo) || !std::isfinite(x.hi) || !(x.lo <= x.hi)) {
        throw dumbbell::InputError(std::string(name) + " is not an interval: give finite numbers lo <= hi");
    }
    return {x.lo, x.hi};
}

Interval given(const I& x) { return {x.lo(), x.hi()}; }

/// Bounds of what follows a collision: from below and from above, lemma L5 (e).
struct Reflected {
    flight::LightReflection<I> low;
    flight::LightReflection<I> high;
};

/// The reflected rays of a collision at x; D > 0 for all of them.
Bounce reflected(const flight::Contact<I>& low, const flight::Contact<I>& high, const Reflected& out) {
    const I steepest = high_end(out.high.numerator / out.high.denominator);
    const I flattest =
        min(steepest, low_end(max(I(0), low_end(out.low.numerator)) / high_end(out.low.denominator)));
    const I top = high_end(high.sin_x + steepest * (high.x + pi<I>()));
    const I bottom = low_end(low.sin_x + flattest * (low.x + pi<I>()));
    return {Outcome::flies_on,
            {low.x.lo(), high.x.hi()},
            {given(hull(bottom, top)), given(hull(flattest, steepest))}};
}

Bounce bounce_of(const I& c, const I& kappa, const I& r) {
    if (certainly_at_most(I(1), low_end(kappa))) {
        return {Outcome::misses, {}, {}};  // L3
    }
    const auto low = flight::lowest_contact(low_end(c), low_end(kappa));
    if (!low) {
        return {Outcome::misses, {}, {}};
    }
    if (!certainly_less(high_end(kappa), I(1))) {
        return {};
    }
    const auto high = flight::highest_contact(high_end(c), high_end(kappa));
    if (!high) {
        return {};
    }
    const Interval x{low->x.lo(), high->x.hi()};
    const Reflected out{flight::reflect_at_light_wall(low_end(kappa), low->cos_x, low_end(r)),
                        flight::reflect_at_light_wall(high_end(kappa), high->cos_x, high_end(r))};
    if (certainly_at_most(high_end(out.low.denominator), I(0))) {
        return {Outcome::leaves, x, {}};  // L1
    }
    if (!certainly_positive(out.high.denominator)) {
        return {};
    }
    const Bounce bounce = reflected(*low, *high, out);
    return bounce.ray.kappa.lo >= 1 ? Bounce{Outcome::leaves, x, {}} : bounce;  // L3
}

}  // namespace

Ray ray_from_light_wall(const Interval& x, const Interval& kappa) {
    return guarded([&]() -> Ray {
        const I at = taken(x, "x");
        const I slope = taken(kappa, "kappa");
        if (!(at.lo() >= 0) || !(at.hi() <= half_pi<I>().lo())) {
            throw dumbbell::InputError("x is not in [0, pi/2]: give the corner distance of a light wall");
        }
        return {given(sin_cos(at).sin + slope * (at + pi<I>())), kappa};
    });
}

Bounce enclose_bounce(const MassRatio& ratio, const Ray& box) {
    return guarded([&] {
        const I r{ratio.light_over_heavy().lo, ratio.light_over_heavy().hi};
        const I c = taken(box.c, "c");
        const I kappa = taken(box.kappa, "kappa");
        if (c.hi() < 0 || kappa.hi() < -r.hi()) {
            throw dumbbell::InputError("no ray of the box has c >= 0 and kappa >= -1/q");
        }
        // A ratio beyond all doubles has no positive lower bound of r, which lemma L5 (e) asks for.
        return r.lo() > 0 ? bounce_of({std::max(0.0, c.lo()), c.hi()},
                                      {std::max(-r.hi(), kappa.lo()), kappa.hi()}, r)
                          : Bounce{};
    });
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
