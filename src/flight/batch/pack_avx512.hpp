#pragma once

#include <immintrin.h>

#include "flight/batch/pack.hpp"

/// Eight doubles in an AVX-512 register (pack.hpp).
namespace dumbbell::flight::batch {

struct Mask8 {
    unsigned bits;  // one for each lane

    friend Mask8 operator&&(Mask8 a, Mask8 b) { return {a.bits & b.bits}; }
    friend Mask8 operator||(Mask8 a, Mask8 b) { return {a.bits | b.bits}; }
    friend Mask8 operator!(Mask8 a) { return {a.bits ^ 0xffU}; }
    friend unsigned lanes(Mask8 a) { return a.bits; }
};
inline Mask8 select(Mask8 m, Mask8 a, Mask8 b) { return (m && a) || (!m && b); }

struct Pack8 {
    __m512d v;

    Pack8() = default;
    Pack8(__m512d values) : v(values) {}
    Pack8(double x) : v(_mm512_set1_pd(x)) {}

    friend Pack8 operator+(Pack8 a, Pack8 b) { return _mm512_add_pd(a.v, b.v); }
    friend Pack8 operator-(Pack8 a, Pack8 b) { return _mm512_sub_pd(a.v, b.v); }
    friend Pack8 operator*(Pack8 a, Pack8 b) { return _mm512_mul_pd(a.v, b.v); }
    friend Pack8 operator/(Pack8 a, Pack8 b) { return _mm512_div_pd(a.v, b.v); }
    friend Pack8 operator-(Pack8 a) { return _mm512_xor_pd(a.v, _mm512_set1_pd(-0.0)); }
    friend Mask8 operator<(Pack8 a, Pack8 b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LT_OQ)}; }
    friend Mask8 operator<=(Pack8 a, Pack8 b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_LE_OQ)}; }
    friend Mask8 operator>(Pack8 a, Pack8 b) { return b < a; }
    friend Mask8 operator>=(Pack8 a, Pack8 b) { return b <= a; }
    friend Pack8 select(Mask8 m, Pack8 a, Pack8 b) {
        return _mm512_mask_blend_pd(static_cast<__mmask8>(m.bits), b.v, a.v);
    }
    friend Pack8 abs(Pack8 a) { return _mm512_abs_pd(a.v); }
    friend Pack8 sqrt(Pack8 a) { return _mm512_mask_sqrt_pd(a.v, 0xff, a.v); }
    friend Pack8 max(Pack8 a, Pack8 b) { return _mm512_mask_max_pd(a.v, 0xff, a.v, b.v); }
    friend Pack8 min(Pack8 a, Pack8 b) { return _mm512_mask_min_pd(a.v, 0xff, a.v, b.v); }
};

template <>
struct Lanes<Pack8> {
    using Mask = Mask8;
    static constexpr int width = 8;
    static Mask none() { return {0}; }
    static Pack8 load(const double* from) { return _mm512_loadu_pd(from); }
    static void store(double* to, Pack8 a) { _mm512_storeu_pd(to, a.v); }
};

}  // namespace dumbbell::flight::batch
