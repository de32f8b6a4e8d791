// What the results of arithmetic depend on besides the numbers, and the program around the verifier may have
// changed.
#pragma once
#include <mpfr.h>

#include <cfenv>

namespace dumbbell_verify {

/// Rounding, traps and subnormal numbers of this thread, and MPFR's settings, as at the start of a program;
/// in the end as they were before. arithmetic_works() says whether that was enough.
class DefaultEnvironment {
  public:
    DefaultEnvironment() {
        std::fegetenv(&floats_);
        std::fesetenv(FE_DFL_ENV);
        set(MPFR_EMIN_DEFAULT, MPFR_EMAX_DEFAULT, 53, MPFR_RNDN);
    }
    ~DefaultEnvironment() {
        set(least_exponent_, greatest_exponent_, precision_, rounding_);
        mpfr_flags_restore(flags_, MPFR_FLAGS_ALL);
        std::fesetenv(&floats_);
    }
    DefaultEnvironment(const DefaultEnvironment&) = delete;
    DefaultEnvironment& operator=(const DefaultEnvironment&) = delete;

  private:
    static void set(mpfr_exp_t least, mpfr_exp_t greatest, mpfr_prec_t precision, mpfr_rnd_t rounding) {
        mpfr_set_emin(least);
        mpfr_set_emax(greatest);
        mpfr_set_default_prec(precision);
        mpfr_set_default_rounding_mode(rounding);
    }

    std::fenv_t floats_{};
    const mpfr_exp_t least_exponent_ = mpfr_get_emin(), greatest_exponent_ = mpfr_get_emax();
    const mpfr_prec_t precision_ = mpfr_get_default_prec();
    const mpfr_rnd_t rounding_ = mpfr_get_default_rounding_mode();
    const mpfr_flags_t flags_ = mpfr_flags_save();
};

}  // namespace dumbbell_verify
