// Where the steps of the staircase must be, for the law to hold there (format-law.md, section 2).
#pragma once
#include "verify/core/big.hpp"
#include "verify/wings/law/claim.hpp"
#include "verify/wings/law/constants.hpp"

namespace dumbbell_verify::law {

/// With delta(x) = C sqrt x - (N - 2) and q_c(N) in [a, b]. (The last has a >= 10^6, as sqrt a > 900/C.)
template <class N>
class StepPlaces {
    using I = Interval<N>;

  public:
    /// nullptr if all is certified, else what is not.
    [[nodiscard]] const char* check(std::uint64_t step, const mpq_class& a, const mpq_class& b) const {
        const I before = delta(step, a), behind = delta(step, b),
                quarter_power = square_root(square_root(number(b)));
        const auto less = [](const I& x, const I& y) { return x.hi < y.lo; };
        if (!less(fraction<N>(least_delta), before)) return "C sqrt A - (N - 2) > -0.115";
        if (!less(behind, fraction<N>(most_delta))) return "C sqrt B - (N - 2) < 0.02";
        if (step >= law_step && !less(0, before)) return "C sqrt A - (N - 2) > 0";
        if (step >= law_step && !less(behind, c0_ / quarter_power)) return "C sqrt B - (N - 2) < c0 B^(-1/4)";
        return nullptr;
    }

  private:
    static I number(const mpq_class& x) { return {bound(down, x, N(0)), bound(up, x, N(0))}; }
    [[nodiscard]] I delta(std::uint64_t step, const mpq_class& x) const {
        return C_ * square_root(number(x)) - I(static_cast<int>(step - 2));
    }
    const I C_ = growth_constant<N>(), c0_ = law_constant<N>();
};

}  // namespace dumbbell_verify::law
