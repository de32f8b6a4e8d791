// The claim kind `collisions`: G, the number of later collisions of a ray with the light walls (L4), bounded
// for sets of rays by the monotone step (L5). N is a number that serves as a bound, I an enclosure; formulas
// of N and I are evaluated in I.
#pragma once
#include <optional>

#include "verify/core/outside.hpp"

namespace dumbbell_verify {

/// A ray (c, kappa) at mass ratio r: bounds, all from below or all from above, of a set of rays.
template <class N>
struct RayBound {
    N c, kappa, r;
};

template <class N>
class Rays {
  public:
    using I = Interval<N>;
    using Ray = RayBound<N>;
    /// A collision at corner distance x; sine and cosine bound sin x and cos x.
    struct Contact {
        N x, sine, cosine;
    };

    explicit Rays(Log* log) : log_(log) {}

    /// The last thing that was to be certified and could not.
    [[nodiscard]] const char* failed() const { return failed_; }

    const N zero{0}, one{1};
    const I half_turn = pi<N>(), quarter = half_turn / I(2);

    bool fact(const char* what, bool holds) {
        if (!holds) failed_ = what;
        if (log_) log_->fact(what, holds);
        return holds;
    }
    /// Certified a < b, or a <= b.
    bool less(const char* what, const I& a, const I& b, bool strict = true) {
        if (log_) log_->line({{"  ", a}, {strict ? " < " : " <= ", b}});
        return fact(what, strict ? a.hi < b.lo : a.hi <= b.lo);
    }

    /// Certified G <= most for all rays above `ray`.
    bool at_most(const char* what, const Ray& ray, const mpz_class& most) {
        return fact(what,
                    most >= 0 && counted(most, [&](Leaps* leaps) { return hits_at_most(ray, most, leaps); }));
    }
    /// Certified G >= least for all rays below `ray`.
    bool at_least(const char* what, const Ray& ray, const mpz_class& least) {
        return fact(what, counted(least, [&](Leaps* leaps) { return hits_at_least(ray, least, leaps); }));
    }

    /// L12 (c): certified that every ray above `ray` misses.
    bool misses(const Ray& ray) {
        const N z = guess_top(ray.kappa, quarter.lo);
        if (!(z >= zero && z <= quarter.lo)) return false;
        const auto [s, w] = sin_cos(z);
        const I c = ray.c, kappa = ray.kappa;
        const I left = c - s + z * w, right = c + kappa * quarter - s - (quarter - z) * w;
        if (log_) log_->there({{"  tangent at ", I(z)}, {" from ", left}, {" to ", right}});
        return left.lo > zero && right.lo > zero;
    }
    /// L12 (a), (d): rays above `ray` that collide do so at or beyond x, with cos <= cosine, sin >= sine.
    [[nodiscard]] Contact earliest(const Ray& ray, N z) const {
        const I c = ray.c, kappa = ray.kappa;
        auto [s, w] = sin_cos(z);
        if (!(z <= quarter.lo && (w - kappa).lo > zero)) {
            z = zero;
            s = 0;
            w = 1;
        }
        const N x = std::max(zero, (z - (s - kappa * z - c) / (w - kappa)).lo);
        const I d = I(x) - z, rest = scaled(d * d, 1);
        return {x, (s + d * w - rest).lo, std::min(one, (w - d * s + rest).hi)};
    }
    /// L12 (b), (d): all rays below `ray` collide, transversally, at or before x, with cos >= cosine > 0.
    [[nodiscard]] std::optional<Contact> latest(const Ray& ray, const N& z) const {
        const I c = ray.c, kappa = ray.kappa;
        const auto [s, w] = sin_cos(z);
        const I g = s - kappa * z - c, p = w - kappa, size = std::max(-g.lo, g.hi);
        if (!(p.lo > zero)) return std::nullopt;
        const I reach = (I(2) * size / p).hi, x = z + reach;
        if (!((size + reach * reach / I(2)).hi < (p * reach).lo && x.hi <= quarter.lo)) return std::nullopt;
        const I d = I(x.hi) - z, rest = scaled(d * d, 1);
        const N cosine = (w - d * s + rest * I(-1)).lo;
        if (!(cosine > zero)) return std::nullopt;
        return Contact{x.hi, (s + d * w + rest).hi, cosine};
    }
    /// (2) of L4, in the monotone sense of L5: from bounds of the state to bounds on the same side. False if
    /// no ray of the set returns (down: D <= 0 certified), or if not all certainly do (up: not D > 0).
    bool reflect(Round d, Ray& ray, const Contact& at) {
        const I kappa = ray.kappa, r = ray.r, w = at.cosine, rw = r * w;
        const I D = w * (w - (kappa + kappa)) - r, top = kappa * (w * w - r) + (rw + rw);
        const N& divisor = d == down ? D.hi : D.lo;
        if (log_) log_->there({{"  x ", I(at.x)}, {"  cos ", w}, {"  D ", D}});
        if (!(divisor > zero)) return false;
        ray.kappa = std::max(zero, div(d, std::max(zero, d == down ? top.lo : top.hi), divisor));
        const I c = I(at.sine) + I(ray.kappa) * (I(at.x) + half_turn);
        ray.c = std::max(zero, d == down ? c.lo : c.hi);
        return true;
    }

  protected:
    template <class Hits>
    static bool counted(const mpz_class& collisions, const Hits& hits) {
        return collisions < least_worth_leaps ? hits(nullptr) : by_leaps(collisions, hits);
    }
    /// `left` collisions of `most` may still come; of `least`, must.
    bool hits_at_most(Ray ray, const mpz_class& most, Leaps* leaps) {
        N z = zero;
        for (mpz_class left = most;;) {
            look_at(ray, most, left);
            if (ray.kappa >= one) return true;
            const bool seems_to_hit = guess_root(ray.c, ray.kappa, z);
            if ((!seems_to_hit || left == 0) && misses(ray)) return true;
            if (left == 0) return false;
            const Contact at = earliest(ray, z);
            if (!reflect(down, ray, at)) return true;
            --left;
            if (leaps && !leap(*leaps, down, ray, at.x, left, log_)) return false;
        }
    }
    bool hits_at_least(Ray ray, const mpz_class& least, Leaps* leaps) {
        N z = zero;
        for (mpz_class left = least; left > 0;) {
            look_at(ray, least, left);
            if (!(ray.kappa < one && guess_root(ray.c, ray.kappa, z))) return false;
            const auto at = latest(ray, z);
            if (!at) return false;
            if (--left == 0) return true;
            if (!reflect(up, ray, *at)) return false;
            if (leaps && !leap(*leaps, up, ray, at->x, left, log_)) return false;
        }
        return true;
    }
    void look_at(const Ray& ray, const mpz_class& all, const mpz_class& left) {
        Work::collision();
        if (log_) log_->ray(all - left, {{": c ", I(ray.c)}, {" kappa ", I(ray.kappa)}});
    }

    Log* const log_;

  private:
    const char* failed_ = "";
};

}  // namespace dumbbell_verify
