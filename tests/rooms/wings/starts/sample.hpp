// A certificate about initial conditions made by hand: phi in [0, 4], ydot in [-1, 1], the rest numbers. The
// left half has 2 collisions; the right half's lower part 1, its upper part is not decided.
#pragma once

#include "starts/cover/certificate.hpp"

namespace dumbbell_test {

inline dumbbell::starts::Node initial_split(dumbbell::starts::Axis axis) { return {axis, {}}; }
inline dumbbell::starts::Node exactly(long count) { return {{}, {count, count, {}}}; }
inline dumbbell::starts::Node between(long least, long most) { return {{}, {least, most, {}}}; }
inline dumbbell::starts::Node open_leaf() { return {{}, {}}; }

inline dumbbell::starts::Certificate sample_initial() {
    dumbbell::starts::Certificate certificate;
    certificate.generator = {"dumbbell", "0.1.0"};
    certificate.box.lo = {0, 1, 2, -1, 10};
    certificate.box.hi = {4, 1, 2, 1, 10};
    certificate.tree = {initial_split(dumbbell::starts::Axis::phi),
                        initial_split(dumbbell::starts::Axis::ydot),
                        exactly(2),
                        exactly(2),
                        initial_split(dumbbell::starts::Axis::ydot),
                        exactly(1),
                        between(1, 2)};
    return certificate;
}

}  // namespace dumbbell_test
