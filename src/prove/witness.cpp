#include "prove/witness.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

#include "model/chart.hpp"
#include "model/count.hpp"

namespace dumbbell {
namespace {

/// below_peak(n) has n + 3 binary places.
constexpr int shortest_distance_bits = most_binary_places - 3;

Rational power_of_half(int n) { return Rational(1, Integer(1) << n); }

/// pi/2 - distance, cut to a dyadic with as few bits as keep it below pi/2 and close.
Rational below_peak(int distance_bits) {
    const int bits = distance_bits + 3;
    const PrecisionScope scope(bits + 16);
    const BigInterval scaled = (half_pi<BigInterval>() - enclose<BigInterval>(power_of_half(distance_bits))) *
                               enclose<BigInterval>(Rational(Integer(1) << bits));
    Integer numerator;
    mpfr_get_z(numerator.backend().data(), &scaled.raw()->left, MPFR_RNDD);
    return {numerator, Integer(1) << bits};
}

}  // namespace

template <class I>
std::optional<Witness> checked_witness(const Rational& e, const Rational& eta, const Rational& q_lo,
                                       const Rational& q_hi, long cap, const Interrupted& interrupted) {
    const RatioRange<I> range{enclose<I>(Rational(1) / q_hi), enclose<I>(Rational(1) / q_lo)};
    const I position_enclosure = enclose<I>(e);
    const I steepness = enclose<I>(eta);
    if (!certainly_positive(position_enclosure) || !certainly_less(position_enclosure, half_pi<I>()) ||
        !certainly_positive(steepness)) {
        return std::nullopt;
    }
    const Position<I> at = position(position_enclosure);
    const auto out = bridge_outgoing(at, steepness);
    if (!certainly_less(range.r_hi * out.lambda, I(1))) {
        return std::nullopt;
    }
    // sigma X must pass above the corner: its height there is least at r_hi, where eta' is.
    const I lowest_lambda = reversed_steepness(steepness, at.cos_e, range.r_hi) - at.cos_e;
    if (!certainly_positive(at.sin_e + lowest_lambda * at.e)) {
        return std::nullopt;
    }
    const auto reversed = bridge_reversed(at, steepness, range.r_lo);
    return Witness{e, eta, count_at_least(highest_over(out, range), cap, interrupted),
                   count_at_least(highest_over(reversed, range), cap, interrupted)};
}

template <class I>
std::optional<Witness> find_witness(const Rational& q_lo, const Rational& q_hi, long target,
                                    const Interrupted& interrupted) {
    const auto attempt = [&](const Rational& e, const Rational& eta) -> std::optional<Witness> {
        auto witness = checked_witness<I>(e, eta, q_lo, q_hi, target, interrupted);
        return witness && witness->total() >= target ? witness : std::nullopt;
    };
    const int bits = PrecisionScope::current();
    const int deepest = std::min(bits + 8, shortest_distance_bits);
    // Where half the precision does not suffice the distances are beyond that, nearly always.
    const int first = std::is_same_v<I, Interval> ? 1 : std::clamp(bits / 2 - 28, 1, deepest);
    for (int i = 0; i < deepest && !interrupted(); ++i) {
        const int depth = 1 + (first - 1 + i) % deepest;
        if (auto top = attempt(below_peak(depth), power_of_half(depth))) {
            return top;
        }
        // Near the corner the orbit tolerates a distance like the square root of the steepness.
        for (const int corner : {depth / 2, depth / 2 + 1, depth / 2 + 2}) {
            if (auto low = attempt(power_of_half(corner), power_of_half(depth))) {
                return low;
            }
        }
    }
    return std::nullopt;
}

template std::optional<Witness> checked_witness<Interval>(const Rational&, const Rational&, const Rational&,
                                                          const Rational&, long, const Interrupted&);
template std::optional<Witness> checked_witness<BigInterval>(const Rational&, const Rational&,
                                                             const Rational&, const Rational&, long,
                                                             const Interrupted&);
template std::optional<Witness> find_witness<Interval>(const Rational&, const Rational&, long,
                                                       const Interrupted&);
template std::optional<Witness> find_witness<BigInterval>(const Rational&, const Rational&, long,
                                                          const Interrupted&);

}  // namespace dumbbell
