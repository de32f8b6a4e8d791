#include "prove/section.hpp"

namespace dumbbell {
namespace {

std::pair<Box, Box> cut(const Box& box, Rational Box::*lo, Rational Box::*hi) {
    const Rational middle = (box.*lo + box.*hi) / 2;
    Box lower = box;
    Box upper = box;
    lower.*hi = middle;
    upper.*lo = middle;
    return {std::move(lower), std::move(upper)};
}

}  // namespace

Box root_box(const Rational& q_lo, const Rational& q_hi) {
    Rational top = 1;
    while (top < q_hi) {
        top *= 2;
    }
    return {0, 2, 0, top, q_lo, q_hi};
}

std::pair<Box, Box> halves(const Box& box, Axis axis) {
    switch (axis) {
        case Axis::position:
            return cut(box, &Box::e_lo, &Box::e_hi);
        case Axis::slope:
            return cut(box, &Box::slope_lo, &Box::slope_hi);
        default:
            return cut(box, &Box::q_lo, &Box::q_hi);
    }
}

}  // namespace dumbbell
