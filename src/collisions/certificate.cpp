#include "collisions/certificate.hpp"

#include <algorithm>

namespace dumbbell::collisions {

std::vector<Chart> charts_of(Scene scene, Section section) {
    if (scene != Scene::dumbbell) {
        return section == Section::turning ? std::vector{Chart::wedge} : std::vector<Chart>{};
    }
    switch (section) {
        case Section::full:
            return {Chart::contact, Chart::departure, Chart::again};
        case Section::plain:
            return {Chart::plain_contact, Chart::plain_departure, Chart::again};
        default:
            return {Chart::bridge, Chart::light};
    }
}

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
