#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>

#include "base/interrupted.hpp"
#include "base/observer.hpp"
#include "starts/cover/certificate.hpp"
#include "starts/cover/packed_tree.hpp"
#include "starts/walls/obstacle.hpp"

/// Covers of a box of initial conditions by boxes whose number of collisions is certain.
namespace dumbbell::starts {

struct SubdivideOptions {
    std::size_t max_boxes = 50000;  ///< leaves
    int max_depth = 60;             ///< splits of one axis, at most 63
    int jobs = 1;
    bool incoming = false;  ///< the box is one of incoming.hpp; then bits = 53
    int bits = 53;          ///< for boxes that double precision does not decide; beyond 53 MPFR
    Interrupted interrupted = never;
    Observer* observer = &nobody;  ///< told of boxes that are judged
};

struct Share {
    Rational share = 0;  ///< of the box's volume, exactly
    long boxes = 0;
};

/// A bisection tree of the box, and what its leaves add up to.
struct Subdivision {
    PackedTree tree;
    std::map<long, Share> exact;  ///< by number of collisions
    Share undecided;
    std::array<long, obstacles> near{};  ///< undecided boxes by their Obstacle
    long unexplained = 0;                ///< undecided boxes without one, after an interruption
    long least = 0;                      ///< over the whole box
    std::optional<long> most;
    int bits = 53;  ///< of the options
};

/// Bisects until each box has an exact count, or a limit is reached; then the largest boxes are the ones that
/// were halved. Deterministic whatever the number of threads, unless interrupted. A leaf says only what the
/// rules of format-initial.md give for a slightly larger box. Precondition: require_in_play(box), or it is an
/// incoming_box.
[[nodiscard]] Subdivision subdivide(const Box& box, const SubdivideOptions& options);

}  // namespace dumbbell::starts
