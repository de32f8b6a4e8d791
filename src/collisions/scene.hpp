#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "base/interrupted.hpp"
#include "collisions/certificate.hpp"
#include "number/big_interval.hpp"
#include "number/interval.hpp"

/// What the general code asks of a scene. A new one is a value of Scene, for which the compiler then wants a
/// name (names.hpp) and a row (scene.cpp), and a folder such as `wedge` that defines the row.
namespace dumbbell::collisions {

/// Where the maximum steps: from n - 1 below `critical` to n above.
struct Step {
    long n = 0;
    Rational critical = 0;
    Rational slack = 0;  ///< the true step may be so far from `critical`, relatively
    bool exact = false;  ///< n - 1 holds at `critical` itself, which is the critical ratio exactly
};

/// What to try first of a piece, with the bits of I: only time is lost where it is wrong.
template <class I>
struct BoundSearch {
    /// The maximum at q; nothing if this precision does not tell it, or not in time.
    std::optional<Count> (*maximum)(const Rational& q, const std::optional<Heights>& heights,
                                    const Interrupted& interrupted);
    /// Whether an orbit of n collisions at q may be found with this precision.
    bool (*may_reach)(const Count& n, const Rational& q, const Interrupted& interrupted);
    /// Whether a cover for at most n at q may be found.
    bool (*may_stay)(const Count& n, const Rational& q, const Interrupted& interrupted);
    std::optional<Witness> (*witness)(const Rational& q_lo, const Rational& q_hi, const Count& target,
                                      const std::optional<Heights>& heights, const Interrupted& interrupted);
};

[[nodiscard]] inline std::optional<Cover> no_lemma(const Rational& /*q_lo*/, const Rational& /*q_hi*/,
                                                   const Count& /*upper*/,
                                                   const std::optional<Heights>& /*heights*/) {
    return std::nullopt;
}

struct SceneRow {
    std::string_view hits, hits_it;  ///< "no ... more than N times, and some ... N times"
    std::string_view system, where;  ///< "The dumbbell"; " in the wedge", or nothing
    std::string_view title;          ///< of the picture of its maximum
    std::string_view growth;         ///< it steps about where growth sqrt q is a whole number: a decimal
    int most_digits = 36;            ///< single ratios up to 10^this are tried, in the section turning
    bool has_orbits = false;         ///< in the plane, to be listed and drawn; else it has slopes only
    /// The source paper bounds its maximum by ceil(pi/gamma) + 1; else ceil(pi/gamma) is its maximum.
    bool has_paper_bound = false;
    /// Of a section, in the order of the file; none if the scene has no such section.
    std::vector<Chart> (*charts)(Section section);
    /// The step to n, for a gap of this width around it; `critical` is 0 if interrupted. nullptr: nothing is
    /// known of the steps, and ranges are halved.
    Step (*step)(long n, double gap, const Interrupted& interrupted);
    /// What proves the upper bound without trees, if anything does.
    std::optional<Cover> (*by_lemma)(const Rational& q_lo, const Rational& q_hi, const Count& upper,
                                     const std::optional<Heights>& heights) = no_lemma;
    std::tuple<BoundSearch<Interval>, BoundSearch<BigInterval>> bounds;
};

[[nodiscard]] const SceneRow& row_of(Scene scene);

/// What row_of gives, each defined where its scene is.
extern const SceneRow dumbbell_row, hybrid_row, wedge_row, body_row;

/// `--scene wedge `: what a command about the scene needs; nothing for the dumbbell.
[[nodiscard]] std::string option_of(Scene scene);

}  // namespace dumbbell::collisions
