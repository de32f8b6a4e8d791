#include "collisions/witness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "collisions/step_guess.hpp"
#include "file/dyadic.hpp"
#include "flight/chart.hpp"
#include "flight/count.hpp"

namespace dumbbell::collisions {
namespace {

/// below_peak(n) has n + 3 binary places.
constexpr int shortest_distance_bits = most_binary_places - 3;

/// pi/2 - distance, cut to a dyadic with as few bits as keep it below pi/2 and close.
Rational below_peak(int distance_bits) {
    const int bits = distance_bits + 3;
    const PrecisionScope scope(bits + 16);
    const BigInterval scaled = (half_pi<BigInterval>() - enclose<BigInterval>(power_of_half(distance_bits))) *
                               enclose<BigInterval>(Rational(Integer(1) << bits));
    const Rational low = exact_lo(scaled);  // positive: the quotient of integers is its floor
    return {numerator(low) / denominator(low), Integer(1) << bits};
}

/// The rays above both sides of the contact (e, eta), forward and backward, for every ratio of [q_lo, q_hi];
/// nothing if it is no admissible contact there.
template <class I>
std::optional<std::array<flight::Ray<I>, 2>> highest_rays(const Rational& e, const Rational& eta,
                                                          const Rational& q_lo, const Rational& q_hi) {
    const flight::RatioRange<I> range{enclose<I>(Rational(1) / q_hi), enclose<I>(Rational(1) / q_lo)};
    const I position_enclosure = enclose<I>(e);
    const I steepness = enclose<I>(eta);
    if (!certainly_positive(position_enclosure) || !certainly_less(position_enclosure, half_pi<I>()) ||
        !certainly_positive(steepness)) {
        return std::nullopt;
    }
    const flight::Position<I> at = flight::position(position_enclosure);
    const auto out = bridge_outgoing(at, steepness);
    if (!certainly_less(range.r_hi * out.lambda, I(1))) {
        return std::nullopt;
    }
    // sigma X must pass above the corner: its height there is least at r_hi, where eta' is.
    const I lowest_lambda = flight::reversed_steepness(steepness, at.cos_e, range.r_hi) - at.cos_e;
    if (!certainly_positive(at.sin_e + lowest_lambda * at.e)) {
        return std::nullopt;
    }
    return std::array{highest_over(out, range),
                      highest_over(bridge_reversed(at, steepness, range.r_lo), range)};
}

/// Places (e, eta) with steepness 2^-depth to look for a witness, the likeliest first. The greatest count
/// belongs to contacts near two limits (Theorem 1), at which it is not attained itself: an odd one to those
/// near the peak, an even one to those near the corner (2, of equal masses, near both). So the places
/// approach them by powers of two: at a coarse one the count is too small, at a fine one the precision no
/// longer tells.
std::vector<std::pair<Rational, Rational>> candidates(int depth, const Count& target) {
    const Rational eta = power_of_half(depth);
    if (target % 2 != 0 || target == 2) {
        return {{below_peak(depth), eta}};
    }
    // Near the corner the orbit tolerates a distance like the square root of the steepness.
    return {{power_of_half(depth / 2), eta},
            {power_of_half(depth / 2 + 1), eta},
            {power_of_half(depth / 2 + 2), eta}};
}

/// From which depth on to look for `target` collisions at q: where the places lose about as much height as
/// the orbit that decides (Theorem 2 (c)) has to spare, found by trial: of 2,300 pieces all but some have
/// their first witness there or at most three deeper.
template <class I>
int likely_depth(const Count& target, const Rational& q, const Interrupted& interrupted) {
    if constexpr (std::is_same_v<I, BigInterval>) {
        // The nearer to the extremal orbits, the better, as long as the precision tells them apart.
        return PrecisionScope::current() - 32;
    }
    if (target < 3) {
        return 1;
    }
    constexpr int near = 20;
    if (target >= flight::macro::first_long) {
        return near;
    }
    const long n = as_long(target);
    const double spare = guess_margin(n, enclose<Interval>(q).lo(), interrupted);
    return spare > 0 ? (n % 2 == 0 ? 2 : 3) - static_cast<int>(std::log2(spare * static_cast<double>(n)))
                     : near;
}

}  // namespace

template <class I>
std::optional<Witness> checked_witness(const Rational& e, const Rational& eta, const Rational& q_lo,
                                       const Rational& q_hi, const Count& cap,
                                       const Interrupted& interrupted) {
    const auto rays = highest_rays<I>(e, eta, q_lo, q_hi);
    if (!rays) {
        return std::nullopt;
    }
    std::array<flight::CountOf<I>, 2> counts;
    flight::each_count<I>(2, [&](std::size_t i) {
        counts[i] = count_at_least<I>((*rays)[i], flight::count_in<I>(cap), interrupted);
    });
    return Witness{e, eta, counts[0], counts[1]};
}

template <class I>
std::optional<Witness> find_witness(const Rational& q_lo, const Rational& q_hi, const Count& target,
                                    const Interrupted& interrupted) {
    const int deepest = std::min(PrecisionScope::current() + 8, shortest_distance_bits);
    const int first = std::clamp(likely_depth<I>(target, q_lo, interrupted), 1, deepest);
    for (int i = 0; i < deepest && !interrupted(); ++i) {
        for (const auto& [e, eta] : candidates(1 + (first - 1 + i) % deepest, target)) {
            auto witness = checked_witness<I>(e, eta, q_lo, q_hi, target, interrupted);
            if (witness && witness->total() >= target) {
                return witness;
            }
        }
    }
    return std::nullopt;
}

template std::optional<Witness> checked_witness<Interval>(const Rational&, const Rational&, const Rational&,
                                                          const Rational&, const Count&, const Interrupted&);
template std::optional<Witness> checked_witness<BigInterval>(const Rational&, const Rational&,
                                                             const Rational&, const Rational&, const Count&,
                                                             const Interrupted&);
template std::optional<Witness> find_witness<Interval>(const Rational&, const Rational&, const Count&,
                                                       const Interrupted&);
template std::optional<Witness> find_witness<BigInterval>(const Rational&, const Rational&, const Count&,
                                                          const Interrupted&);

}  // namespace dumbbell::collisions
