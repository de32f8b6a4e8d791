// The rules of format.md 3.3-3.6 in plain numbers: no state of a random box may exceed what the rule for the
// box allows. This tries the statements that a certificate uses, not the enclosures (they are tested
// elsewhere).
#include <algorithm>

#include "catch.hpp"
#include "ray_count.hpp"
#include "trial.hpp"

using namespace dumbbell_oracle;

namespace {

// second axis: eta or lambda
struct Box {
    double e0, e1, v0, v1, q0, q1;
};

std::string text(const Box& b) { return say("e", b.e0, b.e1, "axis 2", b.v0, b.v1, "q", b.q0, b.q1); }

Box random_box(Sampler& sampler, double greatest_ratio) {
    const auto width = [&sampler]() { return sampler.coin() ? sampler.log_uniform(1e-9, 1) : 0.0; };
    Box box{};
    box.q0 = random_ratio(sampler, greatest_ratio);
    box.q1 = box.q0 * (1 + width());
    box.e0 = sampler.coin() ? sampler.uniform(1e-3, 1.57) : sampler.log_uniform(1e-3, 1.57);
    box.e1 = box.e0 + width();
    box.v0 = sampler.coin()   ? 0
             : sampler.coin() ? sampler.log_uniform(1e-6, 30)
                              : sampler.log_uniform(1e-6, box.q1);
    box.v1 = box.v0 + width() * (1 + box.v0) + 1e-12;
    return box;
}

template <class S>
S half_pi() {
    return pi<S>() / 2;
}

// "G <= b" for the ray (r c, r lambda), all r in the range (format 3.3 and 3.5).
template <class S>
std::size_t bound_below(S c, const S& lambda, const S& r_lo, const S& r_hi) {
    using std::cos;
    using std::max;
    if (c < 0) c = 0;
    if (lambda >= 0) return ray_count(Ray<S>{S(r_lo * c), S(r_lo * lambda)}, r_lo);
    const auto x = hit_place(Ray<S>{S(r_hi * c), S(r_hi * lambda)});
    const S w = x ? S(cos(*x)) : S(0);
    const S gap = w - r_lo * lambda;
    if (w > 0 && 2 * w * gap * gap >= -lambda * (1 + r_hi) * (1 + r_hi)) {
        return ray_count(Ray<S>{S(r_lo * c), S(r_lo * lambda)}, r_lo);
    }
    // Always valid: L5 for one step, then L6 (b): the slope is at least r_lo.
    const auto first = step(Ray<S>{S(r_lo * c), S(r_hi * lambda)}, r_lo);
    if (!first || !first->next) return first.has_value();
    using std::sin;
    const S kappa = max(first->next->kappa, r_lo);
    return 1 + ray_count(Ray<S>{S(sin(first->x) + kappa * (first->x + pi<S>())), kappa}, r_lo);
}

template <class S>
std::size_t bridge_bound(const Box& box) {
    using std::min;
    const S r_lo = 1 / S(box.q1);
    const S r_hi = 1 / S(box.q0);
    const S e1 = min(S(box.e1), half_pi<S>());
    const S e0 = min(S(box.e0), half_pi<S>());
    const std::size_t a = ray_count(bridge_ray(BridgeState<S>{e1, S(box.v0)}, r_lo), r_lo);
    const Ray<S> back = bridge_ray_reversed(BridgeState<S>{e0, S(box.v0)}, r_hi);
    return 1 + a + bound_below(S(back.c / r_hi), S(back.kappa / r_hi), r_lo, r_hi);
}

// format 3.4, `count`; nothing if D cannot be decided on the box.
template <class S>
std::optional<std::size_t> light_bound(const Box& box) {
    using std::cos;
    using std::max;
    using std::min;
    const S r_lo = 1 / S(box.q1);
    const S r_hi = 1 / S(box.q0);
    const S e0 = min(S(box.e0), half_pi<S>());
    const S w0 = cos(e0);
    const std::size_t a = ray_count(light_ray(LightState<S>{e0, S(box.v0)}, r_lo), r_lo);
    if (w0 * w0 + 2 * r_hi * S(box.v1) * w0 - r_lo <= 0) return 1 + a;
    auto back = light_ray_reversed(LightState<S>{e0, S(box.v1)}, r_lo);
    if (!back) return std::nullopt;
    using std::sin;
    back->kappa = max(back->kappa, S(0));
    back->c = sin(e0) + back->kappa * (pi<S>() + e0);
    return 1 + a + ray_count(*back, r_lo);
}

// Is there t with height / r + slope (e + t) < sin t? Greatest where cos t = slope.
bool below_bridge(Real height_over_r, Real lambda, Real e) {
    if (lambda >= 1) return false;
    const Real t = std::acos(lambda);
    return height_over_r + lambda * (e + t) < std::sin(t);
}

enum class LightRule { outside, meets, meets_reversed, count };

LightRule light_rule(const Box& box) {
    const Real r_lo = 1 / static_cast<Real>(box.q1);
    const Real r_hi = 1 / static_cast<Real>(box.q0);
    const Real e1 = std::min(static_cast<Real>(box.e1), half_pi<Real>());
    const Real w1 = std::cos(e1);
    if (box.e1 < half_pi<Real>() && box.v0 * (w1 * w1 - r_hi) > 2 * w1) return LightRule::outside;
    if (below_bridge(std::sin(e1) / r_lo, box.v1, e1)) return LightRule::meets;
    if (w1 * w1 + 2 * r_lo * box.v0 * w1 - r_hi > 0) {
        const auto back = light_ray_reversed(LightState<Real>{e1, box.v0}, r_hi);
        const Real mu1 = std::max(back->kappa / r_hi, 0.0L);
        if (below_bridge(std::sin(e1) / r_lo, mu1, e1)) return LightRule::meets_reversed;
    }
    return LightRule::count;
}

}  // namespace

