#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "number/interval.hpp"

namespace dumbbell_test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double greatest = std::numeric_limits<double>::max();
inline constexpr double least = std::numeric_limits<double>::denorm_min();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

inline bool is(const dumbbell::Interval& x, double lo, double hi) { return x.lo() == lo && x.hi() == hi; }

/// Whether anything at all is certain about x.
template <class I>
bool says_something(const I& x) {
    return certainly_positive(x) || certainly_positive(-x) ||
           std::ranges::any_of(std::array{-infinity, -1e300, -1.0, 0.0, 1.0, 1e300, infinity}, [&](double y) {
               const I point(y);
               return certainly_less(x, point) || certainly_less(point, x) || certainly_at_most(x, point) ||
                      certainly_at_most(point, x);
           });
}

/// Deterministic random numbers, the same on every platform (the standard's distributions are not).
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    std::uint64_t bits() { return engine_(); }
    int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
    bool coin() { return (bits() & 1U) != 0; }
    double uniform(double lo, double hi) {
        return lo + (hi - lo) * (static_cast<double>(bits() >> 11) * 0x1p-53);
    }
    double log_uniform(double lo, double hi) { return lo * std::exp(uniform(0, std::log(hi / lo))); }
    /// Of uniform logarithm, 0 < lo < hi.
    double scaled(double lo, double hi) { return std::exp2(uniform(std::log2(lo), std::log2(hi))); }
    double sign() { return coin() ? 1.0 : -1.0; }

  private:
    std::mt19937_64 engine_;
};

/// V moved by `steps` doubles.
inline double neighbour(double v, int steps) {
    for (; steps > 0; --steps) {
        v = std::nextafter(v, HUGE_VAL);
    }
    for (; steps < 0; ++steps) {
        v = std::nextafter(v, -HUGE_VAL);
    }
    return v;
}

/// A finite double that arithmetic likes to get wrong: a special value, any bit pattern, subnormal, huge,
/// near a power of two, an integer, or ordinary.
inline double adversarial(Random& random) {
    static constexpr double specials[] = {0.0,
                                          -0.0,
                                          1.0,
                                          -1.0,
                                          2.0,
                                          0.5,
                                          0x1p-1074,
                                          -0x1p-1074,
                                          0x1p-1022,
                                          0x0.fffffffffffffp-1022,
                                          0x1.fffffffffffffp1023,
                                          -0x1.fffffffffffffp1023,
                                          0x1p512,
                                          0x1p-512,
                                          0x1p-537,
                                          0x1.fffffffffffffp-1,
                                          0x1.0000000000001p0};
    switch (random.below(8)) {
        case 0:
            return specials[random.below(static_cast<int>(std::size(specials)))];
        case 1: {
            const auto any = std::bit_cast<double>(random.bits());
            return std::isfinite(any) ? any : 1.0;
        }
        case 2:
            return random.sign() * static_cast<double>(random.bits() >> 13) * 0x1p-1074;  // subnormal
        case 3:
            return random.sign() * random.scaled(0x1p1000, 0x1.8p1023);
        case 4:
            return random.sign() * neighbour(std::ldexp(1.0, random.below(40) - 20), random.below(7) - 3);
        case 5:
            return random.below(201) - 100;
        default:
            return random.sign() * random.scaled(0x1p-30, 0x1p30);
    }
}

/// A finite interval: thin, a few doubles wide, wide, around zero or with an end in zero.
inline dumbbell::Interval adversarial_interval(Random& random) {
    const double a = adversarial(random);
    double b = a;
    switch (random.below(5)) {
        case 0:
            break;
        case 1:
            b = std::min(neighbour(a, random.below(4)), greatest);
            break;
        case 2:
            b = 0;
            break;
        case 3:
            b = -a;
            break;
        default:
            b = adversarial(random);
    }
    return {std::min(a, b), std::max(a, b)};
}

}  // namespace dumbbell_test
