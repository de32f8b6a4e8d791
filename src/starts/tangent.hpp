#pragma once

#include <utility>

#include "number/elementary.hpp"
#include "number/interval.hpp"
#include "starts/jet.hpp"

namespace dumbbell::starts {

/// A number that depends on the five quantities of a start, with its derivatives, in doubles: no bound of
/// anything, for guesses only.
struct Tangent {
    double value;
    Gradient<double> gradient;

    explicit Tangent(double constant) : Tangent(constant, Gradient<double>::Zero()) {}
    Tangent(double at, Gradient<double> derivatives) : value(at), gradient(std::move(derivatives)) {}

    friend Tangent operator-(const Tangent& a) { return {-a.value, -a.gradient}; }
    friend Tangent operator+(const Tangent& a, const Tangent& b) {
        return {a.value + b.value, a.gradient + b.gradient};
    }
    friend Tangent operator-(const Tangent& a, const Tangent& b) {
        return {a.value - b.value, a.gradient - b.gradient};
    }
    friend Tangent operator*(const Tangent& a, const Tangent& b) {
        return {a.value * b.value, a.gradient * b.value + b.gradient * a.value};
    }
    friend Tangent operator/(const Tangent& a, const Tangent& b) {
        const double quotient = a.value / b.value;
        return {quotient, (a.gradient - b.gradient * quotient) / b.value};
    }
    friend Tangent sqr(const Tangent& a) { return a * a; }
    /// By the program's own sine, so that guesses are the same on every machine.
    friend SinCos<Tangent> sin_cos(const Tangent& a) {
        const SinCos<Interval> at = dumbbell::sin_cos(Interval(a.value));
        const double sine = approximate(at.sin);
        const double cosine = approximate(at.cos);
        return {{sine, a.gradient * cosine}, {cosine, a.gradient * -sine}};
    }
};

}  // namespace dumbbell::starts
