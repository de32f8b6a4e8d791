#include "number/sound_arithmetic.hpp"

#include "number/self_test.hpp"

namespace dumbbell {

DefaultEnvironment::DefaultEnvironment()
    : least_exponent_(mpfr_get_emin()),
      greatest_exponent_(mpfr_get_emax()),
      precision_(mpfr_get_default_prec()),
      rounding_(mpfr_get_default_rounding_mode()),
      flags_(mpfr_flags_save()) {
    // Not feholdexcept: it leaves the rounding mode, and the flags that flush subnormal numbers. Where this
    // fails, the self-test finds what is wrong.
    std::fegetenv(&floats_);
    std::fesetenv(FE_DFL_ENV);
    mpfr_set_emin(MPFR_EMIN_DEFAULT);
    mpfr_set_emax(MPFR_EMAX_DEFAULT);
    mpfr_set_default_prec(53);
    mpfr_set_default_rounding_mode(MPFR_RNDN);
}

DefaultEnvironment::~DefaultEnvironment() {
    mpfr_set_emin(least_exponent_);
    mpfr_set_emax(greatest_exponent_);
    mpfr_set_default_prec(precision_);
    mpfr_set_default_rounding_mode(rounding_);
    mpfr_flags_restore(flags_, MPFR_FLAGS_ALL);
    std::fesetenv(&floats_);
}

SoundArithmetic::SoundArithmetic() { require_sound_arithmetic(); }

}  // namespace dumbbell
