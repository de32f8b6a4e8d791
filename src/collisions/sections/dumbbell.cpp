#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include "collisions/names.hpp"
#include "collisions/section.hpp"
#include "collisions/step_guess.hpp"
#include "collisions/witness.hpp"
#include "flight/count.hpp"
#include "flight/extremal_orbit.hpp"

/// The dumbbell: its two extremal orbits tell what to try (Theorems 1 and 2).
namespace dumbbell::collisions {
namespace {

/// The step to n, to a small part of the gap, which is at most a thousandth of the distance to the next step.
/// More of it costs little while the orbits are short. Were it wrong, pieces would stay open.
Step dumbbell_step(long n, double gap, const Interrupted& interrupted) {
    // Wider gaps are placed with doubles: a step is off by up to 2^-48, which must be a small part of the
    // gap.
    constexpr double narrow = 1e-13;
    if (n < flight::macro::least_for_placing && gap >= narrow) {
        return {n, exact(guess_step(n, interrupted)), exact(0x1p-48), false};
    }
    // Relative distances are 2/n times those between the steps.
    const double share = std::min(1e-3, gap * static_cast<double>(n) / 2);
    const int spare = n >= flight::macro::least_for_placing ? 12 : 40;
    const int share_bits = std::clamp(spare - static_cast<int>(std::log2(share)), 24, 1060);
    const auto found = find_step(n, share_bits, interrupted);
    return found ? Step{n, found->at, Rational(Integer(1), (Integer(1) << (share_bits - 6)) * n), false}
                 : Step{n, 0, 0, false};
}

/// Whether two neighbouring counts at q are not beyond this precision: C sqrt q has half the digits of q.
bool tells_counts_apart(const Rational& q) {
    const int bits = PrecisionScope::current();
    if (bits == double_bits) {
        return q <= parse_rational("1e27");
    }
    constexpr int spare = 24;
    return static_cast<int>(msb(Integer(numerator(q) / denominator(q)))) / 2 + spare <= bits;
}

/// From upper bounds on the two extremal orbits and a lower one on that whose last flight decides (Theorem 2
/// (c)).
template <class I>
std::optional<Count> suspected_maximum(const Rational& q, const System& /*system*/,
                                       const Interrupted& interrupted) {
    using flight::ExtremalOrbit;
    using N = flight::CountOf<I>;
    if (!tells_counts_apart(q)) {
        return std::nullopt;
    }
    if (q == 1) {
        return 2;
    }
    N cap = std::numeric_limits<long>::max() / 8;
    if constexpr (std::is_same_v<I, BigInterval>) {
        cap += Count(numerator(q) / denominator(q));  // more than C sqrt q
    }
    const I r = enclose<I>(Rational(1) / q);
    const std::array rays{extremal_ray(ExtremalOrbit::top, r), extremal_ray(ExtremalOrbit::corner, r)};
    std::array<N, 2> counts;
    flight::each_count<I>(2, [&](std::size_t i) { counts[i] = count_at_most(rays[i], cap, interrupted); });
    const auto& [top, corner] = counts;
    const N& last = std::max(top, corner);
    if (last > cap) {
        return std::nullopt;
    }
    const bool reached = count_at_least(rays[top > corner ? 0 : 1], last, interrupted) == last;
    return reached ? std::optional(Count(2) + top + corner) : std::nullopt;
}

/// The flight that decides whether there are n >= 2 collisions (Theorem 2 (c)) certainly has one. Like
/// orbits_stay_below it only says what to try: it costs as much as one ray of a cover, a search in vain a
/// hundred times that. With both, and the search for witnesses from the last bits on, `certify 4:5 --gap
/// 1e-190` went from 7.9 s to 0.01 s.
template <class I>
bool orbits_reach(const Count& n, const Rational& q, const Interrupted& interrupted) {
    const auto [orbit, flight] = flight::tangent_flight(as_long(n));
    return count_at_least(extremal_ray(orbit, enclose<I>(Rational(1) / q)), flight, interrupted) == flight;
}

/// That which decides whether there are more certainly has none.
template <class I>
bool orbits_stay_below(const Count& n, const Rational& q, const Interrupted& interrupted) {
    const auto [orbit, flight] = flight::tangent_flight(as_long(n) + 1);
    return count_at_most(extremal_ray(orbit, enclose<I>(Rational(1) / q)), flight - 1, interrupted) < flight;
}

template <class I>
std::optional<Witness> dumbbell_witness(const Range& range, const Count& target, const System& /*system*/,
                                        const Interrupted& interrupted) {
    return find_witness<I>(range.lo, range.hi, target, interrupted);
}

/// L7.
std::optional<Cover> equal_masses(const Range& range, const Count& upper, const System& /*system*/,
                                  const Interrupted& /*interrupted*/) {
    const bool holds = range.hi == 1 && upper >= 2;
    return holds ? std::optional(Cover{.equal_masses = true, .charts = {}}) : std::nullopt;
}

template <class I>
constexpr BoundSearch<I> dumbbell_bounds{suspected_maximum<I>, orbits_reach<I>, orbits_stay_below<I>,
                                         dumbbell_witness<I>, equal_masses};

constexpr std::array turning_charts{Chart::bridge, Chart::light};
constexpr std::array full_charts{Chart::contact, Chart::departure, Chart::again},
    plain_charts{Chart::plain_contact, Chart::plain_departure, Chart::again};

constexpr SectionRow turning{.scene = "dumbbell",
                             .section = "turning",
                             .lemmas = "1",
                             .section_in_file = "turning",
                             .hits = "trajectory hits the floor",
                             .hits_it = "trajectory hits it",
                             .growth = "0.885595129452713911412021948915",  // C of docs/10-law.md
                             .most_digits = 100,
                             .has_orbits = true,
                             .has_paper_bound = true,
                             .charts = turning_charts,
                             .step = dumbbell_step,
                             .bounds = {dumbbell_bounds<Interval>, dumbbell_bounds<BigInterval>}};

/// All states, not a section of them.
constexpr SectionRow all_states(std::string_view section, std::string_view lemmas,
                                std::span<const Chart> charts) {
    SectionRow row = turning;
    row.section = section;
    row.lemmas = lemmas;
    row.section_in_file = "full";
    row.kind_in_totals = name(Reason::once);
    row.most_digits = SectionRow{}.most_digits;
    row.shows_heavy_once = true;
    row.bits_to_verify = 0;
    row.max_bits = 2048;
    row.max_nodes = 20'000'000;
    row.charts = charts;
    return row;
}

}  // namespace

const SectionRow turning_row = turning, full_row = all_states("full", "1", full_charts),
                 plain_row = all_states("plain", "minimal", plain_charts);

}  // namespace dumbbell::collisions
