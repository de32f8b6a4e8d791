// The claim kind `collisions`: G, the number of later collisions of a ray with the light walls (L4), bounded
// for sets of rays by the monotone step (L5). N is a number that serves as a bound, I an enclosure; formulas
// of N and I are evaluated in I, a plain operation of two N occurs in guesses only.
#pragma once
#include <cstdio>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "verify/format/section.hpp"
#include "verify/input/work.hpp"
#include "verify/macro/leaps.hpp"
#include "verify/number/integer.hpp"
#include "verify/number/interval.hpp"

namespace dumbbell_verify {

template <class N>
class Rays {
  public:
    using I = Interval<N>;
    /// Collisions of a ray that are counted; double cannot tell greater numbers apart.
    using Count = std::conditional_t<std::is_same_v<N, double>, std::uint64_t, mpz_class>;

    /// A ray (c, kappa) at mass ratio r: bounds, all from below or all from above, of a set of rays.
    struct Ray {
        N c, kappa, r;
    };
    /// A collision at corner distance x; sine and cosine bound sin x and cos x.
    struct Contact {
        N x, sine, cosine;
    };

    explicit Rays(std::string* log) : log_(log) {}

    /// The last thing that was to be certified and could not.
    [[nodiscard]] const char* failed() const { return failed_; }

    const N zero{0}, one{1};
    const I half_turn = pi<N>(), quarter = half_turn / I(2);

    /// The box of a leaf, for the log.
    void describe(const Leaf& leaf, const Chart& chart) {
        *log_ += "  " + std::to_string(std::is_same_v<N, double> ? 53 : leaf.bits) + " bits, claimed " +
                 leaf.claimed.get_str() + "\n";
        for (std::size_t i = 0; i < 3; ++i) {
            const mpq_class &lo = leaf.box.lo[i], &hi = leaf.box.hi[i];
            *log_ += "  " + std::string(chart.axes[i]) + " in [" + lo.get_str() + ", " + hi.get_str() +
                     "] within " + show({bound(down, lo, zero), bound(up, hi, zero)}) + "\n";
        }
    }
    bool fact(const char* what, bool holds) {
        if (!holds) failed_ = what;
        if (log_) *log_ += std::string("  ") + what + (holds ? ": holds\n" : ": does NOT hold\n");
        return holds;
    }
    static std::string show(const I& x) {
        char text[80];
        const double lo = to_double(down, x.lo), hi = to_double(up, x.hi);
        std::snprintf(text, sizeof text, lo < hi ? "[%.17g, %.17g]" : "%.17g", lo, hi);
        return text;
    }
    /// Certified a < b, or a <= b.
    bool less(const char* what, const I& a, const I& b, bool strict = true) {
        if (log_) *log_ += "  " + show(a) + (strict ? " < " : " <= ") + show(b) + "\n";
        return fact(what, strict ? a.hi < b.lo : a.hi <= b.lo);
    }

    /// Certified G <= most for all rays above `ray`.
    bool at_most(const char* what, const Ray& ray, const mpz_class& most) {
        return counted(what, by_leaps_or_steps(most, [&](const Count& n, Leaps<Count> leaps) {
                           return hits_at_most(ray, n, leaps);
                       }));
    }
    /// Certified G >= least for all rays below `ray`.
    bool at_least(const char* what, const Ray& ray, const mpz_class& least) {
        return counted(what, by_leaps_or_steps(least, [&](const Count& n, Leaps<Count> leaps) {
                           return hits_at_least(ray, n, leaps);
                       }));
    }

    /// Near the least root of sin x = c + kappa x, from z, by the root of the parabola at z (third order;
    /// from the left it stays left of the root); false if there seems to be none.
    static bool guess_root(const N& c, const N& kappa, N& z) {
        if constexpr (!std::is_same_v<N, double>) {  // most of the way in double
            double near = to_double(down, z);
            if (bits(c) > 64 && Rays<double>::guess_root(to_double(down, c), to_double(down, kappa), near))
                z = bound(down, mpq_class(near), z);
        }
        for (int i = 0; i < 60; ++i) {
            const auto [s, w] = guess_sin_cos(z);
            const N gap = c + kappa * z - s, p = w - kappa, square = p * p - N(2) * gap * s;
            if (!(p > N(0)) && z > N(0)) {
                z = N(0);
                continue;
            }
            const N step = N(2) * gap / (p + sqrt(square));
            if (!(square >= N(0)) || !(z + step < N(2))) return false;
            z = z + step;
            if (std::max(step, -step) <= z * guess_tolerance(z)) return true;
        }
        return false;
    }
    /// Near the z in [0, pi/2] with cos z = kappa, by Newton's iteration.
    [[nodiscard]] N guess_top(const N& kappa) const {
        N z = sqrt(N(2) * (one - kappa)), step = z;
        for (int i = 0; i < 60 && std::max(step, -step) > z * guess_tolerance(z); ++i) {
            const auto [s, w] = guess_sin_cos(z);
            step = (w - kappa) / s;
            z = z + step;
        }
        return std::min(z, quarter.lo);
    }
    /// Near the z in [0, pi] with cos z = slope, and in [0, pi]; at its ends if the slope is beyond [-1, 1].
    [[nodiscard]] N guess_slope(const N& slope) const {
        if (!(slope < one)) return zero;
        if (!(slope > -one)) return half_turn.lo;
        const N z = slope < zero ? half_turn.lo - guess_top(-slope) : guess_top(slope);
        return z > zero ? std::min(z, half_turn.lo) : zero;
    }

