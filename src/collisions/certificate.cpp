#include "collisions/certificate.hpp"

#include <algorithm>

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
    if (!upper || *upper > lower + 1) {
        return Status::open;
    }
    return *upper == lower ? Status::exact : Status::gap;
}

}  // namespace dumbbell::collisions
