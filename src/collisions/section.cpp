#include "collisions/section.hpp"

#include "base/error.hpp"

namespace dumbbell::collisions {
namespace {

std::pair<Box, Box> cut(const Box& box, Coordinate Box::*lo, Coordinate Box::*hi) {
    const Coordinate half = middle(box.*lo, box.*hi);
    Box lower = box;
    Box upper = box;
    lower.*hi = half;
    upper.*lo = half;
    return {std::move(lower), std::move(upper)};
}

/// The least power of two that is >= x, and >= 1.
double power_of_two_from(const Rational& x) {
    double power = 1;
    while (exact(power) < x) {
        power *= 2;
    }
    return power;
}

}  // namespace

Box root_box(Chart chart, const Rational& q_lo, const Rational& q_hi) {
    switch (chart) {
        case Chart::bridge:
        case Chart::light:
            return {0, 2, 0, power_of_two_from(q_hi), q_lo, q_hi};
        case Chart::contact:
        case Chart::plain_contact:
        case Chart::again:
            return {0, 4, 0, power_of_two_from(q_hi + 1), q_lo, q_hi};
        case Chart::wedge:
        case Chart::corner:
            return {0, 0, 0, power_of_two_from(q_hi), q_lo, q_hi};
        case Chart::departure:
        case Chart::plain_departure:
            return {0, 2, 0, 2, q_lo, q_hi};
    }
    throw BrokenInvariant("unknown chart");
}

std::pair<Box, Box> halves(const Box& box, Axis axis) {
    switch (axis) {
        case Axis::position:
            return cut(box, &Box::e_lo, &Box::e_hi);
        case Axis::slope:
            return cut(box, &Box::slope_lo, &Box::slope_hi);
        case Axis::rho:
            return cut(box, &Box::rho_lo, &Box::rho_hi);
        default:
            return cut(box, &Box::q_lo, &Box::q_hi);
    }
}

}  // namespace dumbbell::collisions
