#include "prove/critical_guess.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "model/contact_guess.hpp"
#include "model/reflection.hpp"

namespace dumbbell {
namespace {

constexpr double pi_guess = std::numbers::pi;

/// A ray in plain doubles.
struct GuessedRay {
    double c;
    double kappa;
};

/// The first flights of the extremal orbits: horizontal over the bridge's top, and from the corner along the
/// bridge's tangent.
GuessedRay top(double r) { return {r, 0}; }
GuessedRay corner(double r) { return {pi_guess * r, r}; }

/// How far the ray passes above the wall; < 0 if it collides.
double clearance(const GuessedRay& ray) {
    return ray.c - (std::sqrt(1 - ray.kappa * ray.kappa) - ray.kappa * std::acos(ray.kappa));
}

/// The next flight, if there is one in play.
std::optional<GuessedRay> after_collision(const GuessedRay& ray, double r) {
    const auto contact = guess_contact(Interval(ray.c), Interval(ray.kappa));
    const double x = contact.z.lo();
    const auto out = reflect_at_light_wall(Interval(ray.kappa), Interval(std::cos(x)), Interval(r));
    const double kappa = approximate(out.numerator) / approximate(out.denominator);
    if (!contact.hits || !(approximate(out.denominator) > 0) || !(kappa < 1)) {
        return std::nullopt;
    }
    return GuessedRay{std::sin(x) + kappa * (x + pi_guess), kappa};
}

/// The clearance of the `flight`-th flight, flight >= 1; `far` if the ray does not come so far. Decreases
/// with q.
constexpr double far = 1;
double clearance_of_flight(GuessedRay ray, double r, long flight) {
    for (long i = 1; i < flight; ++i) {
        const auto next = clearance(ray) < 0 ? after_collision(ray, r) : std::nullopt;
        if (!next) {
            return far;
        }
        ray = *next;
    }
    return clearance(ray);
}

long count(GuessedRay ray, double r) {
    long n = 0;
    while (clearance(ray) < 0) {
        ++n;
        const auto next = after_collision(ray, r);
        if (!next) {
            break;
        }
        ray = *next;
    }
    return n;
}

}  // namespace

long guess_maximum(double q) { return 2 + count(top(1 / q), 1 / q) + count(corner(1 / q), 1 / q); }

double guess_critical_ratio(long n) {
    // Odd n = 2 k + 1: the k-th flight of the first orbit is tangent; even n = 2 k + 2: of the second.
    const bool odd = n % 2 != 0;
    const long flight = odd ? (n - 1) / 2 : (n - 2) / 2;
    const auto f = [&](double q) {
        return clearance_of_flight(odd ? top(1 / q) : corner(1 / q), 1 / q, flight);
    };

    const double about = std::pow(static_cast<double>(n - 2) / 0.8855951, 2);
    double lo = 1;
    double hi = std::max(2.0, about * 1.1 + 2);
    while (f(hi) > 0) {
        lo = hi;
        hi *= 1.5;
    }
    // Illinois: regula falsi that halves the weight of an end that stays.
    double f_lo = f(lo);
    double f_hi = f(hi);
    for (int side = 0, i = 0; i < 200 && hi - lo > 2e-16 * hi; ++i) {
        const bool bisect = f_lo >= far || i % 20 == 19;
        double q = bisect ? (lo + hi) / 2 : hi - f_hi * (hi - lo) / (f_hi - f_lo);
        if (!(q > lo && q < hi)) {
            q = (lo + hi) / 2;
            if (!(q > lo && q < hi)) {
                break;
            }
        }
        const double value = f(q);
        if (value > 0) {
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

}  // namespace dumbbell
