#pragma once

#include <optional>

#include "base/interrupted.hpp"
#include "base/observer.hpp"
#include "collisions/perpendicular.hpp"
#include "file/sealed_lines.hpp"

/// Rectangles of bodies: N of all of them at once (plane.md, L87).
namespace dumbbell::collisions {

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
