#pragma once

#include <immintrin.h>

#include "flight/batch/pack.hpp"

/// Four doubles in an AVX2 register (pack.hpp).
namespace dumbbell::flight::batch {

struct Mask4 {
    __m256d bits;  // all of a lane's, or none

    friend Mask4 operator&&(Mask4 a, Mask4 b) { return {_mm256_and_pd(a.bits, b.bits)}; }
    friend Mask4 operator||(Mask4 a, Mask4 b) { return {_mm256_or_pd(a.bits, b.bits)}; }
    friend Mask4 operator!(Mask4 a) {
        return {_mm256_xor_pd(a.bits, _mm256_castsi256_pd(_mm256_set1_epi64x(-1)))};
    }
    friend unsigned lanes(Mask4 a) { return static_cast<unsigned>(_mm256_movemask_pd(a.bits)); }
};

struct Pack4 {
    __m256d v;

    Pack4() = default;
    Pack4(__m256d values) : v(values) {}
    Pack4(double x) : v(_mm256_set1_pd(x)) {}

    friend Pack4 operator+(Pack4 a, Pack4 b) { return _mm256_add_pd(a.v, b.v); }
    friend Pack4 operator-(Pack4 a, Pack4 b) { return _mm256_sub_pd(a.v, b.v); }
    friend Pack4 operator*(Pack4 a, Pack4 b) { return _mm256_mul_pd(a.v, b.v); }
    friend Pack4 operator/(Pack4 a, Pack4 b) { return _mm256_div_pd(a.v, b.v); }
    friend Pack4 operator-(Pack4 a) { return _mm256_xor_pd(a.v, _mm256_set1_pd(-0.0)); }
    friend Mask4 operator<(Pack4 a, Pack4 b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_LT_OQ)}; }
    friend Mask4 operator<=(Pack4 a, Pack4 b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_LE_OQ)}; }
    friend Mask4 operator>(Pack4 a, Pack4 b) { return b < a; }
    friend Mask4 operator>=(Pack4 a, Pack4 b) { return b <= a; }
    friend Pack4 select(Mask4 m, Pack4 a, Pack4 b) { return _mm256_blendv_pd(b.v, a.v, m.bits); }
    friend Pack4 abs(Pack4 a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v); }
    friend Pack4 sqrt(Pack4 a) { return _mm256_sqrt_pd(a.v); }
    friend Pack4 max(Pack4 a, Pack4 b) { return _mm256_max_pd(a.v, b.v); }
    friend Pack4 min(Pack4 a, Pack4 b) { return _mm256_min_pd(a.v, b.v); }
};
inline Mask4 select(Mask4 m, Mask4 a, Mask4 b) { return {_mm256_blendv_pd(b.bits, a.bits, m.bits)}; }

template <>
struct Lanes<Pack4> {
    using Mask = Mask4;
    static constexpr int width = 4;
    static Mask none() { return {_mm256_setzero_pd()}; }
    static Pack4 load(const double* from) { return _mm256_loadu_pd(from); }
    static void store(double* to, Pack4 a) { _mm256_storeu_pd(to, a.v); }
};

}  // namespace dumbbell::flight::batch
