#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "exact.hpp"
#include "rooms/number/angles.hpp"
#include "rooms/number/random.hpp"

/// Arguments that an interval layer likes to get wrong, of any precision.
namespace dumbbell_test {

/// The doubles up to 2^20 that are nearest to a multiple of pi/2 in units of their last place, the nearest
/// first.
inline const std::vector<double>& nearly_quarter_turns() {
    static const std::vector<double> nearest = [] {
        constexpr double half_pi = 0x1.921fb54442d18p+0;
        constexpr double half_pi_rest = 0x1.1a62633145c07p-54;
        std::vector<std::pair<double, double>> all;
        for (int k = 1; k <= 667543; ++k) {
            const double x = k * half_pi;
            const double left = std::fma(k, half_pi, -x) + k * half_pi_rest;  // k pi/2 - x
            // x or its neighbour may be the nearer one.
            for (const double v : {x, std::nextafter(x, left > 0 ? HUGE_VAL : 0.0)}) {
                all.emplace_back(std::abs(left - (v - x)) / v, v);
            }
        }
        constexpr std::size_t kept = 4096;
        std::partial_sort(all.begin(), all.begin() + kept, all.end());
        std::vector<double> result;
        for (std::size_t i = 0; i < kept; ++i) {
            result.push_back(all[i].second);
        }
        return result;
    }();
    return nearest;
}

/// A double for sine and cosine: one of these, or nearly so, or beyond the layers' reach, or any other.
inline double attacking_angle(Random& random) {
    switch (random.below(8)) {
        case 0:
        case 1: {
            const auto& nearest = nearly_quarter_turns();
            const int some = random.coin() ? 64 : static_cast<int>(nearest.size());
            return random.sign() * neighbour(nearest[static_cast<std::size_t>(random.below(some))],
                                             random.coin() ? 0 : random.below(5) - 2);
        }
        case 2:
            return random.sign() * neighbour(0x1p28 * 0x1.921fb54442d18p+0, random.below(9) - 4);
        case 3:
            return random.sign() * random.scaled(0x1p20, 0x1p32);
        case 4:
            // 6381956970095103 * 2^797: among all doubles the nearest to a multiple of pi/2.
            return random.sign() * neighbour(0x1.6ac5b262ca1ffp+849, random.below(3) - 1);
        default:
            return adversarial_angle(random);
    }
}

/// Makes `to` this double, or with more bits than a double has: a number near it that is none.
inline void set_near(mpfr_ptr to, double v, Random& random) {
    mpfr_set_d(to, v, MPFR_RNDN);
    if (mpfr_get_prec(to) <= 53 || v == 0 || std::isinf(v) || random.below(3) == 0) {
        return;
    }
    if (random.coin()) {  // the neighbour, or one of the next few
        for (int steps = 1 + random.below(3); steps > 0; --steps) {
            random.coin() ? mpfr_nextabove(to) : mpfr_nextbelow(to);
        }
        return;
    }
    Mpfr factor(static_cast<int>(mpfr_get_prec(to)), 1 + random.uniform(-0x1p-52, 0x1p-52));
    mpfr_mul(to, to, factor, MPFR_RNDN);
}

/// Makes `to` the number of its precision that is nearest to a multiple of pi/2, or one next to it.
inline void set_quarter_turn(mpfr_ptr to, Random& random) {
    mpfr_t exact;
    mpfr_init2(exact, mpfr_get_prec(to) + 40);
    mpfr_const_pi(exact, MPFR_RNDN);
    mpfr_mul_si(exact, exact, random.coin() ? random.below(17) - 8 : random.below(1 << 21) - (1 << 20),
                MPFR_RNDN);
    mpfr_div_2ui(exact, exact, 1, MPFR_RNDN);
    mpfr_set(to, exact, random.coin() ? MPFR_RNDD : MPFR_RNDU);
    mpfr_clear(exact);
}

inline void in_order(Ends& x) {
    if (mpfr_greater_p(mpfr_ptr(x.lo), mpfr_ptr(x.hi)) != 0) {
        mpfr_swap(x.lo, x.hi);
    }
}

/// An interval for arithmetic: thin, narrow, wide, around zero, with an end at zero, of any size.
inline void draw(Ends& x, Random& random) {
    const dumbbell::Interval base = adversarial_interval(random);
    set_near(x.lo, base.lo(), random);
    if (base.lo() == base.hi() && random.coin()) {
        mpfr_set(x.hi, x.lo, MPFR_RNDN);
    } else {
        set_near(x.hi, base.hi(), random);
    }
    in_order(x);
}

/// An interval for sine and cosine: an end at an extremum, an extremum just inside or just outside, thin,
/// wide.
inline void draw_angles(Ends& x, Random& random) {
    const auto set = [&](mpfr_ptr to) {
        random.below(3) == 0 ? set_quarter_turn(to, random) : set_near(to, attacking_angle(random), random);
    };
    set(x.lo);
    const double a = mpfr_get_d(x.lo, MPFR_RNDN);
    switch (random.below(8)) {
        case 0:
        case 1:
        case 2:
            mpfr_set(x.hi, x.lo, MPFR_RNDN);
            break;
        case 3:
            set(x.hi);
            break;
        case 4:
            set_near(x.hi, a + random.uniform(0, 8), random);
            break;
        case 5: {  // a few quarter turns on, and with it the same place of the wave
            const double b = a + random.below(6) * 0x1.921fb54442d18p+0;
            set_near(x.hi, neighbour(b, random.below(7) - 3), random);
            break;
        }
        case 6:
            set_near(x.hi, neighbour(a, random.below(4)), random);
            break;
        default:
            set_near(x.hi, a + random.scaled(1e-18, 1), random);
    }
    in_order(x);
}

}  // namespace dumbbell_test
