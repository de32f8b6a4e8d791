#include "critical/enclose.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "collisions/step_guess.hpp"
#include "flight/extremal_orbit.hpp"
#include "flight/macro/when.hpp"
#include "number/decimal.hpp"

namespace dumbbell::critical {

using flight::ExtremalFlight;

namespace {

constexpr int least_bits = 128;

/// The flight that decides, from its orbit's first; nothing if it is not certain at every r of the range that
/// the orbit comes so far, or if interrupted.
template <class State>
std::optional<State> last_flight(State state, const ExtremalFlight& flight, const Options& options) {
    for (long i = 1; i < flight.flight; ++i) {
        auto next = options.interrupted() ? std::nullopt : after_collision(state);
        if (!next) {
            return std::nullopt;
        }
        state = std::move(*next);
        if (i % flights_between_questions == 0) {
            options.observer->advance(flights_between_questions);
        }
    }
    return state;
}

/// Its margin.
std::optional<BigInterval> margin_at(const ExtremalFlight& flight, const BigInterval& r,
                                     const Options& options) {
    const auto last = last_flight(extremal_ray(flight.orbit, r), flight, options);
    return last ? std::optional(margin(*last)) : std::nullopt;
}

/// b_{k-1} of L27: the margin of flight k falls at least so fast with r.
BigInterval least_rate(const ExtremalFlight& flight) {
    const BigInterval k(static_cast<double>(flight.flight));
    return flight.orbit == flight::ExtremalOrbit::top
               ? BigInterval(1) + pi<BigInterval>() * k * (k - BigInterval(1))
               : pi<BigInterval>() * sqr(k);
}

/// r with exactly one zero of the margin.
struct Bracket {
    BigInterval range;
    BigInterval rate;  ///< the margin's derivative by r, all over the range
    BigInterval zero;  ///< in the range
};

/// The r where the margin is 0, from its value at a thin r of the bracket's range: every zero lies there, and
/// if that is in the range there is exactly one; nothing if it is not.
std::optional<BigInterval> newton(const Bracket& bracket, const BigInterval& r, const BigInterval& value) {
    const BigInterval zero = r - value / bracket.rate;
    const bool inside =
        certainly_at_most(low_end(bracket.range), zero) && certainly_at_most(zero, high_end(bracket.range));
    return inside ? std::optional(zero) : std::nullopt;
}

/// From a thin r in (0, 1], at the working precision; nothing if the interval Newton step proves nothing.
std::optional<Bracket> bracket_from(const BigInterval& r, const ExtremalFlight& flight,
                                    const Options& options) {
    const auto value = margin_at(flight, r, options);
    if (!value) {
        return std::nullopt;
    }
    // Formula (5) of theorem.md.
    const BigInterval range = min(r + hull(BigInterval(0), *value / least_rate(flight)), BigInterval(1));
    if (!certainly_positive(range)) {
        return std::nullopt;
    }
    const auto over = last_flight(first_moving_ray(flight.orbit, range), flight, options);
    Bracket bracket{range, over ? margin_rate(*over) : BigInterval(0), r};
    if (!certainly_positive(-bracket.rate)) {
        return std::nullopt;
    }
    const auto zero = newton(bracket, r, *value);
    if (!zero) {
        return std::nullopt;
    }
    bracket.zero = *zero;
    return bracket;
}

/// The digits, by Newton steps in the bracket at the working precision: each leaves of the zero's width the
/// share that the rate is uncertain by. Nothing if the steps come to nothing.
std::optional<Ratio> refined(long n, Bracket& bracket, const ExtremalFlight& flight, const Options& options) {
    for (;;) {
        const BigInterval r = midpoint(bracket.zero);
        const auto value = margin_at(flight, r, options);
        const auto zero = value ? newton(bracket, r, *value) : std::nullopt;
        if (!zero) {
            return std::nullopt;
        }
        Ratio result{.n = n,
                     .q_lo = Rational(1) / exact_hi(*zero),
                     .q_hi = Rational(1) / exact_lo(*zero),
                     .bits = PrecisionScope::current()};
        if (shared_digits(result.q_lo, result.q_hi, options.digits)) {
            return result;
        }
        const bool gains = width(*zero) < width(bracket.zero) / 1024;
        bracket.zero = *zero;
        if (!gains) {
            return std::nullopt;
        }
    }
}

/// Bits that should do: the digits, and what the orbit loses (its sensitivity grows like a power of k).
int expected_bits(int digits, long flight) {
    const double loss = 24 + 4 * std::log2(static_cast<double>(flight));
    return 64 * static_cast<int>(std::ceil((digits * std::log2(10.0) + loss) / 64));
}

}  // namespace

std::optional<Ratio> enclose_ratio(long n, const Options& options) {
    require(n >= 3 && options.digits >= 1 && options.digits <= most_digits,
            "critical ratio: out of the domain");
    const ExtremalFlight flight = flight::tangent_flight(n);
    if (flight::macro::is_long(n)) {
        return enclose_long_ratio(n, options);
    }
    Rational guess = Rational(1) / exact(collisions::guess_step(n, options.interrupted));
    const int enough = expected_bits(options.digits, flight.flight);
    for (int bits = least_bits; bits <= most_bits && !options.interrupted(); bits *= 2) {
        const PrecisionScope scope(bits);
        const BigInterval near = min(midpoint(enclose<BigInterval>(guess)), BigInterval(1));
        auto bracket = bracket_from(near, flight, options);
        if (!bracket) {
            continue;
        }
        // The rate needs half of the digits that the value needs.
        if (2 * bits >= enough) {
            const PrecisionScope finer(std::max(bits, enough));
            if (auto result = refined(n, *bracket, flight, options)) {
                return result;
            }
        }
        guess = exact_lo(midpoint(bracket->zero));
    }
    return std::nullopt;
}

}  // namespace dumbbell::critical
