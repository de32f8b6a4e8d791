#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace dumbbell::starts {

/// The parameters of a box of initial conditions: phi, phidot, y, ydot and the mass ratio.
inline constexpr std::size_t parameters = 5;

/// The derivatives of a function by the parameters: enclosures of them, or doubles for guesses.
template <class T>
class Gradient {
  public:
    /// Of a constant.
    Gradient() { entries_.fill(T(0)); }
    /// The entries f(i).
    template <class F>
    [[nodiscard]] static Gradient of(F f) {
        return Gradient({f(0), f(1), f(2), f(3), f(4)});
    }
    /// Of the parameter i.
    [[nodiscard]] static Gradient unit(std::size_t i) {
        Gradient result;
        result[i] = T(1);
        return result;
    }

    [[nodiscard]] T& operator[](std::size_t i) { return entries_[i]; }
    [[nodiscard]] const T& operator[](std::size_t i) const { return entries_[i]; }

    friend Gradient operator-(const Gradient& a) {
        return of([&](std::size_t i) { return -a[i]; });
    }
    friend Gradient operator+(const Gradient& a, const Gradient& b) {
        return of([&](std::size_t i) { return a[i] + b[i]; });
    }
    friend Gradient operator-(const Gradient& a, const Gradient& b) {
        return of([&](std::size_t i) { return a[i] - b[i]; });
    }
    friend Gradient operator*(const Gradient& a, const T& factor) {
        return of([&](std::size_t i) { return a[i] * factor; });
    }
    friend Gradient operator/(const Gradient& a, const T& divisor) {
        return of([&](std::size_t i) { return a[i] / divisor; });
    }
    /// The change of the function, if its parameters change so much.
    [[nodiscard]] T dot(const Gradient& change) const {
        T sum = entries_[0] * change[0];
        for (std::size_t i = 1; i < parameters; ++i) {
            sum = sum + entries_[i] * change[i];
        }
        return sum;
    }

  private:
    explicit Gradient(std::array<T, parameters> entries) : entries_(std::move(entries)) {}

    std::array<T, parameters> entries_;
};

}  // namespace dumbbell::starts
