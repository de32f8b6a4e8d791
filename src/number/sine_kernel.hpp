#pragma once

/// Sine and cosine in double, as plain arithmetic: lemma L14.
namespace dumbbell {

// Kernels on |y| <= 0.79 (a little more than pi/4): Taylor polynomials with coefficients rounded to double, z
// = y^2.
//
// Let u = 2^-53 (L14). Error of sin_kernel against sin y, relative to |y| (z <= 0.625):
//   remainder |y|^19/19!                                    <= 2e-19 |y|  < 0.002 u |y|
//   Horner sum S (|S| <= 1/6): coefficient, last product and last addition; the inner terms are below 0.01
//                                                           <= 0.37 u, times z: 0.24 u |y|
//   the product y z S: three roundings on at most 0.105 |y| <= 0.32 u |y|
//   the final addition                                      <= 1.0 u |y|
// in all < 1.6 u |y| <= 1.8 u |sin y|.
// Error of cos_kernel against cos y: remainder y^20/20! < 0.0001 u; h = z/2 is exact after z, whose rounding
// gives 0.32 u; the term z^2 C (<= 0.017) 0.07 u; w = 1 - h is corrected by the exact (1 - w) - h, adding the
// two corrections 0.02 u; the final addition 0.5 u. In all < 1 u <= 1.5 u cos y.
[[nodiscard]] inline double sin_kernel(double y) noexcept {
    const double z = y * y;
    const double s =
        -1.0 / 6 +
        z * (1.0 / 120 +
             z * (-1.0 / 5040 +
                  z * (1.0 / 362880 + z * (-1.0 / 39916800 +
                                           z * (1.0 / 6227020800.0 + z * (-1.0 / 1307674368000.0 +
                                                                          z * (1.0 / 355687428096000.0)))))));
    return y + y * z * s;
}

[[nodiscard]] inline double cos_kernel(double y) noexcept {
    const double z = y * y;
    const double c =
        1.0 / 24 +
        z * (-1.0 / 720 +
             z * (1.0 / 40320 + z * (-1.0 / 3628800 +
                                     z * (1.0 / 479001600.0 + z * (-1.0 / 87178291200.0 +
                                                                   z * (1.0 / 20922789888000.0 +
                                                                        z * (-1.0 / 6402373705728000.0)))))));
    const double h = 0.5 * z;
    const double w = 1.0 - h;
    return w + (((1.0 - w) - h) + z * z * c);
}

/// Sine and cosine of z + shift, a double, from those of z, for |shift| up to 2^-13 and 2^-8 times both: off
/// by at most 5.4 u relatively (L63 (b)).
template <class At>
[[nodiscard]] At moved(const At& at, double shift) {
    const double half = 0.5 * (shift * shift);
    const double odd = shift - (half * shift) * (1.0 / 3);
    return {at.sin + (at.cos * odd - at.sin * half), at.cos - (at.sin * odd + at.cos * half)};
}

// The argument above pi/4 is y = (half_pi_hi - x) + half_pi_lo, with sine and cosine exchanged.
inline constexpr double half_pi_hi = 0x1.921fb54442d18p+0;
inline constexpr double half_pi_lo = 0x1.1a62633145c07p-54;  // pi/2 - half_pi_hi, error < 2^-108
inline constexpr double quarter_pi = 0x1.921fb54442d18p-1;
// Beyond [0, pi/2] pi/2 is taken off in three parts, of which the first two are short (L14 (e)).
inline constexpr double half_pi_first = 0x1.921fb544p+0;
inline constexpr double half_pi_second = 0x1.0b4611a4p-34;
inline constexpr double half_pi_third = 0x1.13198a2e03707p-65;  // their sum: pi/2, error < 2^-119

}  // namespace dumbbell
