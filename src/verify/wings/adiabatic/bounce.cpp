// A leaf of the tree of one bounce: the errors E1 and E2 of L38 (format-adiabatic.md, section 5).
#include "verify/wings/adiabatic/bounce.hpp"

#include "verify/wings/adiabatic/check.hpp"

namespace dumbbell_verify::adiabatic {
namespace {

template <class N>
class BounceCheck : Check<N> {
    using Base = Check<N>;
    using Base::fact, Base::leaf_, Base::claim_, Base::m_, Base::quarter, Base::zero, Base::one, Base::number;
    using typename Base::I, typename Base::Ray;

  public:
    BounceCheck(const Leaf& leaf, Log* log)
        : Base(leaf, Masses<N>(Base::side(leaf.box, axis_delta)), log),
          whole_u_(Base::side(axis_u)),
          u_(Base::cut(whole_u_)),
          climb_(m_.delta * Base::side(axis_s)) {}

    /// nullptr if all is certified, else what is not.
    const char* verdict() { return (leaf_.outside ? is_outside() : is_bounded()) ? nullptr : Base::failed(); }

  private:
    [[nodiscard]] Touch<N> touch() const { return Touch<N>::at(m_, u_, quarter); }
    [[nodiscard]] I incoming() const { return -(climb_ / m_.beta2); }

    bool is_outside() {
        if (Base::beyond("u beyond pi/2", whole_u_)) return true;
        if (!Base::reaches(u_)) return false;
        const Touch<N> at = touch();
        const I y = m_.beta2 * at.sine;
        return Base::less("y below the heights", y, number(claim_.y_lo)) ||
               Base::less("y above the heights", number(claim_.y_hi), y) ||
               Base::at_most("D <= 0", onward(m_, at.w, incoming()), I(0));
    }

    bool is_bounded() {
        if (!Base::reaches(u_)) return false;
        const Touch<N> at = touch();
        const I kappa = incoming();
        // Of the states with D > 0; the others have no next collision (L1).
        const I slope = slope_behind(m_, at.w, kappa);
        const I corner = corner_behind(at, slope);
        // Where D may be <= 0 the upper ends of slope and corner are infinite.
        if (corner.hi < zero) return fact("the next corner is not passed", true);
        const Ray lowest{std::max(zero, corner.lo), slope.lo, zero}, highest{corner.hi, slope.hi, zero};
        if (slope.lo >= one || this->misses(lowest)) return fact("no light collision follows", true);
        const auto k = static_cast<unsigned>(claim_.exponent);
        return Base::at_most("E1 <= C1 delta^(2 - 2k)", error_of_spin(m_, at, kappa),
                             number(claim_.bounds.at(0)) * sixteenths(m_.delta, 32 - 2 * k)) &&
               Base::less("0 < D", I(0), onward(m_, at.w, kappa)) &&
               Base::at_most("E2 <= 2 C2 delta^(2 - k)",
                             Base::size(error_of_height(m_, at, climb_, kappa, slope, next(lowest, highest))),
                             I(2) * number(claim_.bounds.at(1)) * sixteenths(m_.delta, 32 - k));
    }

    /// The corner distance of the next contact, for all rays between these.
    [[nodiscard]] I next(const Ray& lowest, const Ray& highest) const {
        N z = zero;
        guess_root(lowest.c, lowest.kappa, z);
        const N from = this->earliest(lowest, z).x;
        N until = quarter.hi;
        if (highest.kappa < one && guess_root(highest.c, highest.kappa, z))
            if (const auto last = this->latest(highest, z)) until = last->x;
        return span(from, until);
    }

    const I whole_u_, u_, climb_;  ///< climb: -ydot
};

}  // namespace

const char* check_bounce(const Leaf& leaf, Log* log) { return judged<BounceCheck>(leaf, log); }

}  // namespace dumbbell_verify::adiabatic
