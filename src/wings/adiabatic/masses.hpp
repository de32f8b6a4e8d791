#pragma once

/// The masses of the paper's section 3: beta1 = epsilon = delta^2, beta2 = 1 - delta^2 (proofs/adiabatic.md,
/// Setting).
namespace dumbbell::adiabatic {

/// An increasing function over the interval x, from its two ends.
template <class I, class Function>
[[nodiscard]] I increasing(const Function& function, const I& x) {
    return hull(function(low_end(x)), function(high_end(x)));
}

/// What depends on delta alone, over an interval of delta.
template <class I>
struct Masses {
    I delta;
    I beta2;
    I r;       ///< beta1/beta2, the inverse mass ratio
    I root_r;  ///< delta/sqrt(beta2)
    I delta_over_beta2;

    /// Precondition: 0 <= delta < 1.
    explicit Masses(const I& d)
        : delta(d),
          beta2(I(1) - sqr(d)),
          r(increasing([](const I& x) { return sqr(x) / (I(1) - sqr(x)); }, d)),
          root_r(increasing([](const I& x) { return x / sqrt(I(1) - sqr(x)); }, d)),
          delta_over_beta2(increasing([](const I& x) { return x / (I(1) - sqr(x)); }, d)) {}
};

/// delta^(sixteenths/16) for delta >= 0.
template <class I>
[[nodiscard]] I delta_power(const I& delta, int sixteenths) {
    I root = delta;
    for (int i = 0; i < 4; ++i) {
        root = sqrt(root);
    }
    I power(1);
    for (; sixteenths > 0; sixteenths /= 2) {
        if (sixteenths % 2 == 1) {
            power = power * root;
        }
        root = sqr(root);
    }
    return power;
}

}  // namespace dumbbell::adiabatic
