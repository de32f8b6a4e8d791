// Lemmas L5, L6 (b), L8, L9, L10, L12: everything that says "increases" or "decreases", on ordered pairs that
// are far apart, close together, or next to the edge of the domain.
#include <algorithm>

#include "catch.hpp"
#include "ray_count.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

constexpr Real slack = 1e-16L;  // rounding of a few operations on values of order 1

bool no_less(Real a, Real b) { return a >= b - slack * (1 + std::abs(a) + std::abs(b)); }

struct Case {
    double c;
    double kappa;
    double r;
};

std::string text(const Case& a) { return say("c", a.c, "kappa", a.kappa, "r", a.r); }

// c >= 0, -r <= kappa < 1, often at an edge, and often such that the count is large.
Case random_case(Sampler& sampler) {
    const double r = 1 / random_ratio(sampler, 1e4);
    const double kappa = sampler.coin() ? biased(sampler, -r, 2 * r) : biased(sampler, -r, 0.999);
    double c = sampler.coin() ? biased(sampler, 0, 3 * r) : biased(sampler, 0, 1);
    if (sampler.uniform(0, 1) < 0.2 && kappa < 1) {
        // Next to a tangency with the light wall.
        const double edge = static_cast<double>(greatest_excess(Ray<Real>{0, kappa}));
        c = std::max(0.0, edge * (1 - sampler.log_uniform(1e-12, 0.1)));
    }
    return {c, std::min(kappa, 0.999), r};
}

// Not above `high` in any component, inside the domain.
Case lowered(Sampler& sampler, const Case& high) {
    const auto part = [&sampler]() {
        return sampler.uniform(0, 1) < 0.3 ? 0.0
               : sampler.coin()            ? sampler.log_uniform(1e-12, 1)
                                           : sampler.uniform(0, 1);
    };
    const double r = high.r * (1 - 0.9 * part());
    const double kappa = high.kappa - part() * (high.kappa + r);
    // kappa >= -r must hold at the lower r too.
    return {high.c * (1 - part()), std::clamp(kappa, -r, std::max(high.kappa, -r)), r};
}

std::size_t count(const Case& a) { return ray_count(Ray<Real>{a.c, a.kappa}, static_cast<Real>(a.r)); }
std::size_t count_80(const Case& a) { return ray_count(Ray<Digits80>{a.c, a.kappa}, Digits80(a.r)); }

}  // namespace

