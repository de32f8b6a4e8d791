#pragma once

#include "random.hpp"

namespace dumbbell_test {

/// A double near k pi/2, |k| <= 2^19.
inline double near_quarter_turn(Random& random) {
    const double k = random.coin() ? random.below(9) - 4 : random.below(1 << 20) - (1 << 19);
    return neighbour(k * 0x1.921fb54442d18p+0, random.below(9) - 4);
}

/// An argument that sine and cosine like to get wrong.
inline double adversarial_angle(Random& random) {
    switch (random.below(8)) {
        case 0:
        case 1:
            return near_quarter_turn(random);
        case 2:
            return random.sign() * random.scaled(0x1p-1070, 0x1p-20);
        case 3:
            return random.sign() * neighbour(0x1p20, random.below(9) - 4);
        case 4:
            return random.sign() *
                   neighbour(0x1.921fb54442d18p-1, random.below(9) - 4);  // pi/4: where kernels meet
        case 5:
            return adversarial(random);
        case 6:
            return random.uniform(0, 0x1.921fb54442d18p+0);
        default:
            return random.uniform(-20, 20);
    }
}

/// An interval of such arguments, some with an end at an extremum, some with one inside, some wide.
inline dumbbell::Interval adversarial_angles(Random& random) {
    const double a = adversarial_angle(random);
    double b = a;
    switch (random.below(5)) {
        case 0:
            b = neighbour(a, random.below(4));
            break;
        case 1:
            b = near_quarter_turn(random);
            break;
        case 2:
            b = a + random.scaled(1e-18, 1);
            break;
        case 3:
            b = a + random.uniform(0, 8);
            break;
        default:
            b = random.uniform(0, 0x1.921fb54442d18p+0);
    }
    return {std::min(a, b), std::max(a, b)};
}

/// A number of [-1, 1] for arcsine: its ends, zero, tiny ones, values of sine near its extrema and zeros, by
/// `angle`.
template <class Angle>
[[nodiscard]] double adversarial_sine(Random& random, const Angle& angle) {
    switch (random.below(6)) {
        case 0:
            return random.sign() * (1 - random.scaled(0x1p-53, 1));
        case 1:
            return random.sign() * neighbour(1.0, -random.below(4));
        case 2:
            return random.sign() * random.scaled(0x1p-1074, 1);
        case 3:
            return std::sin(angle(random));
        case 4:
            return random.below(3) - 1;
        default:
            return random.uniform(-1, 1);
    }
}

}  // namespace dumbbell_test
