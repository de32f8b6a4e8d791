#include "collisions/witness.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <type_traits>
#include <vector>

#include "file/dyadic.hpp"
#include "flight/batch/count.hpp"
#include "flight/chart.hpp"
#include "flight/count.hpp"

namespace dumbbell::collisions {
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

/// A place to look for a witness.
struct Candidate {
    Rational e;
    Rational eta;
};

/// Those with steepness 2^-depth, the likeliest first. The greatest count belongs to contacts near two limits
/// (Theorem 1), the peak and the corner, at which it is not attained itself. So the places approach them by
/// powers of two: at a coarse one the count is too small, at a fine one the precision no longer tells. Which
/// one serves is not known beforehand, and few need to be tried.
std::array<Candidate, 4> candidates(int depth) {
    const Rational eta = power_of_half(depth);
    // Near the corner the orbit tolerates a distance like the square root of the steepness.
    return {{{below_peak(depth), eta},
             {power_of_half(depth / 2), eta},
             {power_of_half(depth / 2 + 1), eta},
             {power_of_half(depth / 2 + 2), eta}}};
}

/// Looks for a witness in double, with the batch kernel.
class BatchSearch {
  public:
    BatchSearch(const Rational& q_lo, const Rational& q_hi, long target, const Interrupted& interrupted)
        : q_lo_(q_lo), q_hi_(q_hi), target_(target), interrupted_(interrupted) {}

    /// The first of the places that is a witness.
    std::optional<Witness> first(const std::vector<Candidate>& places) {
        std::vector<const Candidate*> admissible;
        std::vector<flight::batch::Query> queries;
        for (const Candidate& place : places) {
            if (const auto rays = highest_rays<Interval>(place.e, place.eta, q_lo_, q_hi_)) {
                admissible.push_back(&place);
                for (const auto& ray : *rays) {
                    queries.push_back(query(ray));
                }
            }
        }
        std::vector<flight::batch::Answer> answers(queries.size());
        flight::batch::count_at_least(queries, answers, flight::batch::chosen_backend(), interrupted_);
        for (std::size_t i = 0; i < admissible.size(); ++i) {
            const flight::batch::Answer& forward = answers[2 * i];
            const flight::batch::Answer& backward = answers[2 * i + 1];
            Witness witness{admissible[i]->e, admissible[i]->eta, forward.count, backward.count};
            if (witness.total() >= target_) {
                return witness;
            }
            if (!settled(forward) || !settled(backward)) {
                narrow_.push_back(*admissible[i]);
            }
        }
        return std::nullopt;
    }
    /// The places so far that are none only for bounds as wide as the kernel's.
    [[nodiscard]] const std::vector<Candidate>& narrow() const { return narrow_; }

  private:
    [[nodiscard]] flight::batch::Query query(const flight::Ray<Interval>& ray) const {
        return {{ray.c.hi(), ray.kappa.hi(), ray.r.hi()}, target_};
    }

    const Rational& q_lo_;
    const Rational& q_hi_;
    long target_;
    const Interrupted& interrupted_;
    std::vector<Candidate> narrow_;
};

/// Depths whose candidates are counted together, which keeps 8 lanes busy.
constexpr int depths_together = 4;

std::optional<Witness> find_in_double(const Rational& q_lo, const Rational& q_hi, long target, int deepest,
                                      const Interrupted& interrupted) {
    BatchSearch search(q_lo, q_hi, target, interrupted);
    for (int depth = 1; depth <= deepest && !interrupted(); depth += depths_together) {
        std::vector<Candidate> places;
        for (int i = depth; i < depth + depths_together && i <= deepest; ++i) {
            std::ranges::move(candidates(i), std::back_inserter(places));
        }
        if (auto witness = search.first(places)) {
            return witness;
        }
    }
    for (const auto& [e, eta] : search.narrow()) {
        if (interrupted()) {
            break;
        }
        auto witness = checked_witness<Interval>(e, eta, q_lo, q_hi, target, interrupted);
        if (witness && witness->total() >= target) {
            return witness;
        }
    }
    return std::nullopt;
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
    flight::each_count<I>(
        2, [&](std::size_t i) { counts[i] = count_at_least<I>((*rays)[i], cap, interrupted); });
    return Witness{e, eta, counts[0], counts[1]};
}

template <class I>
std::optional<Witness> find_witness(const Rational& q_lo, const Rational& q_hi, const Count& target,
                                    const Interrupted& interrupted) {
    const int bits = PrecisionScope::current();
    const int deepest = std::min(bits + 8, shortest_distance_bits);
    constexpr bool in_double = std::is_same_v<I, Interval>;
    if (in_double && target <= flight::batch::most_worth_a_batch) {
        return find_in_double(q_lo, q_hi, target, deepest, interrupted);
    }
    // The shorter the distance, the nearer to the extremal orbits, as long as the precision tells them apart.
    const int first = in_double ? 20 : std::clamp(bits - 32, 1, deepest);
    for (int i = 0; i < deepest && !interrupted(); ++i) {
        for (const auto& [e, eta] : candidates(1 + (first - 1 + i) % deepest)) {
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
