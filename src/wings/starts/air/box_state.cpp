#include "starts/air/box_state.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.hpp"

namespace dumbbell::starts {
namespace {

constexpr int check_bits = 512;

void require_sensible(const Box& box) {
    struct Limit {
        Axis axis;
        const char* name;
        const char* most;
        const char* remedy;
    };
    for (const Limit& limit :
         {Limit{Axis::phi, "phi", "1000", "it is an angle in radians: take it modulo 2 pi"},
          Limit{Axis::phidot, "phidot", "1e9", "only the ratio of --phidot to --ydot matters: scale both"},
          Limit{Axis::y, "y", "1e6", "it is a height in rod lengths"},
          Limit{Axis::ydot, "ydot", "1e9", "only the ratio of --phidot to --ydot matters: scale both"}}) {
        const Rational most = parse_rational(limit.most);
        if (box.lower(limit.axis) < -most || box.upper(limit.axis) > most) {
            throw InputError(fmt::format("--{} is larger than {} in absolute value: {}", limit.name,
                                         limit.most, limit.remedy));
        }
    }
    if (box.upper(Axis::phi) - box.lower(Axis::phi) > 7) {
        throw InputError("--phi spans more than 7 radians: one turn has every angle, give no more");
    }
}

void require_moving(const Box& box) {
    const auto holds_zero = [&](Axis axis) { return box.lower(axis) <= 0 && box.upper(axis) >= 0; };
    if (!holds_zero(Axis::phidot) || !holds_zero(Axis::ydot)) {
        return;
    }
    throw InputError(
        box.is_point()
            ? "a resting dumbbell (--phidot 0 --ydot 0) never moves: give it a velocity"
            : "the box contains a resting dumbbell (phidot = ydot = 0), which never moves: keep 0 out of "
              "--phidot or out of --ydot");
}

/// The least height of the centre of mass from which one mass is above the floor, and which it is.
struct Floor {
    BigInterval height;  ///< enclosures over the box: beta2 * -sin phi or beta1 * sin phi
    const char* mass;
};

/// `remedy`: what brings both masses above the floor.
void require_above(const Box& box, const Floor& floor, const std::string& remedy) {
    const BigInterval lowest = enclose<BigInterval>(box.lower(Axis::y));
    const BigInterval highest = enclose<BigInterval>(box.upper(Axis::y));
    if (certainly_less(high_end(floor.height), lowest)) {
        return;
    }
    if (certainly_less(highest, low_end(floor.height))) {
        throw InputError(
            fmt::format("--y starts inside the floor: the {} mass is below it; {}", floor.mass, remedy));
    }
    if (box.is_point()) {
        throw InputError(
            fmt::format("the rod starts on the floor: the {} mass touches it; {}", floor.mass, remedy));
    }
    throw InputError(fmt::format("--y: part of the box starts on or inside the floor (the {} mass); {}",
                                 floor.mass, remedy));
}

}  // namespace

void require_in_play(const Box& box) {
    require_sensible(box);
    require_moving(box);
    if (box.lower(Axis::y) <= 0 && box.is_point()) {
        const bool on = box.lower(Axis::y) == 0 && box.lower(Axis::phi) == 0;
        throw InputError(
            on ? "the rod starts on the floor, both masses touch it (a corner): raise --y above 0"
               : "--y starts inside the floor: the centre of mass must be above 0, whatever --phi is");
    }
    const PrecisionScope scope(check_bits);
    const auto side = [&](Axis axis) {
        return hull(enclose<BigInterval>(box.lower(axis)), enclose<BigInterval>(box.upper(axis)));
    };
    const BigInterval sine = sin_cos(side(Axis::phi)).sin;
    const BigInterval one(1);
    const BigInterval r_lo = one / enclose<BigInterval>(box.rho ? 1 / *box.rho : box.upper(Axis::ratio));
    const BigInterval r_hi = one / enclose<BigInterval>(box.ratio_of_distances());
    // The highest floor: beta2 = 1/(1+r) is greatest at the least r, beta1 = r/(1+r) at the greatest. Of a
    // body they are d1 and d2, and r is rho.
    const Floor light{-sine / (one + r_lo), "light"};
    const Floor heavy{sine * (r_hi / (one + r_hi)), "heavy"};
    const double least =
        std::max({0.0, light.height.hi(), heavy.height.hi()});  // sine and -sine: one is >= 0
    const std::string remedy =
        fmt::format("raise --y above {:.6g}, which suffices for both masses", least * (1 + 1e-5));
    require_above(box, light, remedy);
    require_above(box, heavy, remedy);
}

}  // namespace dumbbell::starts
