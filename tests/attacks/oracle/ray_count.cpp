#include "ray_count.hpp"

#include <algorithm>

#include "scalar.hpp"

namespace dumbbell_oracle {

template <class S>
S greatest_excess(const Ray<S>& ray) {
    using std::acos;
    using std::sqrt;
    // sin x - kappa x is greatest at cos x = kappa, or at the peak for a falling ray.
    if (ray.kappa <= 0) return S(1) - ray.kappa * pi<S>() / 2 - ray.c;
    return sqrt((1 - ray.kappa) * (1 + ray.kappa)) - ray.kappa * acos(ray.kappa) - ray.c;
}

template <class S>
std::optional<S> hit_place(const Ray<S>& ray) {
    using std::cos;
    using std::sin;
    if (ray.kappa >= 1 || !(greatest_excess(ray) > 0)) return std::nullopt;
    // Newton on a concave increasing function climbs to the least root from the left and never passes it.
    S x = 0;
    for (int i = 0; i < 1000; ++i) {
        const S excess = sin(x) - ray.c - ray.kappa * x;
        const S slope = cos(x) - ray.kappa;
        if (excess >= 0 || slope <= 0) break;
        const S next = x - excess / slope;
        if (!(next > x)) break;
        x = next;
    }
    return x;
}

template <class S>
std::optional<S> slope_after(const S& kappa, const S& x, const S& r) {
    using std::cos;
    const S w = cos(x);
    const S d = w * w - 2 * kappa * w - r;
    if (d <= 0) return std::nullopt;
    return S((kappa * w * w + 2 * r * w - r * kappa) / d);
}

template <class S>
std::optional<Step<S>> step(const Ray<S>& ray, const S& r) {
    using std::sin;
    const std::optional<S> x = hit_place(ray);
    if (!x) return std::nullopt;
    Step<S> result{*x, std::nullopt};
    const std::optional<S> kappa = slope_after(ray.kappa, *x, r);
    if (kappa && *kappa < 1) result.next = Ray<S>{S(sin(*x) + *kappa * (*x + pi<S>())), *kappa};
    return result;
}

template <class S>
std::size_t ray_count(Ray<S> ray, const S& r, S* margin) {
    using std::abs;
    using std::cos;
    const auto decided = [&](const S& value) { *margin = std::min(*margin, S(abs(value))); };
    if (margin) decided(1 - ray.kappa);
    std::size_t count = 0;
    for (;;) {
        if (margin && ray.kappa < 1) decided(greatest_excess(ray));
        const std::optional<Step<S>> taken = step(ray, r);
        if (!taken) return count;
        ++count;
        if (margin) {
            const S w = cos(taken->x);
            decided(w * w - 2 * ray.kappa * w - r);
            if (const auto kappa = slope_after(ray.kappa, taken->x, r)) decided(1 - *kappa);
        }
        if (!taken->next) return count;
        ray = *taken->next;
    }
}

template <class S>
Ray<S> bridge_ray(const BridgeState<S>& state, const S& r) {
    using std::cos;
    using std::sin;
    const S lambda = cos(state.e) + state.eta;
    return {S(r * (sin(state.e) + lambda * (pi<S>() - state.e))), S(r * lambda)};
}

template <class S>
Ray<S> bridge_ray_reversed(const BridgeState<S>& state, const S& r) {
    using std::cos;
    using std::sin;
    const S s = cos(state.e);
    const S eta = state.eta * (1 + r * s * s) / (1 + r * s * s + 2 * r * s * state.eta);
    return {S(r * (sin(state.e) + (eta - s) * state.e)), S(r * (eta - s))};
}

template <class S>
Ray<S> light_ray(const LightState<S>& state, const S& r) {
    using std::sin;
    const S kappa = r * state.lambda;
    return {S(sin(state.e) + kappa * (pi<S>() + state.e)), kappa};
}

template <class S>
std::optional<Ray<S>> light_ray_reversed(const LightState<S>& state, const S& r) {
    using std::cos;
    using std::sin;
    const S w = cos(state.e);
    const S d = w * w + 2 * r * state.lambda * w - r;
    if (d <= 0) return std::nullopt;
    const S kappa = r * (2 * w + r * state.lambda - state.lambda * w * w) / d;
    return Ray<S>{S(sin(state.e) + kappa * (pi<S>() + state.e)), kappa};
}

template <class S>
Theorem theorem(const S& ratio) {
    const S r = 1 / ratio;
    return {ray_count(Ray<S>{r, S(0)}, r), ray_count(Ray<S>{S(pi<S>() * r), r}, r)};
}

#define DUMBBELL_ORACLE_INSTANTIATE(S)                                                 \
    template S greatest_excess(const Ray<S>&);                                         \
    template std::optional<S> hit_place(const Ray<S>&);                                \
    template std::optional<S> slope_after(const S&, const S&, const S&);               \
    template std::optional<Step<S>> step(const Ray<S>&, const S&);                     \
    template std::size_t ray_count(Ray<S>, const S&, S*);                              \
    template Ray<S> bridge_ray(const BridgeState<S>&, const S&);                       \
    template Ray<S> bridge_ray_reversed(const BridgeState<S>&, const S&);              \
    template Ray<S> light_ray(const LightState<S>&, const S&);                         \
    template std::optional<Ray<S>> light_ray_reversed(const LightState<S>&, const S&); \
    template Theorem theorem(const S&);
DUMBBELL_ORACLE_INSTANTIATE(long double)
DUMBBELL_ORACLE_INSTANTIATE(Digits80)
#undef DUMBBELL_ORACLE_INSTANTIATE

}  // namespace dumbbell_oracle
