#include "collisions/scene.hpp"

#include <algorithm>
#include <vector>

#include "base/error.hpp"
#include "collisions/body/witness.hpp"
#include "flight/corner.hpp"
#include "flight/paper_bound.hpp"

/// The scene body: rigid bodies with mass between their two contacts (body.md).
namespace dumbbell::collisions {
namespace {

constexpr long most_in_corner = 10'000;  ///< more are not followed, by a verifier neither

std::vector<Chart> body_charts(Section section) {
    return section == Section::plain ? std::vector{Chart::plain_contact, Chart::plain_departure}
                                     : std::vector<Chart>{};
}

bool is_symmetric(const Heights& heights) { return heights.lo == 1; }

/// L72.
std::optional<Cover> symmetric_cover(const Rational& /*q_lo*/, const Rational& q_hi, const Count& upper,
                                     const std::optional<Heights>& heights) {
    const bool holds = is_symmetric(*heights) && flight::corner_count(1, q_hi, most_in_corner) <=
                                                     std::min(upper, Count(most_in_corner));
    return holds ? std::optional(Cover{.symmetric = true, .charts = {}}) : std::nullopt;
}

/// Of a symmetric body exactly; else the most that is found, for the middle of the heights.
std::optional<Count> body_maximum(const Rational& q, const std::optional<Heights>& heights,
                                  const Interrupted& interrupted) {
    const Rational rho = (heights->lo + heights->hi) / 2;
    const long near = flight::corner_count(rho, q, most_in_corner);
    if (near > most_in_corner) {
        return std::nullopt;
    }
    return is_symmetric(*heights) ? near : std::max(near, greatest_found(q, rho, interrupted));
}

bool may_be(const Count& /*n*/, const Rational& /*q*/, const Interrupted& /*interrupted*/) { return true; }

std::optional<Witness> body_witness(const Rational& q_lo, const Rational& q_hi, const Count& target,
                                    const std::optional<Heights>& heights, const Interrupted& interrupted) {
    if (target <= std::min(flight::corner_count(heights->lo, q_lo, most_in_corner), most_in_corner)) {
        return Witness{0, 0, target - 1, 0, Chart::corner};
    }
    return found_contact(q_lo, q_hi, *heights, as_long(target), interrupted);
}

template <class I>
constexpr BoundSearch<I> body_bounds{body_maximum, may_be, may_be, body_witness};

}  // namespace

const SceneRow body_row{.hits = "motion of the body in a plane, without a corner, hits the floor",
                        .hits_it = "motion hits it",
                        .system = "The body",
                        .where = " of a body",
                        .title = "Greatest number of collisions of a rigid body against Q = (d1/k)^2",
                        .growth = "1.570796326794896619231321691640",
                        .charts = body_charts,
                        .step = nullptr,
                        .by_lemma = symmetric_cover,
                        .bounds = {body_bounds<Interval>, body_bounds<BigInterval>}};

}  // namespace dumbbell::collisions