TEST_CASE(
    "L5: x, kappa', c' increase with c, kappa and r, and lower rays hit and return whenever higher ones do") {
    Sampler sampler(1, 301);
    int compared = 0;
    for (int i = 0; i < trials(200'000); ++i) {
        const Case high = random_case(sampler);
        const Case low = lowered(sampler, high);
        if (low.kappa > high.kappa) continue;  // kappa = -r at the higher r has nothing below it at a lower r
        const auto above = step(Ray<Real>{high.c, high.kappa}, static_cast<Real>(high.r));
        const auto below = step(Ray<Real>{low.c, low.kappa}, static_cast<Real>(low.r));
        if (!above) continue;
        std::string wrong;
        if (!below) {
            // A tie of two tangencies is rounding.
            if (greatest_excess(Ray<Real>{low.c, low.kappa}) < -slack) wrong = "the lower ray misses";
        } else if (!no_less(std::sin(above->x), std::sin(below->x))) {
            // Near a tangency x itself is known to half the digits; compare where that does not matter.
            if (std::cos(above->x) - high.kappa > 1e-6L) wrong = "x decreases";
        } else if (above->next) {
            ++compared;
            if (!below->next) {
                wrong = "the lower ray does not return";
            } else if (!(below->next->kappa <= above->next->kappa * (1 + 1e-9L) + slack)) {
                wrong = "kappa' decreases";
            } else if (!(below->next->c <= above->next->c * (1 + 1e-9L) + slack)) {
                wrong = "c' decreases";
            }
            if (!wrong.empty() && std::cos(above->x) - high.kappa < 1e-6L) wrong.clear();
        }
        if (!wrong.empty()) FAIL(wrong << ": high " << text(high) << " low " << text(low));
    }
    CHECK(compared > 10'000);
}

TEST_CASE("L5: G does not increase with c, kappa or r") {
    Sampler sampler(1, 302);
    std::size_t most = 0;
    for (int i = 0; i < trials(100'000); ++i) {
        const Case high = random_case(sampler);
        const Case low = lowered(sampler, high);
        if (low.kappa > high.kappa) continue;
        most = std::max(most, count(low));
        if (count(low) < count(high) && count_80(low) < count_80(high)) {
            FAIL("high " << text(high) << " G " << count_80(high) << " low " << text(low) << " G "
                         << count_80(low));
        }
    }
    CHECK(most > 40);
}

TEST_CASE("L5: the derivatives of kappa'") {
    Sampler sampler(1, 303);
    for (int i = 0; i < trials(50'000); ++i) {
        const Digits80 kappa = sampler.uniform(-1, 1);
        const Digits80 w = sampler.uniform(0, 1);
        const Digits80 r = sampler.uniform(0.001, 1);
        const auto slope = [](const Digits80& k, const Digits80& v, const Digits80& q) {
            return Digits80((k * v * v + 2 * q * v - q * k) / (v * v - 2 * v * k - q));
        };
        const Digits80 d = w * w - 2 * w * kappa - r;
        if (abs(d) < 1e-3) continue;
        const Digits80 h = 1e-30;
        const Digits80 by_kappa = (slope(kappa + h, w, r) - slope(kappa - h, w, r)) / (2 * h);
        const Digits80 by_w = (slope(kappa, w + h, r) - slope(kappa, w - h, r)) / (2 * h);
        const Digits80 by_r = (slope(kappa, w, r + h) - slope(kappa, w, r - h)) / (2 * h);
        const Digits80 n = w * w + r;
        const bool ok = abs(by_kappa - n * n / (d * d)) < 1e-25 &&
                        abs(by_w + 2 * (kappa * kappa + r) * n / (d * d)) < 1e-25 &&
                        abs(by_r - 2 * w * (w - kappa) * (w - kappa) / (d * d)) < 1e-25;
        if (!ok) FAIL(say(kappa, w, r));
    }
    SUCCEED();
}

TEST_CASE("L6 (b): a ray with kappa >= -r returns with kappa' >= r") {
    Sampler sampler(1, 304);
    int returned = 0;
    for (int i = 0; i < trials(200'000); ++i) {
        const double r = 1 / random_ratio(sampler, 1e9);
        const Real kappa = sampler.coin() ? biased(sampler, -r, r) : biased(sampler, -r, 1);
        const Real x = biased(sampler, 0, 1.5707963267948966);
        const auto next = slope_after(kappa, x, static_cast<Real>(r));
        if (!next) continue;
        ++returned;
        if (*next < r * (1 - 1e-15L)) FAIL(say("r", r, "kappa", kappa, "x", x, "kappa'", *next));
    }
    CHECK(returned > 50'000);
}

TEST_CASE("L8 (a), (b): the rays of the bridge chart are monotone in e, eta and r") {
    Sampler sampler(1, 305);
    for (int i = 0; i < trials(200'000); ++i) {
        const double e1 = biased(sampler, 0, 1.5707963267948966);
        const double e0 = e1 * (1 - (sampler.coin() ? sampler.log_uniform(1e-9, 1) : 0));
        const double eta1 = sampler.log_uniform(1e-9, 1e3);
        const double eta0 = eta1 * (1 - (sampler.coin() ? sampler.log_uniform(1e-9, 1) : 0));
        const Real r1 = 1 / static_cast<Real>(random_ratio(sampler));
        const Real r0 = r1 * (1 - (sampler.coin() ? static_cast<Real>(sampler.log_uniform(1e-9, 0.99)) : 0));
        const Ray<Real> high = bridge_ray(BridgeState<Real>{e0, eta1}, r1);
        const Ray<Real> low = bridge_ray(BridgeState<Real>{e1, eta0}, r0);
        bool ok = no_less(high.c, low.c) && no_less(high.kappa, low.kappa);
        const Ray<Real> up = bridge_ray_reversed(BridgeState<Real>{e1, eta1}, r0);
        const Ray<Real> down = bridge_ray_reversed(BridgeState<Real>{e0, eta0}, r1);
        ok = ok && no_less(up.c / r0, down.c / r1) && no_less(up.kappa / r0, down.kappa / r1);
        if (!ok) FAIL(say("e", e0, e1, "eta", eta0, eta1, "r", r0, r1));
    }
    SUCCEED();
}

TEST_CASE("L9 (a), (b): the rays of the light chart are monotone in e, lambda and r") {
    Sampler sampler(1, 306);
    int both = 0;
    for (int i = 0; i < trials(200'000); ++i) {
        const Real r1 = 1 / static_cast<Real>(random_ratio(sampler));
        const Real r0 = r1 * (1 - (sampler.coin() ? static_cast<Real>(sampler.log_uniform(1e-9, 0.99)) : 0));
        const double e1 = biased(sampler, 0, 1.5707963267948966);
        const double e0 = e1 * (1 - (sampler.coin() ? sampler.log_uniform(1e-9, 1) : 0));
        const double lambda1 = sampler.log_uniform(1e-6, 1) / static_cast<double>(r1);
        const double lambda0 = lambda1 * (1 - (sampler.coin() ? sampler.log_uniform(1e-9, 1) : 0));
        const Ray<Real> high = light_ray(LightState<Real>{e1, lambda1}, r1);
        const Ray<Real> low = light_ray(LightState<Real>{e0, lambda0}, r0);
        if (!no_less(high.c, low.c) || !no_less(high.kappa, low.kappa))
            FAIL(say("X", e0, e1, lambda0, lambda1, r0, r1));
        // mu decreases with w = cos e and with lambda, and increases with r; D behaves the other way round.
        const auto down = light_ray_reversed(LightState<Real>{e0, lambda1}, r0);
        const auto up = light_ray_reversed(LightState<Real>{e1, lambda0}, r1);
        if (!up) continue;
        if (!down) FAIL(say("sigma X: D", e0, e1, lambda0, lambda1, r0, r1));
        ++both;
        const Real mu_up = up->kappa / r1;
        const Real mu_down = down->kappa / r0;
        if (!(mu_up >= mu_down - 1e-9L * (std::abs(mu_up) + std::abs(mu_down)) - slack)) {
            FAIL(say("mu", e0, e1, lambda0, lambda1, r0, r1));
        }
    }
    CHECK(both > 10'000);
}

TEST_CASE("L12: tangent bound, upper bound, strict miss, and cosine and sine near a point") {
    Sampler sampler(1, 307);
    int misses = 0;
    for (int i = 0; i < trials(200'000); ++i) {
        const Case at = random_case(sampler);
        const Real c = at.c;
        const Real kappa = at.kappa;
        const Real half_turn = pi<Real>() / 2;
        const Real z = biased(sampler, 0, 1.5707963267948966);
        const Real d = sampler.log_uniform(1e-6, 1);
        const auto g = [c, kappa](Real x) { return std::sin(x) - kappa * x - c; };
        const auto root = hit_place(Ray<Real>{c, kappa});
        const Real p = std::cos(z) - kappa;
        if (p > 1e-9L && root && *root < z - g(z) / p - 1e-9L) FAIL("(a) " << text(at) << say("z", z));
        if (p > 0 && z + d <= half_turn && std::abs(g(z)) / p + d * d / (2 * p) <= d) {
            if (g(z + d) < -slack) FAIL("(b) sign " << text(at) << say("z", z, "d", d));
            if (root && *root > z + d + 1e-9L) FAIL("(b) root " << text(at) << say("z", z, "d", d));
        }
        if (c - std::sin(z) + z * std::cos(z) > 0 &&
            c + kappa * half_turn - std::sin(z) - (half_turn - z) * std::cos(z) > 0) {
            ++misses;
            if (greatest_excess(Ray<Real>{c, kappa}) > slack) FAIL("(c) " << text(at) << say("z", z));
        }
        if (std::abs(std::cos(z + d) - (std::cos(z) - d * std::sin(z))) > d * d / 2 + slack ||
            std::abs(std::sin(z + d) - (std::sin(z) + d * std::cos(z))) > d * d / 2 + slack) {
            FAIL("(d) " << say("z", z, "d", d));
        }
    }
    CHECK(misses > 1'000);
}
