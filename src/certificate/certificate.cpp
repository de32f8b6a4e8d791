#include "certificate/certificate.hpp"

#include <algorithm>

namespace dumbbell {

long Cover::leaves() const {
    const auto is_leaf = [](const Node& node) { return !node.split; };
    return std::count_if(bridge.begin(), bridge.end(), is_leaf) +
           std::count_if(light.begin(), light.end(), is_leaf);
}

Status Piece::status() const {
    if (!upper || *upper > lower + 1) {
        return Status::open;
    }
    return *upper == lower ? Status::exact : Status::gap;
}

}  // namespace dumbbell