TEST_CASE("format 3.3: no trajectory of a box of the bridge chart exceeds its count leaf") {
    Sampler sampler(1, 501);
    int tight = 0;
    for (int i = 0; i < trials(30'000); ++i) {
        const Box box = random_box(sampler, i % 100 == 0 ? 1e5 : 500);
        const double q = biased(sampler, box.q0, box.q1);
        const BridgeState<double> state{std::min(biased(sampler, box.e0, box.e1), 1.5707963267948966),
                                        biased(sampler, box.v0, box.v1)};
        if (state.eta <= 0 || (std::cos(state.e) + state.eta) >= q) continue;
        const std::size_t bound = bridge_bound<Real>(box);
        const std::size_t found = total_collisions(Dumbbell<Real>(q), Start(state)).collisions;
        tight += found == bound;
        if (found > bound && careful_total(q, state) > bridge_bound<Digits80>(box)) {
            FAIL("found " << found << " bound " << bound << ' ' << text(box)
                          << say("at q", q, describe(state)));
        }
    }
    CHECK(tight > 2'000);
}

TEST_CASE("format 3.4: outside, meets, meets-reversed and count leaves of the light chart are right") {
    Sampler sampler(1, 502);
    int used[4] = {0, 0, 0, 0};
    for (int i = 0; i < trials(60'000); ++i) {
        const Box box = random_box(sampler, i % 100 == 0 ? 1e5 : 500);
        const LightRule rule = light_rule(box);
        const double q = biased(sampler, box.q0, box.q1);
        const LightState<double> state{std::min(biased(sampler, box.e0, box.e1), 1.5707963267948966),
                                       biased(sampler, box.v0, box.v1)};
        if (state.lambda >= q) continue;
        const Dumbbell<Real> body(q);
        const Contact<Real> contact = contact_of(body, LightState<Real>{state.e, state.lambda});
        const State<Real> before = body.bounce(Mass::light, contact.after);
        if (before.ydot > 0) continue;  // not turning: outside the section
        const Total<Real> total = total_collisions(body, contact);
        if (total.care.near_tangent(1e-12)) continue;
        ++used[static_cast<int>(rule)];
        std::string wrong;
        if (rule == LightRule::outside) wrong = "outside, but turning";
        if ((rule == LightRule::meets || rule == LightRule::meets_reversed) && total.heavy == 0)
            wrong = "never meets";
        if (rule == LightRule::count && total.heavy == 0) {
            const auto bound = light_bound<Real>(box);
            if (bound && total.collisions > *bound && careful_total(q, state) > *light_bound<Digits80>(box)) {
                wrong = say("found", total.collisions, "bound", *bound);
            }
        }
        if (!wrong.empty()) FAIL(wrong << ": " << text(box) << say("at q", q, describe(state)));
    }
    INFO(used[0] << ' ' << used[1] << ' ' << used[2] << ' ' << used[3]);
    CHECK(used[0] == 0);
    CHECK(used[1] > 500);
    CHECK(used[2] > 100);
    CHECK(used[3] > 5'000);
}

TEST_CASE("format 3.6, L11: a witness for a range of ratios has its collisions at every ratio of the range") {
    Sampler sampler(1, 503);
    int tight = 0;
    for (int i = 0; i < trials(40'000); ++i) {
        const double a = random_ratio(sampler, i % 100 == 0 ? 1e5 : 500);
        const double b = a * (1 + (sampler.coin() ? sampler.log_uniform(1e-9, 1) : 0));
        const Start start = Sampler(b, static_cast<std::uint64_t>(i))
                                .next(i % 2 == 0 ? Family::top_orbit : Family::corner_orbit);
        const auto& at = std::get<BridgeState<double>>(start);
        const Real r_hi = 1 / static_cast<Real>(a);
        const Real r_lo = 1 / static_cast<Real>(b);
        const BridgeState<Real> state{at.e, at.eta};
        if (!(at.e < 1.5707963L) || r_hi * (std::cos(state.e) + state.eta) >= 1) continue;
        const Ray<Real> back = bridge_ray_reversed(state, r_lo);  // eta' at r_lo; in units of r
        const Real c = back.c / r_lo;
        const Real lambda = back.kappa / r_lo;
        Ray<Real> highest{r_hi * c, r_hi * lambda};
        if (lambda < 0) {
            const auto x = hit_place(highest);
            const Real w = x ? std::cos(*x) : 0;
            const Real gap = w - r_lo * lambda;
            if (!(2 * w * gap * gap >= -lambda * (1 + r_hi) * (1 + r_hi))) highest.kappa = r_lo * lambda;
        }
        const std::size_t lower = 1 + ray_count(bridge_ray(state, r_hi), r_hi) + ray_count(highest, r_hi);
        const double q = biased(sampler, a, b);
        const std::size_t found = total_collisions(Dumbbell<Real>(q), start).collisions;
        tight += found == lower;
        if (found < lower && careful_total(q, start) < lower) {
            FAIL(say("q", q, "range", a, b, describe(start), "found", found, "promised", lower));
        }
    }
    CHECK(tight > 10'000);
}
