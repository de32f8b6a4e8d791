#pragma once

#include <mpfr.h>

#include "number/big_interval.hpp"
#include "number/interval.hpp"
#include "rooms/number/tightest.hpp"
#include "verify/core/big.hpp"
#include "verify/functions/angle.hpp"

/// The interval layers under attack in one vocabulary: the program's and the verifier's, which share no code,
/// each in double and in multiple precision. `make` and `low`, `high` are exact if the numbers have bits().
namespace dumbbell_test {

/// Sets the precision of both layers in multiple precision on this thread.
class WorkingBits {
  public:
    explicit WorkingBits(int bits) : scope_(bits) { dumbbell_verify::Big::precision = bits; }

  private:
    dumbbell::PrecisionScope scope_;
};

struct ProgramDouble {
    using I = dumbbell::Interval;
    static constexpr const char* name = "program, double";
    static int bits() { return 53; }
    static constexpr bool in_double = true;
    static constexpr bool has_roots = true;  ///< sqrt, asin, abs, min, max
    static I make(mpfr_srcptr lo, mpfr_srcptr hi) {
        return {mpfr_get_d(lo, MPFR_RNDN), mpfr_get_d(hi, MPFR_RNDN)};
    }
    static void low(mpfr_ptr to, const I& x) { mpfr_set_d(to, x.lo(), MPFR_RNDN); }
    static void high(mpfr_ptr to, const I& x) { mpfr_set_d(to, x.hi(), MPFR_RNDN); }
    static I square(const I& x) { return sqr(x); }
    static I join(const I& a, const I& b) { return hull(a, b); }
    static I turn() { return dumbbell::pi<I>(); }
    static I sine(const I& x) { return sin(x); }
    static I cosine(const I& x) { return cos(x); }
};

struct ProgramBig {
    using I = dumbbell::BigInterval;
    static constexpr const char* name = "program, multiple";
    static int bits() { return dumbbell::PrecisionScope::current(); }
    static constexpr bool in_double = false;
    static constexpr bool has_roots = true;
    static I make(mpfr_srcptr lo, mpfr_srcptr hi) {
        I x;
        arf_set_mpfr(x.lower(), lo);
        arf_set_mpfr(x.upper(), hi);
        return x;
    }
    static void low(mpfr_ptr to, const I& x) { arf_get_mpfr(to, x.lower(), MPFR_RNDN); }
    static void high(mpfr_ptr to, const I& x) { arf_get_mpfr(to, x.upper(), MPFR_RNDN); }
    static I square(const I& x) { return sqr(x); }
    static I join(const I& a, const I& b) { return hull(a, b); }
    static I turn() { return dumbbell::pi<I>(); }
    static I sine(const I& x) { return sin_cos(x).sin; }
    static I cosine(const I& x) { return sin_cos(x).cos; }
};

/// What both layers of the verifier have in common.
template <class N>
struct Verifier {
    using I = dumbbell_verify::Interval<N>;
    static constexpr bool has_roots = false;
    static I square(const I& x) { return dumbbell_verify::square(x); }
    static I join(const I& a, const I& b) { return dumbbell_verify::hull(a, b); }
    static I turn() { return dumbbell_verify::pi<N>(); }
    static I quarter() { return turn() / I(2); }
    static I sine(const I& x) { return sin_cos_on(x, quarter()).sin; }
    static I cosine(const I& x) { return sin_cos_on(x, quarter()).cos; }
};

struct VerifierDouble : Verifier<double> {
    static constexpr const char* name = "verifier, double";
    static int bits() { return 53; }
    static constexpr bool in_double = true;
    static I make(mpfr_srcptr lo, mpfr_srcptr hi) {
        return {mpfr_get_d(lo, MPFR_RNDN), mpfr_get_d(hi, MPFR_RNDN)};
    }
    static void low(mpfr_ptr to, const I& x) { mpfr_set_d(to, x.lo, MPFR_RNDN); }
    static void high(mpfr_ptr to, const I& x) { mpfr_set_d(to, x.hi, MPFR_RNDN); }
};

struct VerifierBig : Verifier<dumbbell_verify::Big> {
    using Big = dumbbell_verify::Big;
    static constexpr const char* name = "verifier, multiple";
    static int bits() { return static_cast<int>(Big::precision); }
    static constexpr bool in_double = false;
    static I make(mpfr_srcptr lo, mpfr_srcptr hi) {
        return {Big::rounded(dumbbell_verify::down, mpfr_set, lo),
                Big::rounded(dumbbell_verify::up, mpfr_set, hi)};
    }
    static void low(mpfr_ptr to, const I& x) { mpfr_set(to, x.lo.get(), MPFR_RNDN); }
    static void high(mpfr_ptr to, const I& x) { mpfr_set(to, x.hi.get(), MPFR_RNDN); }
};

}  // namespace dumbbell_test
