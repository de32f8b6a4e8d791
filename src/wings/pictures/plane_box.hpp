#pragma once

#include <array>

#include "number/rational.hpp"

namespace dumbbell::pictures {

/// A closed box in the plane of a picture, its ends exact: horizontal axis first.
struct PlaneBox {
    std::array<Rational, 2> lo;
    std::array<Rational, 2> hi;
};

using PlanePoint = std::array<Rational, 2>;

}  // namespace dumbbell::pictures