    /// L12 (c): certified that every ray above `ray` misses.
    bool misses(const Ray& ray) {
        const N z = guess_top(ray.kappa);
        if (!(z >= zero && z <= quarter.lo)) return false;
        const auto [s, w] = sin_cos(z);
        const I c = ray.c, kappa = ray.kappa;
        const I left = c - s + z * w, right = c + kappa * quarter - s - (quarter - z) * w;
        if (log_ && !steps_.empty())
            steps_.back() += "  tangent at " + show(z) + " from " + show(left) + " to " + show(right);
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
        const I d = I(x) - z, rest = d * d / I(2);
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
        const I d = I(x.hi) - z, rest = d * d / I(2);
        const N cosine = (w - d * s + rest * I(-1)).lo;
        if (!(cosine > zero)) return std::nullopt;
        return Contact{x.hi, (s + d * w + rest).hi, cosine};
    }
    /// (2) of L4, in the monotone sense of L5: from bounds of the state to bounds on the same side. False if
    /// no ray of the set returns (down: D <= 0 certified), or if not all certainly do (up: not D > 0).
    bool reflect(Round d, Ray& ray, const Contact& at) {
        const I kappa = ray.kappa, r = ray.r, w = at.cosine, ww = w * w;
        const I D = ww - I(2) * kappa * w - r, top = kappa * ww + I(2) * r * w - r * kappa;
        const N& divisor = d == down ? D.hi : D.lo;
        if (log_ && !steps_.empty())
            steps_.back() += "  x " + show(at.x) + "  cos " + show(w) + "  D " + show(D);
        if (!(divisor > zero)) return false;
        ray.kappa = std::max(zero, div(d, std::max(zero, d == down ? top.lo : top.hi), divisor));
        const I c = I(at.sine) + I(ray.kappa) * (I(at.x) + half_turn);
        ray.c = std::max(zero, d == down ? c.lo : c.hi);
        return true;
    }

  protected:
    /// Macro steps lose a small part of a collision, more than rounding: where that is what the answer hangs
    /// on, one step after the other, unless they are too many.
    template <class Hits>
    bool by_leaps_or_steps(const mpz_class& collisions, Hits hits) {
        constexpr unsigned most_steps = 1'000'000;
        if (std::is_same_v<N, double> && !fits(collisions, 64)) return false;
        const Count n(as<Count>(collisions));
        if (hits(n, Leaps<Count>(n))) return true;
        if (n < least_macro || n > most_steps) return false;
        steps_.clear();
        return hits(n, Leaps<Count>(0));
    }
    bool hits_at_most(Ray ray, const Count& most, Leaps<Count>& leaps) {
        N z = zero;
        for (Count count = 0;; ++count) {
            step(count, ray);
            if (ray.kappa >= one) return true;
            const bool seems_to_hit = guess_root(ray.c, ray.kappa, z);
            if ((!seems_to_hit || count == most) && misses(ray)) return true;
            if (count == most) return false;
            const Contact at = earliest(ray, z);
            if (!reflect(down, ray, at)) return true;
            if (!leap(leaps, down, ray, at.x, most - 1, count)) return false;
        }
    }
    bool hits_at_least(Ray ray, const Count& least, Leaps<Count>& leaps) {
        N z = zero;
        for (Count count = 0; count < least; ++count) {
            step(count, ray);
            if (!(ray.kappa < one && guess_root(ray.c, ray.kappa, z))) return false;
            const auto at = latest(ray, z);
            if (!at || (count + 1 < least && !reflect(up, ray, *at))) return false;
            if (count + 1 < least && !leap(leaps, up, ray, at->x, least - 1, count)) return false;
        }
        return true;
    }
    /// Moves the ray, which leaves collision count + 1 at x, over more of them if that is worth it, up to
    /// `most` + 1 in all, and counts them. False if there are too many to go one by one.
    bool leap(Leaps<Count>& leaps, Round d, Ray& ray, const N& x, const Count& most, Count& count) {
        if (!leaps.may()) return leaps.near(count);
        if (!(ray.kappa < one)) return true;
        WallBound wall{exact_value(x), exact_value(ray.kappa), exact_value(ray.r)};
        if (!leaps.over(d, wall, most, bits(x), count, log_ ? &steps_ : nullptr)) return true;
        const N at = bound(d, wall.x, zero);
        ray.kappa = bound(d, wall.kappa, zero);
        const I c = sin_cos(at).sin + I(ray.kappa) * (I(at) + half_turn);
        ray.c = std::max(zero, d == down ? c.lo : c.hi);
        return true;
    }
    void step(const Count& count, const Ray& ray) {
        Work::collision();
        if (log_)
            steps_.push_back("    " + integer(count).get_str() + ": c " + show(ray.c) + " kappa " +
                             show(ray.kappa));
    }
    bool counted(const char* what, bool holds) {
        if (steps_.size() > 40) steps_.erase(steps_.begin() + 20, steps_.end() - 20);
        for (const std::string& text : steps_) *log_ += text + "\n";
        steps_.clear();
        return fact(what, holds);
    }

    std::string* log_;

  private:
    std::vector<std::string> steps_;  ///< of the present ray, if there is a log
    const char* failed_ = "";
};

}  // namespace dumbbell_verify
