#include "collisions/step_guess.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "flight/extremal_orbit.hpp"

namespace dumbbell::collisions {

using flight::Ray;

namespace {

/// The first flight of an orbit in plain doubles: enclosures are several times slower, and nothing rests on
/// it.
Ray<double> guessed_ray(flight::ExtremalOrbit orbit, double r) {
    const auto ray = extremal_ray(orbit, Interval(r));
    return {approximate(ray.c), approximate(ray.kappa), r};
}

/// How far the ray passes below the hump's highest parallel; > 0 if it collides.
double guessed_margin(const Ray<double>& ray) {
    return std::sqrt(1 - ray.kappa * ray.kappa) - ray.kappa * std::acos(ray.kappa) - ray.c;
}

/// The next flight, if there is one in play.
std::optional<Ray<double>> guessed_next(const Ray<double>& ray) {
    const auto contact = flight::guess_contact(Interval(ray.c), Interval(ray.kappa));
    const double x = contact.z.lo();
    const auto out =
        flight::reflect_at_light_wall(Interval(ray.kappa), Interval(std::cos(x)), Interval(ray.r));
    const double kappa = approximate(out.numerator) / approximate(out.denominator);
    if (!contact.hits || !(approximate(out.denominator) > 0) || !(kappa < 1)) {
        return std::nullopt;
    }
    return Ray<double>{std::sin(x) + kappa * (x + std::numbers::pi), kappa, ray.r};
}

/// The margin of a flight; `far` if the orbit does not come so far. Increases with q.
constexpr double far = -1;
double guessed_margin(const flight::ExtremalFlight& flight, double q, const Interrupted& interrupted) {
    Ray<double> ray = guessed_ray(flight.orbit, 1 / q);
    for (long i = 1; i < flight.flight; ++i) {
        const bool goes_on = guessed_margin(ray) > 0 && !ends_early(i, interrupted);
        const auto next = goes_on ? guessed_next(ray) : std::nullopt;
        if (!next) {
            return far;
        }
        ray = *next;
    }
    return guessed_margin(ray);
}

long guessed_count(flight::ExtremalOrbit orbit, double r, const Interrupted& interrupted) {
    long n = 0;
    for (std::optional ray = guessed_ray(orbit, r);
         ray && guessed_margin(*ray) > 0 && !ends_early(n, interrupted); ++n) {
        ray = guessed_next(*ray);
    }
    return n;
}

}  // namespace

long guess_maximum(double q, const Interrupted& interrupted) {
    return 2 + guessed_count(flight::ExtremalOrbit::top, 1 / q, interrupted) +
           guessed_count(flight::ExtremalOrbit::corner, 1 / q, interrupted);
}

double guess_step(long n, const Interrupted& interrupted) {
    const flight::ExtremalFlight flight = flight::tangent_flight(n);
    const auto f = [&](double q) { return guessed_margin(flight, q, interrupted); };

    const double about = std::pow(static_cast<double>(n - 2) / 0.8855951, 2);
    double lo = 1;
    double hi = std::max(2.0, about * 1.1 + 2);
    while (f(hi) < 0 && !interrupted()) {
        lo = hi;
        hi *= 1.5;
    }
    // Illinois: regula falsi that halves the weight of an end that stays.
    double f_lo = f(lo);
    double f_hi = f(hi);
    for (int side = 0, i = 0; i < 200 && hi - lo > 2e-16 * hi && !interrupted(); ++i) {
        const bool bisect = f_lo <= far || i % 20 == 19;
        double q = bisect ? (lo + hi) / 2 : hi - f_hi * (hi - lo) / (f_hi - f_lo);
        if (!(q > lo && q < hi)) {
            q = (lo + hi) / 2;
            if (!(q > lo && q < hi)) {
                break;
            }
        }
        const double value = f(q);
        if (value < 0) {
            lo = q;
            f_lo = value;
            f_hi = side == 1 ? f_hi / 2 : f_hi;
            side = 1;
        } else {
            hi = q;
            f_hi = value;
            f_lo = side == -1 ? f_lo / 2 : f_lo;
            side = -1;
        }
    }
    return hi;
}

}  // namespace dumbbell::collisions
