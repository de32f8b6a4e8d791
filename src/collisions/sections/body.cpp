#include <algorithm>
#include <array>

#include "collisions/names.hpp"
#include "collisions/section.hpp"
#include "collisions/sections/body_witness.hpp"
#include "flight/corner.hpp"

/// Rigid bodies with mass between their two contacts (body.md).
namespace dumbbell::collisions {
namespace {

bool is_symmetric(const System& system) { return system.rho->lo == 1; }

/// L72.
std::optional<Cover> symmetric_cover(const Range& range, const Count& upper, const System& system) {
    const bool holds = is_symmetric(system) && flight::corner_count(1, range.hi, most_in_corner) <=
                                                   std::min(upper, Count(most_in_corner));
    return holds ? std::optional(Cover{.symmetric = true, .charts = {}}) : std::nullopt;
}

/// Of a symmetric body exactly; else the most that is found, for the middle of the range of rho.
std::optional<Count> body_maximum(const Rational& q, const System& system, const Interrupted& interrupted) {
    const Rational rho = (system.rho->lo + system.rho->hi) / 2;
    const long near = flight::corner_count(rho, q, most_in_corner);
    if (near > most_in_corner) {
        return std::nullopt;
    }
    return is_symmetric(system) ? near : std::max(near, greatest_found(q, rho, interrupted));
}

std::optional<Witness> body_witness(const Range& range, const Count& target, const System& system,
                                    const Interrupted& interrupted) {
    if (target <= std::min(flight::corner_count(system.rho->lo, range.lo, most_in_corner), most_in_corner)) {
        return Witness{0, 0, target - 1, 0, Place::corner};
    }
    return found_contact(range, system, as_long(target), interrupted);
}

template <class I>
constexpr BoundSearch<I> body_bounds{body_maximum, nullptr, nullptr, body_witness};

constexpr std::array body_charts{Chart::plain_contact, Chart::plain_departure};

}  // namespace

const SectionRow plain_body_row{.scene = "body",
                                .section = "plain",
                                .lemmas = "body",
                                .section_in_file = "full",
                                .kind_in_totals = symmetric_word,
                                .hits = "motion of the body in a plane, without a corner, hits the floor",
                                .hits_it = "motion hits it",
                                .system = "The body",
                                .where = " of a body",
                                .title = "Greatest number of collisions of a rigid body against Q = (d1/k)^2",
                                .growth = "1.570796326794896619231321691640",
                                .bits_to_verify = 0,
                                .max_bits = double_bits,  // what it leaves open is next to a tie
                                .max_nodes = 20'000'000,
                                .charts = body_charts,
                                .step = nullptr,
                                .by_lemma = symmetric_cover,
                                .bounds = {body_bounds<Interval>, body_bounds<BigInterval>}};

}  // namespace dumbbell::collisions
