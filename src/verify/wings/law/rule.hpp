// What the three rules share: the box, the numbers of the law, the window of J.
#pragma once
#include "verify/core/big.hpp"
#include "verify/core/ray.hpp"
#include "verify/machine/meter.hpp"
#include "verify/wings/law/constants.hpp"
#include "verify/wings/law/kernel.hpp"
#include "verify/wings/law/leaf.hpp"

namespace dumbbell_verify::law {

template <class N>
class Rule : public Rays<N> {
  public:
    using I = Interval<N>;
    using Rays<N>::fact, Rays<N>::less, Rays<N>::half_turn, Rays<N>::quarter, Rays<N>::zero;

  protected:
    Rule(const Leaf& leaf, Log* log) : Rays<N>(log), leaf_(leaf) { Meter::spend(1 << 19); }

    [[nodiscard]] I side(std::size_t axis) const {
        return between(leaf_.box.lo.at(axis), leaf_.box.hi.at(axis));
    }
    /// Certified a <= x <= b, for x of any sign; never if x is empty.
    bool within(const char* what, const I& x, const I& a, const I& b) {
        if (this->log_) this->log_->line({{"  ", x}, {" in ", I(a.hi, b.lo)}});
        return fact(what, x.lo <= x.hi && a.hi <= x.lo && x.hi <= b.lo);
    }
    /// The number, or all between two.
    static I number(const mpq_class& x) { return between(x, x); }
    static I between(const mpq_class& lo, const mpq_class& hi) {
        return {bound(down, lo, N(0)), bound(up, hi, N(0))};
    }
    [[nodiscard]] I drift() const { return number(leaf_.states->drift); }
    [[nodiscard]] I rise() const { return number(leaf_.states->rise); }
    /// What Q is known to be in the layer, before it is J - A (L53).
    [[nodiscard]] I crude_Q() const {
        return quarter + I(fraction<N>(layer_least_Q).lo, fraction<N>(layer_most_Q).hi);
    }

    const Leaf& leaf_;
};

}  // namespace dumbbell_verify::law
