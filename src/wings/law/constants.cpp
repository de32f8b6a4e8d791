#include "law/constants.hpp"

#include "flight/growth_constant.hpp"
#include "number/flint.hpp"

namespace dumbbell::law {

BigInterval correction_constant() {
    const slong bits = PrecisionScope::current() + 20;
    arb_t value, factor;
    arb_init(value);
    arb_init(factor);
    arb_set_d(value, -0.5);
    arb_zeta(value, value, bits);
    arb_mul_si(value, value, -4, bits);  // zeta(-1/2) < 0
    arb_sqrt_ui(factor, 27, bits);       // 3^(3/4) = sqrt(sqrt 27)
    arb_sqrt(factor, factor, bits);
    arb_div(value, value, factor, bits);
    arb_const_sqrt_pi(factor, bits);
    arb_div(value, value, factor, bits);
    BigInterval result;
    arb_get_interval_arf(result.lower(), result.upper(), value, PrecisionScope::current());
    arb_clear(value);
    arb_clear(factor);
    flint_cleanup();
    return result;
}

Constants::Constants()
    : C(flight::growth_constant()),
      c0(correction_constant()),
      kappa(BigInterval(5) / (BigInterval(36) * sqrt(BigInterval(3)) * pi<BigInterval>())) {}

}  // namespace dumbbell::law
