#include "collisions/critical_long.hpp"

#include <algorithm>
#include <cmath>

#include "flight/count.hpp"
#include "flight/extremal_orbit.hpp"
#include "flight/growth_constant.hpp"
#include "number/decimal.hpp"

namespace dumbbell::collisions {

using flight::ExtremalFlight;
using flight::Ray;

namespace {

/// Macro steps with so many bits lose about 2^-share_bits of a collision's progress.
int bits_for(int share_bits) { return 4 * (share_bits + 24); }

/// C, or with many bits a number near it: any would do, and the quadrature of C, which nothing interrupts,
/// takes minutes for some thousand bits.
BigInterval nearly_growth_constant() {
    constexpr int most_bits = 512;  // some milliseconds
    const PrecisionScope scope(std::min(most_bits, PrecisionScope::current()));
    return flight::growth_constant();
}

/// C sqrt q - (n - 2), the place of q between the steps, is what the search is for. Near 0, where the step to
/// n lies, the margin of the flight that decides is nearly a linear function of it.
class Search {
  public:
    /// Works with the precision of the present scope.
    Search(long n, const Interrupted& interrupted)
        : flight_(flight::tangent_flight(n)),
          last_(enclose<BigInterval>(Rational(n - 2))),
          growth_(nearly_growth_constant()),
          interrupted_(interrupted) {}

    [[nodiscard]] Rational ratio(const BigInterval& place) const {
        return exact_lo(midpoint(sqr((last_ + place) / growth_)));
    }

    /// Where the margin seems to be 0, by the secant method from two places; nothing if the orbit does not
    /// come so far near them, or does not get there.
    [[nodiscard]] std::optional<BigInterval> zero(BigInterval before, BigInterval place,
                                                  int share_bits) const {
        constexpr int most_steps = 12;
        auto value_before = margin_at(before);
        for (int i = 0; i < most_steps && value_before; ++i) {
            const auto value = margin_at(place);
            if (!value || interrupted_()) {
                return std::nullopt;
            }
            const BigInterval distance = place - before;
            const BigInterval change = midpoint(*value * distance / (*value - *value_before));
            before = place;
            value_before = value;
            place = midpoint(place - change);
            // The next error is about the product of the last two.
            if (std::abs(approximate(change * distance)) < std::ldexp(1, -share_bits)) {
                return place;
            }
        }
        return std::nullopt;
    }

  private:
    /// Of the flight that decides; thin, and nearly right.
    [[nodiscard]] std::optional<BigInterval> margin_at(const BigInterval& place) const {
        const BigInterval r = midpoint(BigInterval(1) / enclose<BigInterval>(ratio(place)));
        std::optional<flight::Ray<BigInterval>> last;
        (void)count_at_most(extremal_ray(flight_.orbit, r), flight_.flight - 1, interrupted_,
                            [&](const Count& count, const BigInterval& c, const BigInterval& kappa) {
                                if (count == flight_.flight - 1) {
                                    last = {c, kappa, r};
                                }
                            });
        return last ? std::optional(midpoint(margin(*last))) : std::nullopt;
    }

    ExtremalFlight flight_;
    BigInterval last_, growth_;
    const Interrupted& interrupted_;
};

/// The place of the step to n between the steps before and after it, to about 2^-share_bits.
std::optional<BigInterval> place_of_step(long n, int share_bits, const Interrupted& interrupted) {
    // By the law the place lies a little above 0; few bits lead near it, and two places near it to the rest.
    constexpr int first_bits = 24;
    BigInterval place(0);
    double near = 0x1p-6;
    for (const int share : {std::min(first_bits, share_bits), share_bits}) {
        const PrecisionScope scope(bits_for(share));
        const auto found = Search(n, interrupted).zero(place + BigInterval(near), place, share);
        if (!found || share == share_bits) {
            return found;
        }
        place = *found;
        near = std::ldexp(1, 4 - share);
    }
    return std::nullopt;
}

}  // namespace

std::optional<Rational> guess_long_critical_ratio(long n, int share_bits, const Interrupted& interrupted) {
    const PrecisionScope scope(bits_for(share_bits));
    const auto place = place_of_step(n, share_bits, interrupted);
    return place ? std::optional(Search(n, interrupted).ratio(*place)) : std::nullopt;
}

bool certainly_encloses_by_counts(const CriticalRatio& ratio, const Interrupted& interrupted) {
    const PrecisionScope scope(ratio.bits);
    const ExtremalFlight flight = flight::tangent_flight(ratio.n);
    const auto ray = [&](const Rational& q) {
        return extremal_ray(flight.orbit, enclose<BigInterval>(Rational(1) / q));
    };
    return count_at_most(ray(ratio.q_lo), flight.flight - 1, interrupted) < flight.flight &&
           count_at_least(ray(ratio.q_hi), flight.flight, interrupted) >= flight.flight;
}

std::optional<CriticalRatio> enclose_long_critical_ratio(long n, const CriticalOptions& options) {
    // So close to a decimal of that many digits hardly any ratio lies; then more of them help.
    for (int digits = options.digits + 2; bits_for(4 * digits) <= most_critical_bits; digits += 5) {
        // Relative distances are 2/n times those between the steps.
        const double share = std::log2(10.) * digits - std::log2(static_cast<double>(n)) + 1;
        const int share_bits = std::max(8, static_cast<int>(share) + 6);
        const PrecisionScope scope(bits_for(share_bits));
        const auto place = place_of_step(n, share_bits, options.interrupted);
        if (options.interrupted()) {
            return std::nullopt;
        }
        if (!place) {
            continue;
        }
        const Search search(n, options.interrupted);
        const BigInterval half(std::ldexp(1, 5 - share_bits));
        CriticalRatio result{.n = n,
                             .q_lo = search.ratio(*place - half),
                             .q_hi = search.ratio(*place + half),
                             .bits = bits_for(share_bits)};
        if (shared_digits(result.q_lo, result.q_hi, options.digits) &&
            certainly_encloses_by_counts(result, options.interrupted)) {
            return result;
        }
    }
    return std::nullopt;
}

}  // namespace dumbbell::collisions
