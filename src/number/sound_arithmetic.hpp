#pragma once

#include <mpfr.h>

#include <cfenv>

namespace dumbbell {

/// What the results of arithmetic depend on, and a program may have changed: the floating-point environment
/// (rounding, flushing of subnormal numbers, traps) and MPFR's range of exponents, precision and rounding. As
/// at the start of a program, on this thread and for its lifetime; then as it was before.
class DefaultEnvironment {
  public:
    DefaultEnvironment();
    ~DefaultEnvironment();
    DefaultEnvironment(const DefaultEnvironment&) = delete;
    DefaultEnvironment& operator=(const DefaultEnvironment&) = delete;

  private:
    std::fenv_t floats_{};
    mpfr_exp_t least_exponent_, greatest_exponent_;
    mpfr_prec_t precision_;
    mpfr_rnd_t rounding_;
    mpfr_flags_t flags_;
};

/// For its lifetime this thread's arithmetic is what every enclosure rests on, whatever was made of it
/// before.
class SoundArithmetic {
  public:
    /// Throws BrokenInvariant where the self-test (self_test.hpp) fails also in the default environment.
    SoundArithmetic();

  private:
    DefaultEnvironment environment_;
};

}  // namespace dumbbell
