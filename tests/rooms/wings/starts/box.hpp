#pragma once

#include <random>

#include "attacks/oracle/simulate.hpp"
#include "starts/answer/trace.hpp"
#include "starts/cover/certificate.hpp"

namespace dumbbell_trace_test {

/// The five intervals of a box of initial conditions, as exact doubles.
struct Sides {
    double phi_lo, phi_hi, phidot_lo, phidot_hi, y_lo, y_hi, ydot_lo, ydot_hi;
    double q;

    [[nodiscard]] dumbbell::starts::Box box() const {
        using dumbbell::exact;
        return {{exact(phi_lo), exact(phidot_lo), exact(y_lo), exact(ydot_lo), exact(q)},
                {exact(phi_hi), exact(phidot_hi), exact(y_hi), exact(ydot_hi), exact(q)}};
    }
};

/// A single start.
inline dumbbell::starts::Box point(const dumbbell::Rational& phi, const dumbbell::Rational& phidot,
                                   const dumbbell::Rational& y, const dumbbell::Rational& ydot,
                                   const dumbbell::Rational& q) {
    const std::array<dumbbell::Rational, dumbbell::starts::axis_count> at{phi, phidot, y, ydot, q};
    return {at, at};
}

inline double uniform(std::mt19937_64& engine, double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(engine);
}

/// A random box in the air: falling from above or launched from low down, with sides of up to `size`; every
/// tenth straddles phidot = 0.
inline Sides random_sides(std::mt19937_64& engine, double q, double size) {
    const auto width = [&] { return size * uniform(engine, 0, 1); };
    const double phi = uniform(engine, -3, 3);
    const bool straddles = uniform(engine, 0, 1) < 0.1;
    const double phidot = straddles ? -size / 2 : uniform(engine, -2, 2);
    const double y = uniform(engine, 1, 3);
    const double ydot = -uniform(engine, 0.1, 2);
    return {phi, phi + width(), phidot, phidot + width(),
            y,   y + width(),   ydot,   ydot + std::min(width(), -ydot / 2),
            q};
}

inline dumbbell_oracle::State<long double> random_start(std::mt19937_64& engine, const Sides& s) {
    return {uniform(engine, s.phi_lo, s.phi_hi), uniform(engine, s.phidot_lo, s.phidot_hi),
            uniform(engine, s.y_lo, s.y_hi), uniform(engine, s.ydot_lo, s.ydot_hi)};
}

/// Is x, of a simulation with a relative error of up to `error`, what the enclosure is of?
inline bool holds(const dumbbell::starts::TracedValue& value, long double x, long double error = 1e-12L) {
    const long double tolerance = error * (1 + std::abs(x));
    return value.outward.lo() - tolerance <= x && x <= value.outward.hi() + tolerance;
}

}  // namespace dumbbell_trace_test
