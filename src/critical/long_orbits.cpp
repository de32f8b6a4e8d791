#include <algorithm>
#include <cmath>

#include "collisions/step_guess.hpp"
#include "critical/enclose.hpp"
#include "flight/count.hpp"
#include "flight/extremal_orbit.hpp"
#include "number/decimal.hpp"

namespace dumbbell::critical {

bool certainly_encloses_by_counts(const Ratio& ratio, const Interrupted& interrupted) {
    const PrecisionScope scope(ratio.bits);
    const flight::ExtremalFlight flight = flight::tangent_flight(ratio.n);
    const auto ray = [&](const Rational& q) {
        return extremal_ray(flight.orbit, enclose<BigInterval>(Rational(1) / q));
    };
    return count_at_most(ray(ratio.q_lo), flight.flight - 1, interrupted) < flight.flight &&
           count_at_least(ray(ratio.q_hi), flight.flight, interrupted) >= flight.flight;
}

std::optional<Ratio> enclose_long_ratio(long n, const Options& options) {
    // So close to a decimal of that many digits hardly any ratio lies; then more of them help.
    for (int digits = options.digits + 2; collisions::bits_of_step(4 * digits) <= most_bits; digits += 5) {
        // Relative distances are 2/n times those between the steps.
        const double share = std::log2(10.) * digits - std::log2(static_cast<double>(n)) + 1;
        const int share_bits = std::max(8, static_cast<int>(share) + 6);
        const auto step = collisions::find_step(n, share_bits, options.interrupted);
        if (options.interrupted()) {
            return std::nullopt;
        }
        if (!step) {
            continue;
        }
        Ratio result{
            .n = n, .q_lo = step->below, .q_hi = step->above, .bits = collisions::bits_of_step(share_bits)};
        if (shared_digits(result.q_lo, result.q_hi, options.digits) &&
            certainly_encloses_by_counts(result, options.interrupted)) {
            return result;
        }
    }
    return std::nullopt;
}

}  // namespace dumbbell::critical
