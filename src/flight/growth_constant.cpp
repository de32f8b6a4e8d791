#include "flight/growth_constant.hpp"

#include "base/error.hpp"
#include "number/flint.hpp"

namespace dumbbell::flight {
namespace {

/// The integrand on a complex ball. It is holomorphic wherever it is finite, as acb_calc demands for order 1:
/// a ball with a zero of cos gives no finite quotient.
int integrand(acb_ptr value, const acb_t theta, void* /*unused*/, slong order, slong bits) {
    require(order <= 1, "the quadrature asks for derivatives");
    acb_cos(value, theta, bits);
    acb_inv(value, value, bits);
    acb_mul_2exp_si(value, value, -1);
    acb_sin_pi(value, value, bits);
    return 0;
}

}  // namespace

BigInterval growth_constant() {
    const slong bits = PrecisionScope::current() + 20;
    acb_t from, to, integral;
    acb_init(from);
    acb_init(to);
    acb_init(integral);
    acb_const_pi(to, bits);
    acb_div_ui(to, to, 3, bits);
    mag_t tolerance;
    mag_init(tolerance);
    mag_set_ui_2exp_si(tolerance, 1, -bits);
    acb_calc_integrate(integral, integrand, nullptr, from, to, bits, tolerance, nullptr, bits);
    BigInterval result;
    arb_get_interval_arf(result.lower(), result.upper(), acb_realref(integral), PrecisionScope::current());
    mag_clear(tolerance);
    acb_clear(from);
    acb_clear(to);
    acb_clear(integral);
    flint_cleanup();
    return result;
}

}  // namespace dumbbell::flight
