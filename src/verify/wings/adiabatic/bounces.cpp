// A leaf of the tree of a run or a scattering: the change of I between two collisions of the light mass
// (format-adiabatic.md, section 4).
#include "verify/wings/adiabatic/check.hpp"

namespace dumbbell_verify::adiabatic {
namespace {

/// u: of collision 0, v: of collision n.
template <class N>
class BouncesCheck : Check<N> {
    using Base = Check<N>;
    using Base::fact, Base::leaf_, Base::claim_, Base::m_, Base::quarter, Base::zero, Base::number;
    using typename Base::I;

  public:
    BouncesCheck(const Leaf& leaf, Log* log)
        : Base(leaf, Masses<N>(Base::side(leaf.box, axis_delta)), log),
          whole_u_(Base::side(axis_u)),
          whole_v_(Base::side(axis_v)),
          u_(Base::cut(whole_u_)),
          v_(Base::cut(whole_v_)),
          s_(Base::side(axis_s)) {}

    /// nullptr if all is certified, else what is not.
    const char* verdict() { return (leaf_.outside ? is_outside() : is_bounded()) ? nullptr : Base::failed(); }

  private:
    bool is_outside() {
        if (Base::beyond("u beyond pi/2", whole_u_) || Base::beyond("v beyond pi/2", whole_v_)) return true;
        if (!Base::reaches(u_)) return false;
        if (claim_.kind == Claim::scattering)
            return fact("collision 0 is not the first", has_collision_before());
        const I y = m_.beta2 * sin_cos_on(u_, quarter).cos;
        return Base::less("y below the heights", y, number(claim_.y_lo)) ||
               Base::less("y above the heights", number(claim_.y_hi), y);
    }
    /// The flight before collision 0, reversed, certainly meets the light wall: sin z > its height there.
    bool has_collision_before() {
        const I slope = m_.delta * s_ / m_.beta2;
        const I x = I((quarter - u_.lo).hi), k = I(slope.hi), height = I(sin_cos_on(u_, quarter).cos.hi);
        const I z = guess_top(k.hi, quarter.lo);
        return Base::less("sin x + |kappa| (x + pi + z) < sin z", height + k * (x + Base::half_turn + z),
                          sin_cos_on(z, quarter).sin);
    }

    bool is_bounded() {
        if (!(Base::reaches(u_) && Base::reaches(v_))) return false;
        const Class& chosen = leaf_.terms->classes.at(leaf_.index);
        const Touch<N> first = Touch<N>::at(m_, u_, quarter), last = Touch<N>::at(m_, v_, quarter);
        const I kappa_0 = -(m_.delta * s_ / m_.beta2), energy = root(I(1) + square(s_) / m_.beta2);
        const I S_0 = first.h(kappa_0);
        if (claim_.kind == Claim::scattering && !is_above_bridge(S_0, energy)) return false;
        const N V_0 = chosen.potential.upper(u_.lo), V_n = chosen.potential.upper(v_.lo);
        const I unit = energy * m_.r_over_delta;
        if (!Base::at_most("J sqrt(E) <= S_0 - r sqrt(E) V_n", number(chosen.J) * energy,
                           S_0 - m_.delta * unit * I(V_n)))
            return false;
        const I d = unit * I(-V_n, V_0), S_n = S_0 + m_.delta * d;
        const I tau = I((S_n * (I(1) + last.e) / (last.f * energy)).lo), rest = I(1) + last.e - square(tau);
        if (!(fact("tau > 0", tau.lo > zero) && Base::less("r/w_n^2 < tau^2", last.e, square(tau))))
            return false;
        if (Base::less("no such collision: 1 + r/w_n^2 < tau^2", rest, I(0))) return true;
        const I spread = tau * root(rest), tilt = m_.root_r / last.w, divisor = square(tau) - last.e;
        const I sigma_lo = (-tilt - spread) / divisor, sigma_hi = (spread - tilt) / divisor;
        const I before = first.f * (m_.r_over_delta / first.w - s_ / m_.beta2) / (first.w + m_.r / first.w);
        const I g_hi = slope_term(last.w, sigma_hi * m_.root_r, over_delta(sigma_hi));
        if (!fact("kappa_n < w_n", (last.w - sigma_hi * m_.root_r).lo > zero)) return false;
        if (claim_.kind == Claim::run) {
            const I g_lo = slope_term(last.w, sigma_lo * m_.root_r, over_delta(sigma_lo));
            return Base::at_most("|I_n - I_0|/delta <= C", Base::size(d + S_n * I(g_lo.lo, g_hi.hi) - before),
                                 number(claim_.bounds.at(0)));
        }
        return is_scattering(first, last, d, S_n, before, g_hi, sigma_hi);
    }
    /// No descending flight of a scattering comes down to the bridge (L37).
    bool is_above_bridge(const I& S_0, const I& energy) {
        const I z = m_.beta2 * m_.r, angle = quarter + z * arcsine_share(z);
        return Base::less("the heavy mass is not touched",
                          angle * root(I(1) + m_.r / (I(1) - square(m_.r))) * energy, S_0);
    }
    /// I_n is after collision n, the last one.
    bool is_scattering(const Touch<N>& first, const Touch<N>& last, const I& d, const I& S_n, const I& before,
                       const I& g_hi, const I& sigma_hi) {
        if (!Base::less("r/w_n^2 < 1", last.e, I(1))) return false;
        // kappa over delta of a flight that leaves horizontally
        const I flat = -(I(2) * m_.r_over_delta / (last.w * (I(1) - last.e)));
        const I g_lo = slope_term(last.w, m_.delta * flat, flat);
        const I g(g_lo.lo, g_hi.hi), most = number(claim_.bounds.at(0)) / root(m_.delta);
        if (!Base::at_most("|I_n - I_0|/delta <= C/sqrt(delta)", Base::size(d - S_n * g - before), most))
            return false;
        if ((last.square_w - I(2) * sigma_hi * m_.root_r * last.w - m_.r).lo > zero) return true;
        const I onward = (-(S_n * (I(1) - m_.delta * g)) - first.f) / m_.delta;
        return Base::at_most("the same if the last flight goes on", Base::size(onward), most);
    }

    [[nodiscard]] I over_delta(const I& sigma) const { return sigma / root(m_.beta2); }
    /// g(kappa)/delta (L33), given kappa/delta.
    [[nodiscard]] I slope_term(const I& w, const I& kappa, const I& kappa_over_delta) const {
        return (m_.r_over_delta / w + kappa_over_delta) / (w - kappa);
    }

    const I whole_u_, whole_v_, u_, v_, s_;
};

}  // namespace

const char* check_bounces(const Leaf& leaf, Log* log) { return judged<BouncesCheck>(leaf, log); }

}  // namespace dumbbell_verify::adiabatic
