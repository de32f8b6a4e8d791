#include "collisions/critical.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "collisions/critical_guess.hpp"
#include "collisions/critical_long.hpp"
#include "flight/extremal_orbit.hpp"
#include "number/decimal.hpp"

namespace dumbbell::collisions {

using flight::ExtremalFlight;

namespace {

constexpr int least_bits = 128;
constexpr int most_bits = 16384;

/// The margin of the flight that decides, for all r of a range; nothing if it is not certain that the orbit
/// comes so far at each of them, or if interrupted.
std::optional<flight::Margin<BigInterval>> margin_over(const ExtremalFlight& flight, const BigInterval& r,
                                                       const CriticalOptions& options) {
    auto ray = first_moving_ray(flight.orbit, r);
    for (long i = 1; i < flight.flight; ++i) {
        auto next = options.interrupted() ? std::nullopt : after_collision(ray);
        if (!next) {
            return std::nullopt;
        }
        ray = std::move(*next);
        if (i % flights_between_questions == 0) {
            options.observer->advance(flights_between_questions);
        }
    }
    return margin(ray);
}

/// b_{k-1} of L27: the margin of flight k falls at least so fast with r.
BigInterval least_rate(const ExtremalFlight& flight) {
    const BigInterval k(static_cast<double>(flight.flight));
    return flight.orbit == flight::ExtremalOrbit::top
               ? BigInterval(1) + pi<BigInterval>() * k * (k - BigInterval(1))
               : pi<BigInterval>() * sqr(k);
}

/// A thin r in (0, 1] at the working precision.
BigInterval point_near(const Rational& r) { return min(midpoint(enclose<BigInterval>(r)), BigInterval(1)); }

/// The r of a Newton step from the thin r: a guess.
Rational improved(const BigInterval& r, const flight::Margin<BigInterval>& at) {
    const BigInterval next = midpoint(r - at.value / at.rate);
    return exact_lo(certainly_positive(next) ? next : r);
}

/// An enclosure of 1/q_c from a thin r in (0, 1], at the working precision; nothing if the interval Newton
/// step proves nothing.
std::optional<BigInterval> enclosure_from(const BigInterval& r, const ExtremalFlight& flight,
                                          const CriticalOptions& options) {
    const auto at_r = margin_over(flight, r, options);
    if (!at_r) {
        return std::nullopt;
    }
    // Formula (5) of theorem.md.
    const BigInterval bracket =
        min(r + hull(BigInterval(0), at_r->value / least_rate(flight)), BigInterval(1));
    if (!certainly_positive(bracket)) {
        return std::nullopt;
    }
    const auto over = margin_over(flight, bracket, options);
    if (!over || !certainly_positive(-over->rate)) {
        return std::nullopt;
    }
    // Every zero of the margin in the bracket lies in `newton`; if that is inside, there is exactly one.
    const BigInterval newton = r - at_r->value / over->rate;
    const bool inside =
        certainly_at_most(low_end(bracket), newton) && certainly_at_most(newton, high_end(bracket));
    return inside ? std::optional(newton) : std::nullopt;
}

/// Bits that should do: the digits, and what the orbit loses (its sensitivity grows like a power of k).
int expected_bits(int digits, long flight) {
    const double loss = 24 + 4 * std::log2(static_cast<double>(flight));
    int bits = least_bits;
    while (bits < digits * std::log2(10.0) + loss) {
        bits *= 2;
    }
    return bits;
}

}  // namespace

std::optional<CriticalRatio> enclose_critical_ratio(long n, const CriticalOptions& options) {
    require(n >= 3 && options.digits >= 1 && options.digits <= most_critical_digits,
            "critical ratio: out of the domain");
    const ExtremalFlight flight = flight::tangent_flight(n);
    if (is_long(n)) {
        return enclose_long_critical_ratio(n, options);
    }
    Rational guess = Rational(1) / exact(guess_critical_ratio(n, options.interrupted));

    int bits = least_bits;
    for (const int enough = expected_bits(options.digits, flight.flight); bits < enough; bits *= 2) {
        const PrecisionScope scope(bits);
        for (int i = 0; i < 2; ++i) {  // each step doubles the digits, up to the precision
            const BigInterval r = point_near(guess);
            const auto at_r = margin_over(flight, r, options);
            guess = at_r ? improved(r, *at_r) : guess;
        }
    }
    for (; bits <= most_bits; bits *= 2) {
        const PrecisionScope scope(bits);
        for (int i = 0; i < 3; ++i) {
            const auto r = enclosure_from(point_near(guess), flight, options);
            if (options.interrupted()) {
                return std::nullopt;
            }
            if (!r) {
                break;
            }
            CriticalRatio result{
                .n = n, .q_lo = Rational(1) / exact_hi(*r), .q_hi = Rational(1) / exact_lo(*r), .bits = bits};
            if (shared_digits(result.q_lo, result.q_hi, options.digits)) {
                return result;
            }
            guess = exact_lo(midpoint(*r));
        }
    }
    return std::nullopt;
}

bool certainly_encloses(const CriticalRatio& ratio, const Interrupted& interrupted) {
    if (ratio.n == 3) {
        return ratio.q_lo <= 1 && ratio.q_hi >= 1;
    }
    if (is_long(ratio.n)) {
        return certainly_encloses_by_counts(ratio, interrupted);
    }
    // At the ends of an enclosure as narrow as its precision permits the margin is a few units in the last
    // place.
    const PrecisionScope scope(2 * ratio.bits);
    const ExtremalFlight flight = flight::tangent_flight(ratio.n);
    const CriticalOptions options{.interrupted = interrupted};
    const auto margin_at = [&](const Rational& q) {
        return margin_over(flight, enclose<BigInterval>(Rational(1) / q), options);
    };
    const auto below = margin_at(ratio.q_lo);
    const auto above = margin_at(ratio.q_hi);
    return below && above && certainly_positive(-below->value) && certainly_positive(above->value);
}

std::optional<long> bound_by_theorem(const Rational& q) {
    if (q > 1'000'000) {
        return std::nullopt;
    }
    const long guess = guess_maximum(q.convert_to<double>());
    for (long n = std::max(2L, guess - 1); n <= guess + 1; ++n) {
        const auto step = enclose_critical_ratio(n + 1, {});
        if (step && q <= step->q_lo) {
            return n;
        }
    }
    return std::nullopt;
}

}  // namespace dumbbell::collisions
