// Theorem B of proofs/body.md in plain numbers. The simulation does not use it: tests compare the two.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "ray_count.hpp"
#include "rods.hpp"

namespace dumbbell_oracle {

// One collision of the valley iteration (L79) with the wall of this height, 1 for R and rho for B.
template <class S>
[[nodiscard]] std::optional<Step<S>> valley_step(const Ray<S>& ray, const S& height, const S& r) {
    using std::sin;
    const Ray<S> scaled{ray.c / height, ray.kappa / height};
    const auto x = hit_place(scaled);
    if (!x) return std::nullopt;
    Step<S> taken{*x, std::nullopt};
    if (const auto kappa = slope_after(scaled.kappa, *x, S(r / (height * height))))
        taken.next = Ray<S>{S(std::max(S(0), S(height * (sin(*x) + *kappa * *x)))), S(height * *kappa)};
    return taken;
}

// The two tangents of the bridge at e (L81), and how often they hit: f, and b.
template <class S>
class TwoTangents {
  public:
    explicit TwoTangents(const Numbers& n) : rho_(n.rho), r_(1 / S(n.q)) {}

    [[nodiscard]] std::size_t f(const S& e) const {
        using std::cos;
        using std::sin;
        if (rho_ == 1) return 0;  // at most it touches the tops of humps that are as high
        return ray_count(Ray<S>{S(rho_ * (sin(e) + (pi<S>() - e) * cos(e))), S(rho_ * cos(e))}, r_);
    }
    [[nodiscard]] std::size_t b(const S& e) const {
        using std::cos;
        using std::sin;
        const S above = e < 1e-3 ? S(e * e * e / 3 * (1 - e * e / 10)) : S(sin(e) - e * cos(e));
        Ray<S> ray{S(rho_ * above), S(-rho_ * cos(e))};
        for (std::size_t hits = 0;; ++hits) {
            const auto right = valley_step(ray, S(1), r_);
            if (!right || !right->next) return hits;
            const auto left = valley_step(*right->next, rho_, r_);
            if (!left) return hits;
            if (!left->next) return hits + 1;
            ray = *left->next;
        }
    }
    // Just below e_j; e_0 is at the top.
    [[nodiscard]] S place(std::size_t j) const {
        S lo = 0, hi = pi<S>() / 2;
        if (j == 0) return hi;
        for (int i = 0; i < 100 && hi > 1e-10; ++i) {
            const S middle = lo > 0 ? S((lo + hi) / 2) : S(hi / 100);
            (b(middle) >= j ? lo : hi) = middle;
        }
        return lo;
    }

  private:
    S rho_, r_;
};

// What Theorem B speaks of.
struct TheoremB {
    std::size_t in_corner;       // n*
    std::size_t hits;            // J
    std::vector<std::size_t> f;  // f(e_j)
    std::vector<double> e;
    std::size_t k1, even;  // `even` is T

    template <class S>
    [[nodiscard]] static TheoremB of(const Numbers& n) {
        using std::atan;
        using std::sqrt;
        using std::tan;
        const TwoTangents<S> tangents(n);
        const S root = sqrt(S(n.q)), bridge = atan(S(n.rho) * root), corner = pi<S>() - atan(root) - bridge;
        const std::size_t in_corner = whole_from(S(pi<S>() / corner)), hits = (in_corner + 1) / 2 - 1;
        TheoremB all{in_corner, hits, {}, {}, tangents.f(S(0)), 0};
        for (std::size_t j = 0; j <= hits; ++j) {
            const S e = tangents.place(j);
            all.f.push_back(tangents.f(e));
            all.e.push_back(static_cast<double>(e));
        }
        const S angle = bridge + std::max(S(S(2 * hits + 2) * corner - pi<S>()), S(0));
        if (in_corner % 2 == 0 && angle < pi<S>() / 2) {
            const S kappa = tan(angle) / root;
            all.even = ray_count(Ray<S>{S(pi<S>() * kappa), kappa}, S(1 / S(n.q)));
        }
        return all;
    }
    [[nodiscard]] bool has_even() const { return in_corner % 2 == 0 && even == k1; }
    [[nodiscard]] std::size_t maximum() const {
        std::size_t most = has_even() ? 2 * hits + 2 + 2 * k1 : 0;
        for (std::size_t j = 0; j <= hits; ++j) most = std::max(most, 1 + 2 * (j + f[j]));
        return most;
    }
    // The most collisions of a motion whose valley passage has n (0: it has none), or 0 if there is none
    // such.
    [[nodiscard]] std::size_t most_of(std::size_t n) const {
        const std::size_t j = n / 2;
        if (n % 2 == 1 || n == 0) return j <= hits ? std::max<std::size_t>(n, 1) + 2 * f[j] : 0;
        if (j <= hits) return n + f[j - 1] + f[j];
        return j == hits + 1 && in_corner % 2 == 0 ? n + f[hits] + even : 0;
    }
};

}  // namespace dumbbell_oracle
