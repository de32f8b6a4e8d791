#include "collisions/certificate.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace dumbbell::collisions {

long Cover::leaves() const {
    long leaves = 0;
    for (const ChartTree& part : charts) {
        leaves +=
            std::count_if(part.tree.begin(), part.tree.end(), [](const Node& node) { return !node.split; });
    }
    return leaves;
}

Status Piece::status() const {
    // N of bodies may leap over a number (L83).
    const int leap = cover.orbits ? 2 : 1;
    if (!upper || *upper > lower + leap) {
        return Status::open;
    }
    return *upper == lower ? Status::exact : Status::gap;
}

long Certificate::leaves() const {
    return std::transform_reduce(pieces.begin(), pieces.end(), 0L, std::plus(),
                                 [](const Piece& piece) { return piece.cover.leaves(); });
}

}  // namespace dumbbell::collisions
