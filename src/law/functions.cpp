#include "law/functions.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace dumbbell::law {
namespace {

/// 1 - y/6 (1 - y/20 (1 - y/42 (...))), y = x^2. For y <= 6 each bracket lies in [0, 1] if the one in it
/// does, so the last one may be replaced by [0, 1].
Interval sinc_at(double x) {
    constexpr int last = 12;
    static const std::array<Interval, last> factors = [] {
        std::array<Interval, last> result;
        for (int k = 1; k <= last; ++k) {
            result[static_cast<std::size_t>(k - 1)] = Interval(1) / Interval(2 * k * (2 * k + 1));
        }
        return result;
    }();
    const Interval y = sqr(Interval(x));
    std::size_t terms = last;
    if (y.hi() < 0.01) {
        terms = 6;
    } else if (y.hi() > 6) {
        return {-1, 1};
    }
    Interval bracket(0, 1);
    for (std::size_t k = terms; k-- > 0;) {
        bracket = 1 - y * factors[k] * bracket;
    }
    return bracket;
}

}  // namespace

Interval sinc(const Interval& x) {
    if (x.is_nan()) {
        return x;
    }
    return {sinc_at(std::max(0.0, x.hi())).lo(), sinc_at(std::max(0.0, x.lo())).hi()};
}

Interval H2_monotone(const Interval& F, const Interval& Q) {
    if (F.is_nan() || Q.is_nan() || !(Q.lo() > 0) || !(F.lo() > Q.hi())) {
        return Interval(std::numeric_limits<double>::quiet_NaN());
    }
    const auto at = [](const Interval& f, const Interval& q) {
        const Interval R = sqr(f) - sqr(q);
        return 3 * (q * f) / (sqr(R) * sqrt(R));
    };
    return {at(high_end(F), low_end(Q)).lo(), at(low_end(F), high_end(Q)).hi()};
}

LastDerivatives last_derivatives(const Interval& F, const Interval& Q) {
    const Interval R = sqr(F) - sqr(Q);
    const Interval r1 = 1 / sqrt(R), r3 = r1 / R, r5 = r3 / R, r7 = r5 / R, r9 = r7 / R;
    const Interval f = 1 / F, f2 = sqr(f);
    return {-(Q * (6 * (sqr(f2) * r1) + 3 * (f2 * r3) + 15 * (sqr(F) * r7))),
            Q * (24 * (sqr(f2) * f * r1) + 12 * (f * f2 * r3) + 9 * (f * r5) - 30 * (F * r7) +
                 105 * (F * sqr(F) * r9))};
}

template <class X>
X midpoint_error(const Interval& U, const Interval& d_per_U, const X& F, const X& Q, const X& sin_U,
                 const X& cos_U) {
    const Interval d = d_per_U * U, d2 = sqr(d), third = Interval(1) / 3;
    // (1/3)[1 - d^2/k, 1]
    const auto nearly_third = [&](const Interval& over_k) {
        return quantity<X>(third * at_most_one(d2 * over_k), third,
                           -(sqr(d_per_U) * U * over_k / 3 * Interval(0, 1)));
    };
    const X I2 = nearly_third(Interval(3) / 10), J1 = nearly_third(Interval(1) / 10);
    const auto fifth_of_square = [&](const Interval& factor) {
        return quantity<X>(d2 / 5 * factor, Interval(0), sqr(d_per_U) * U / 5 * factor);
    };
    const X I4 = fifth_of_square(at_most_one(d2 / 2)), J3 = fifth_of_square(at_most_one(d2 / 6));
    const auto [G1, G2] = first_derivatives(F, Q);
    const Interval around = hull(range(F) - d, range(F) + d);
    const auto [G3, G4] = last_derivatives(around, range(Q));
    return sin_U * (G2 * I2 + I4 * (G4 / 12)) - 2 * (cos_U * (G1 * J1 + J3 * (G3 / 6)));
}

template Interval midpoint_error(const Interval&, const Interval&, const Interval&, const Interval&,
                                 const Interval&, const Interval&);
template Slope midpoint_error(const Interval&, const Interval&, const Slope&, const Slope&, const Slope&,
                              const Slope&);

Interval second_moment(const Interval& u, const Interval& Q, int n) {
    Interval sum(0);
    for (int i = 0; i < n; ++i) {
        const Interval x = u * part(i, n);
        // (t1^2 - t0^2)/2 = (2i + 1)/(2n^2)
        sum = sum + sinc(x) * H2_monotone(pi<Interval>() - x, Q) * share(2 * i + 1, 2 * n * n);
    }
    return sum;
}

Interval comparison_constant() {
    const Interval root = sqrt(Interval(3));
    return 1 / (3 * root * sqrt(root) * sqrt(pi<Interval>()));
}

Interval common(const Interval& x, const Interval& y) {
    if (x.is_nan() || y.is_nan() || x.hi() < y.lo() || y.hi() < x.lo()) {
        return Interval(std::numeric_limits<double>::quiet_NaN());
    }
    return {std::max(x.lo(), y.lo()), std::min(x.hi(), y.hi())};
}

}  // namespace dumbbell::law
