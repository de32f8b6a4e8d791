#pragma once

#include "flight/batch/pack.hpp"

/// Several packs that go through the same computation side by side, as one pack (pack.hpp) with the lanes of
/// all: while one waits for a result the processor works on another. Each lane's bits are those of a single
/// pack.
namespace dumbbell::flight::batch {

template <class P, int n>
struct MasksOf {
    Mask<P> of[n];

    template <class F>
    [[gnu::always_inline]] static MasksOf each(F f) {
        MasksOf result;
#pragma GCC unroll 4
        for (int i = 0; i < n; ++i) {
            result.of[i] = f(i);
        }
        return result;
    }
    friend MasksOf operator&&(MasksOf a, MasksOf b) {
        return each([&](int i) { return a.of[i] && b.of[i]; });
    }
    friend MasksOf operator||(MasksOf a, MasksOf b) {
        return each([&](int i) { return a.of[i] || b.of[i]; });
    }
    friend MasksOf operator!(MasksOf a) {
        return each([&](int i) { return !a.of[i]; });
    }
    friend MasksOf select(MasksOf m, MasksOf a, MasksOf b) {
        return each([&](int i) { return select(m.of[i], a.of[i], b.of[i]); });
    }
    friend unsigned lanes(MasksOf a) {
        unsigned result = 0;
#pragma GCC unroll 4
        for (int i = 0; i < n; ++i) {
            result |= lanes(a.of[i]) << static_cast<unsigned>(i * Lanes<P>::width);
        }
        return result;
    }
};

template <class P, int n>
struct Packs {
    using Masks = MasksOf<P, n>;
    P of[n];

    Packs() = default;
    Packs(double x) {
#pragma GCC unroll 4
        for (int i = 0; i < n; ++i) {
            of[i] = P(x);
        }
    }

    template <class F>
    [[gnu::always_inline]] static Packs each(F f) {
        Packs result;
#pragma GCC unroll 4
        for (int i = 0; i < n; ++i) {
            result.of[i] = f(i);
        }
        return result;
    }
    friend Packs operator+(Packs a, Packs b) {
        return each([&](int i) { return a.of[i] + b.of[i]; });
    }
    friend Packs operator-(Packs a, Packs b) {
        return each([&](int i) { return a.of[i] - b.of[i]; });
    }
    friend Packs operator*(Packs a, Packs b) {
        return each([&](int i) { return a.of[i] * b.of[i]; });
    }
    friend Packs operator/(Packs a, Packs b) {
        return each([&](int i) { return a.of[i] / b.of[i]; });
    }
    friend Packs operator-(Packs a) {
        return each([&](int i) { return -a.of[i]; });
    }
    friend Masks operator<(Packs a, Packs b) {
        return Masks::each([&](int i) { return a.of[i] < b.of[i]; });
    }
    friend Masks operator<=(Packs a, Packs b) {
        return Masks::each([&](int i) { return a.of[i] <= b.of[i]; });
    }
    friend Masks operator>(Packs a, Packs b) { return b < a; }
    friend Masks operator>=(Packs a, Packs b) { return b <= a; }
    friend Packs select(Masks m, Packs a, Packs b) {
        return each([&](int i) { return select(m.of[i], a.of[i], b.of[i]); });
    }
    friend Packs abs(Packs a) {
        return each([&](int i) { return abs(a.of[i]); });
    }
    friend Packs sqrt(Packs a) {
        return each([&](int i) { return sqrt(a.of[i]); });
    }
    friend Packs max(Packs a, Packs b) {
        return each([&](int i) { return max(a.of[i], b.of[i]); });
    }
    friend Packs min(Packs a, Packs b) {
        return each([&](int i) { return min(a.of[i], b.of[i]); });
    }
};

template <class P, int n>
struct Lanes<Packs<P, n>> {
    using Mask = MasksOf<P, n>;
    static constexpr int width = n * Lanes<P>::width;
    static Mask only(int lane) {
        return Mask::each([&](int i) {
            const int here = lane - i * Lanes<P>::width;
            return here >= 0 && here < Lanes<P>::width ? Lanes<P>::only(here) : Lanes<P>::none();
        });
    }
    static Mask none() {
        return Mask::each([](int) { return Lanes<P>::none(); });
    }
    static void store(double* to, Packs<P, n> a) {
#pragma GCC unroll 4
        for (int i = 0; i < n; ++i) {
            Lanes<P>::store(to + i * Lanes<P>::width, a.of[i]);
        }
    }
};

}  // namespace dumbbell::flight::batch
