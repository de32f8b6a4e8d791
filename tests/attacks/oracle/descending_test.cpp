// Lemma L10 and format.md 3.5: the first collision of a ray with a negative slope, jointly in the ratio.
#include <algorithm>

#include "catch.hpp"
#include "ray_count.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

struct Falling10 {
    double c;       // in units of r
    double lambda;  // in [-1, 0)
    double r_lo;
    double r_hi;
};

Falling10 random_ray(Sampler& sampler) {
    const double r_hi = 1 / random_ratio(sampler, 3e3);
    const double width = sampler.coin() ? sampler.log_uniform(1e-9, 0.9) : sampler.uniform(0, 0.9);
    return {biased(sampler, 0, 1), -biased(sampler, 1e-6, 1), r_hi * (1 - width), r_hi};
}

template <class S>
Ray<S> at(const Falling10& ray, const S& r) {
    return {S(r * S(ray.c)), S(r * S(ray.lambda))};
}

std::string text(const Falling10& a) { return say("c", a.c, "lambda", a.lambda, "r", a.r_lo, a.r_hi); }

}  // namespace

TEST_CASE("L10: the state after the first collision grows with r, whether or not its condition holds") {
    Sampler sampler(1, 401);
    for (int i = 0; i < trials(50'000); ++i) {
        const Falling10 ray = random_ray(sampler);
        const Real lo = ray.r_lo;
        const Real hi = ray.r_hi;
        const Real mid = lo + (hi - lo) * static_cast<Real>(sampler.uniform(0, 1));
        if (!hit_place(at(ray, lo)) || !hit_place(at(ray, hi))) FAIL("a falling ray misses: " << text(ray));
        const auto first = step(at(ray, lo), lo);
        const auto middle = step(at(ray, mid), mid);
        const auto last = step(at(ray, hi), hi);
        std::string wrong;
        for (const auto& [a, b] :
             {std::pair(first, middle), std::pair(middle, last), std::pair(first, last)}) {
            if (a->x > b->x * (1 + 1e-15L)) wrong = "x";
            if (b->next && !a->next) wrong = "return";
            if (!a->next || !b->next) continue;
            if (a->next->kappa > b->next->kappa * (1 + 1e-14L)) wrong = "kappa'";
            if (a->next->c > b->next->c * (1 + 1e-14L)) wrong = "c'";
        }
        const auto g = [&ray](const Real& r) { return ray_count(at(ray, r), r); };
        if (g(lo) < g(mid) || g(mid) < g(hi)) {
            const auto g80 = [&ray](const Real& r) { return ray_count(at(ray, Digits80(r)), Digits80(r)); };
            if (g80(lo) < g80(mid) || g80(mid) < g80(hi)) wrong = "G";
        }
        if (!wrong.empty()) FAIL(wrong << ": " << text(ray) << " mid " << mid);
    }
    SUCCEED();
}

// Why the condition is not needed. With a = -lambda, p = w + r a, X = w^2 + r the sign of d kappa'/dr is that
// of 2 w p^3 + 2 (1 + r a^2) X (1 - w^2) - a X^2 p, and a X <= p gives that this is at least X (1 - w^2) (1 +
// r a^2).
TEST_CASE("L10: the derivative along r is at least zero for every w, r and lambda") {
    Sampler sampler(1, 404);
    for (int i = 0; i < trials(200'000); ++i) {
        const Real w = biased(sampler, 0, 1);
        const Real r = biased(sampler, 1e-9, 1);
        const Real a = biased(sampler, 0, 1);
        const Real p = w + r * a;
        const Real x = w * w + r;
        const Real rest = x * (1 - w * w) * (1 + r * a * a);
        const Real sign = 2 * w * p * p * p + 2 * (1 + r * a * a) * x * (1 - w * w) - a * x * x * p;
        if (sign < rest - 1e-17L) FAIL(say("w", w, "r", r, "a", a));
    }
    SUCCEED();
}

TEST_CASE("L10: the cheap W = 1 - r_hi^2 is a lower bound of cos x") {
    Sampler sampler(1, 402);
    for (int i = 0; i < trials(50'000); ++i) {
        const Falling10 ray = random_ray(sampler);
        const auto x = hit_place(at<Real>(ray, ray.r_hi));
        const Real r = ray.r_hi;
        if (!x || std::cos(*x) < 1 - r * r - 1e-18L) FAIL(text(ray));
    }
    SUCCEED();
}

TEST_CASE("format 3.5: the fallback bounds G, as long as its ray stays in the domain kappa >= -r, c >= 0") {
    Sampler sampler(1, 403);
    int outside = 0;
    for (int i = 0; i < trials(50'000); ++i) {
        const Falling10 ray = random_ray(sampler);
        const Real lo = ray.r_lo;
        const Real hi = ray.r_hi;
        const Real mid = lo + (hi - lo) * static_cast<Real>(sampler.uniform(0, 1));
        const std::size_t here = ray_count(at(ray, mid), mid);
        const Ray<Real> most{lo * ray.c, hi * ray.lambda};
        const Ray<Real> least{hi * ray.c, lo * ray.lambda};
        if (ray_count(least, hi) > here) FAIL("G >= b: " << text(ray) << " mid " << mid);
        if (most.kappa < -lo) {
            // Outside L5: the step may even return with a negative slope and c' < 0, where G is not defined.
            const auto taken = step(most, lo);
            outside += taken && taken->next && taken->next->c < 0;
        } else if (ray_count(most, lo) < here) {
            FAIL("G <= b: " << text(ray) << " mid " << mid);
        }
    }
    CHECK(outside > 0);  // so a verifier must clamp kappa' to r_lo (L6 (b)) or refuse
}
