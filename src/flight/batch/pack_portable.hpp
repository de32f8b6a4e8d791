#pragma once

#include "flight/batch/pack.hpp"

/// Two doubles (pack.hpp) by the compiler's own vectors, which any machine has: in one register where its
/// basic instructions know such, as those of every x86-64 and of 64-bit ARM do.
namespace dumbbell::flight::batch {

using TwoDoubles = double __attribute__((vector_size(16)));
using TwoBits = long long __attribute__((vector_size(16)));

struct Mask2 {
    TwoBits bits;  // all of a lane's, or none

    friend Mask2 operator&&(Mask2 a, Mask2 b) { return {a.bits & b.bits}; }
    friend Mask2 operator||(Mask2 a, Mask2 b) { return {a.bits | b.bits}; }
    friend Mask2 operator!(Mask2 a) { return {~a.bits}; }
    friend unsigned lanes(Mask2 a) {
        return static_cast<unsigned>(a.bits[0] & 1) | static_cast<unsigned>(a.bits[1] & 2);
    }
};
inline Mask2 select(Mask2 m, Mask2 a, Mask2 b) { return {(m.bits & a.bits) | (~m.bits & b.bits)}; }

struct Pack2 {
    TwoDoubles v;

    Pack2() = default;
    Pack2(TwoDoubles values) : v(values) {}
    Pack2(double x) : v{x, x} {}
    explicit Pack2(TwoBits bits) : v(reinterpret_cast<TwoDoubles>(bits)) {}

    [[nodiscard]] TwoBits bits() const { return reinterpret_cast<TwoBits>(v); }

    friend Pack2 operator+(Pack2 a, Pack2 b) { return a.v + b.v; }
    friend Pack2 operator-(Pack2 a, Pack2 b) { return a.v - b.v; }
    friend Pack2 operator*(Pack2 a, Pack2 b) { return a.v * b.v; }
    friend Pack2 operator/(Pack2 a, Pack2 b) { return a.v / b.v; }
    friend Pack2 operator-(Pack2 a) { return -a.v; }
    friend Mask2 operator<(Pack2 a, Pack2 b) { return {a.v < b.v}; }
    friend Mask2 operator<=(Pack2 a, Pack2 b) { return {a.v <= b.v}; }
    friend Mask2 operator>(Pack2 a, Pack2 b) { return {a.v > b.v}; }
    friend Mask2 operator>=(Pack2 a, Pack2 b) { return {a.v >= b.v}; }
    friend Pack2 select(Mask2 m, Pack2 a, Pack2 b) {
        return Pack2((m.bits & a.bits()) | (~m.bits & b.bits()));
    }
    friend Pack2 abs(Pack2 a) { return Pack2(a.bits() & ~Pack2(-0.0).bits()); }
    friend Pack2 sqrt(Pack2 a) { return TwoDoubles{__builtin_sqrt(a.v[0]), __builtin_sqrt(a.v[1])}; }
    friend Pack2 max(Pack2 a, Pack2 b) { return a.v > b.v ? a.v : b.v; }
    friend Pack2 min(Pack2 a, Pack2 b) { return a.v < b.v ? a.v : b.v; }
};

template <>
struct Lanes<Pack2> {
    using Mask = Mask2;
    static constexpr int width = 2;
    static Mask none() { return {TwoBits{0, 0}}; }
    static Pack2 load(const double* from) { return TwoDoubles{from[0], from[1]}; }
    static void store(double* to, Pack2 a) {
        to[0] = a.v[0];
        to[1] = a.v[1];
    }
};

}  // namespace dumbbell::flight::batch
