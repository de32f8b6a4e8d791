#pragma once

#include <algorithm>
#include <numbers>
#include <optional>

#include "adiabatic/contact.hpp"
#include "adiabatic/potential.hpp"
#include "flight/contact.hpp"

/// The drift of S along one flight (proofs/adiabatic.md, L34, L35), over a box of flights.
namespace dumbbell::adiabatic {

/// Flights between two contacts of the light mass, given by the upper one at corner distance `x` and the
/// slope k = sigma sqrt(r) >= 0.
template <class I>
struct LightFlights {
    I x;
    I sigma;
    I k;
    Masses<I> masses;

    LightFlights(const I& upper, const I& s, const Masses<I>& m)
        : x(upper),
          sigma(s),
          k(s * m.root_r),
          masses(m),
          least_(low_end(x), high_end(k)),
          greatest_(high_end(x), low_end(k)),
          may_come_from_below_(certainly_at_most(low_end(k), cos(high_end(x)))) {}

    /// Bounds of X(lambda), the root of L34 for the slope lambda k, lambda in [-1, 1] exact: it increases
    /// with lambda and x and decreases with k. Of flights with a lower contact, and with k < cos x. `start`:
    /// a guess.
    [[nodiscard]] I least_root(const I& lambda, double start = flight::no_start) const {
        const auto [c, l] = least_.line(lambda);
        const auto contact = flight::lowest_contact(low_end(c), low_end(l), start);
        return contact ? max(I(0), min(contact->x, low_end(x))) : low_end(x);
    }
    [[nodiscard]] I greatest_root(const I& lambda, double start = flight::no_start) const {
        const auto [c, l] = greatest_.line(lambda);
        const I from = high_end(c);
        if (!may_come_from_below_ || !certainly_at_most(I(0), from)) {
            return high_end(x);
        }
        const auto contact = flight::highest_contact(from, high_end(l), start);
        return contact ? min(contact->x, high_end(x)) : high_end(x);
    }

  private:
    struct Line {
        I c;
        I slope;
    };
    /// The lines of the slopes lambda `slope` of flights with this upper contact and slope.
    struct Lines {
        I slope;
        I at_zero;  ///< c for lambda = 0

        Lines(const I& upper, const I& k) : slope(k), at_zero(sin(upper) - k * (half_pi<I>() + upper)) {}
        [[nodiscard]] Line line(const I& lambda) const {
            return {at_zero + lambda * slope * half_pi<I>(), lambda * slope};
        }
    };

    Lines least_, greatest_;
    bool may_come_from_below_;  ///< the line of least slope through the highest contact, there
};

/// A' and B of L34 at contacts of the line of slope l. Precondition: w - l > 0.
template <class I>
struct DriftRates {
    I second;  ///< A'
    I first;   ///< B
};

template <class I>
[[nodiscard]] DriftRates<I> drift_rates(const LightContact<I>& at, const I& l, const Masses<I>& m) {
    const I one(1);
    const I two(2);
    const I z = sqr(at.w);
    const I e = m.r / z;
    const I e1 = one + e;
    const I rho = sqrt(z + two * m.r + sqr(m.r));
    const I slack = at.w - l;
    const I sweep = at.f * at.F;
    const I a = (one - e) / (sqr(e1) * z);
    const I b = two * sqr(at.s) * (one - I(3) * e) / (e1 * sqr(e1) * z * at.w);
    const I n = sweep * at.s * a;
    const I n_x = a * (at.w / rho * at.F * at.s + at.f * at.s + sweep * at.w) + sweep * b;
    const I second = (at.F * n_x + n * (one + at.F * at.s / slack)) / sqr(slack);
    const I zeta = m.beta2 * at.s * (two + m.r) / (rho + at.w);
    const I asin_over_r = zeta * hull(one, one / sqrt(one - sqr(zeta * m.r)));
    const I first = two * sweep * at.s / (slack * at.w * z * sqr(e1)) +
                    (at.F * (two + m.r) / (rho * (rho + at.w)) - asin_over_r) / (at.w * e1);
    return {second, first};
}

/// The division of [-1, 1] over which the drift is summed, finer towards 1, where a flight that descends from
/// near the vertical changes its contact most: lambda_i = 1 - 2 ((n - i)/n)^3, exact because n is a power of
/// two.
inline constexpr int drift_parts = 64;

[[nodiscard]] constexpr double drift_part_end(int i, int n = drift_parts) {
    const double left = static_cast<double>(n - i) / n;
    return 1 - 2 * left * left * left;
}

/// Where the next root of a flight's line, part after part, seems to be: a guess.
class RootTrend {
  public:
    void add(double x) {
        next_ = last_ < 0 ? x : std::clamp(x + (x - last_), 0.0, std::numbers::pi / 2);
        last_ = x;
    }
    [[nodiscard]] double next() const { return next_; }

  private:
    double last_ = -1, next_ = flight::no_start;
};

/// Both sides of (D) of L35, summed over the parts: the drift, and the least growth of the potential.
/// Nothing where the flight may be steeper than the wall.
template <class I>
struct DriftSums {
    I drift;
    I growth;
};

/// `density`: from an interval of angles to a lower bound of v.
template <class I, class Density>
[[nodiscard]] std::optional<DriftSums<I>> drift_sums(const LightFlights<I>& flights, const Density& density) {
    const I half_sigma2 = sqr(flights.sigma) / I(2);
    DriftSums<I> sums{I(0), I(0)};
    RootTrend lower, upper;
    I least = flights.least_root(I(-1));
    for (int i = 0; i < drift_parts; ++i) {
        const I lo(drift_part_end(i));
        const I hi(drift_part_end(i + 1));
        const I greatest = flights.greatest_root(hi, upper.next());
        upper.add(approximate(greatest));
        lower.add(approximate(least));
        const LightContact<I> at = light_contact(hull(least, greatest), flights.masses.beta2);
        const I l = hull(lo, hi) * flights.k;
        if (!certainly_positive(at.w - l)) {
            return std::nullopt;
        }
        const DriftRates<I> rates = drift_rates(at, l, flights.masses);
        const I mean = I(1) - (sqr(lo) + lo * hi + sqr(hi)) / I(3);  // of 1 - lambda^2
        sums.drift = sums.drift + (hi - lo) * (rates.second * half_sigma2 * mean + rates.first);
        sums.growth = sums.growth + (hi - lo) * (density(half_pi<I>() - at.x) * at.F / (at.w - l));
        least = flights.least_root(hi, lower.next());
    }
    sums.growth = sums.growth * sqrt(I(1) + sqr(flights.sigma));
    return sums;
}

}  // namespace dumbbell::adiabatic
