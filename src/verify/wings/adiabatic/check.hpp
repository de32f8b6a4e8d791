// What the checks of all trees of an `adiabatic-*` file share: the leaf's box, and the distance from the
// vertical that the claim is about.
#pragma once
#include "verify/core/big.hpp"
#include "verify/wings/adiabatic/contact.hpp"
#include "verify/wings/adiabatic/grammar.hpp"
#include "verify/wings/starts/ray.hpp"

namespace dumbbell_verify::adiabatic {

template <class N>
class Check : protected starts::Departures<N> {
  public:
    using I = Interval<N>;
    using Base = starts::Departures<N>;
    using Base::fact, Base::quarter, Base::half_turn, Base::zero, Base::one;

  protected:
    Check(const Leaf& leaf, const Masses<N>& masses, Log* log)
        : Base(masses.r, log),
          leaf_(leaf),
          claim_(leaf.terms->claim),
          m_(masses),
          margin_(number(claim_.margin) * sixteenths(m_.delta, static_cast<unsigned>(claim_.exponent))) {}

    static I number(const mpq_class& x) { return {bound(down, x, N(0)), bound(up, x, N(0))}; }
    static I side(const Box& box, std::size_t axis) {
        return {bound(down, box.lo.at(axis), N(0)), bound(up, box.hi.at(axis), N(0))};
    }
    [[nodiscard]] I side(std::size_t axis) const { return side(leaf_.box, axis); }

    /// Certified a < b and a <= b, for the log as well.
    bool less(const char* what, const I& a, const I& b) { return Base::less(what, a, b); }
    bool at_most(const char* what, const I& a, const I& b) { return Base::less(what, a, b, false); }

    /// Distances from the vertical of the leaf that belong to the claim: at least the margin, at most pi/2.
    [[nodiscard]] I cut(const I& u) const { return {std::max(u.lo, margin_.lo), std::min(u.hi, quarter.hi)}; }
    bool reaches(const I& cut) {
        return fact("the leaf reaches below pi/2 and above the margin", cut.lo <= cut.hi);
    }
    /// Certified: none does.
    bool beyond(const char* what, const I& u) {
        return less(what, quarter, I(u.lo)) || less("u below the margin", I(u.hi), I(margin_.lo));
    }
    /// The greatest size of a number of the interval.
    [[nodiscard]] static I size(const I& x) { return I(std::max(-x.lo, x.hi)); }

    const Leaf& leaf_;
    const Claim& claim_;
    const Masses<N> m_;
    const I margin_;
};

}  // namespace dumbbell_verify::adiabatic
