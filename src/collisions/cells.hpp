#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "base/interrupted.hpp"
#include "base/observer.hpp"
#include "collisions/certificate.hpp"
#include "file/sealed_lines.hpp"

/// Rectangles of bodies: N of all of them at once, from perpendicular orbits (plane.md, L86, L87).
namespace dumbbell::collisions {

/// All bodies with rho in one range, and Q in another.
struct Rectangle {
    Range rho, q;
};

/// At least `bound` collisions of every body of a rectangle, by the orbit (j, p); j = 0: by what needs none.
struct LowerBound {
    long bound = 0, j = 0;
    double p = 0;
};
/// At most a number, by orbits (x, p), and J < end.
struct UpperBound {
    long end = 0;
    std::vector<std::pair<long, double>> orbits;
};

/// The greatest that is found, with the rectangle as a whole.
[[nodiscard]] LowerBound least_collisions(const Rectangle& bodies, const Interrupted& interrupted = never);
/// Nothing if it is not certain that no body of the rectangle has more than `upper`.
[[nodiscard]] std::optional<UpperBound> at_most(long upper, const Rectangle& bodies,
                                                const Interrupted& interrupted = never);

/// What is certified of a rectangle, cut into cells, and its certificate.
struct Cells {
    std::optional<long> upper;
    long lower = 0, cells = 0;
    double share = 0;  ///< of the area in (log rho, log Q) with Q rho > 1, at least: of one number each
    SealedText certificate;

    [[nodiscard]] bool is_decided() const { return upper == lower; }
};

/// Whether no body of it has more than most_in_corner collisions in its corner: others are not tried.
[[nodiscard]] bool is_within_reach(const Rectangle& bodies);
/// Cuts it along rho where one number seems to be right everywhere. If a share is wanted also elsewhere,
/// until there is so much; cells that the edge, Q rho = 1, cuts are not tried. Ended early it has what was
/// proved. Preconditions: 0 < rho <= 1, 0 < Q; it is within reach.
[[nodiscard]] Cells prove_cells(const Rectangle& bodies, const std::optional<double>& wanted = {},
                                const Interrupted& interrupted = never, Observer& observer = nobody);

}  // namespace dumbbell::collisions
