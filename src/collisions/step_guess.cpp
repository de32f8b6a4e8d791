#include "collisions/step_guess.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "flight/count.hpp"
#include "flight/extremal_orbit.hpp"
#include "flight/growth_constant.hpp"

namespace dumbbell::collisions {

using flight::ExtremalFlight;
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

constexpr double far = -1;
constexpr double rough_growth = 0.8855951294527139;  // C of the law

}  // namespace

double guess_margin(long n, double q, const Interrupted& interrupted) {
    const ExtremalFlight flight = flight::tangent_flight(n);
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

namespace {

/// About C: its relative error, n - 2 times, must be small. Nothing interrupts the quadrature, which takes
/// some milliseconds for 512 bits, and minutes for some thousand.
BigInterval growth(long n) {
    if (!flight::macro::is_long(n)) {
        return BigInterval(rough_growth);
    }
    const PrecisionScope scope(std::min(512, PrecisionScope::current()));
    return flight::growth_constant();
}

/// C sqrt q - (n - 2), the place of q between the steps, is what the search is for. Near 0, where the step to
/// n lies, the margin of the flight that decides is nearly a linear function of it.
class Search {
  public:
    /// Works with the precision of the present scope.
    Search(long n, const Interrupted& interrupted)
        : flight_(flight::tangent_flight(n)),
          last_(enclose<BigInterval>(Rational(n - 2))),
          growth_(growth(n)),
          interrupted_(interrupted) {}

    [[nodiscard]] BigInterval place(double q) const {
        return midpoint(growth_ * sqrt(BigInterval(q)) - last_);
    }
    [[nodiscard]] Rational ratio(const BigInterval& place) const {
        return exact_lo(midpoint(sqr((last_ + place) / growth_)));
    }

    /// Where the margin seems to be 0, by the secant method from two places; nothing if the orbit does not
    /// come so far near them, or does not get there.
    [[nodiscard]] std::optional<BigInterval> zero(BigInterval before, BigInterval place,
                                                  int share_bits) const {
        constexpr int most_steps = 12;
        auto value_before = margin_at(before);
        for (int i = 0; i < most_steps && value_before; ++i) {
            const auto value = margin_at(place);
            if (!value || interrupted_()) {
                return std::nullopt;
            }
            const BigInterval distance = place - before;
            const BigInterval change = midpoint(*value * distance / (*value - *value_before));
            before = place;
            value_before = value;
            place = midpoint(place - change);
            // The next error is about the product of the last two.
            if (std::abs(approximate(change * distance)) < std::ldexp(1, -share_bits)) {
                return place;
            }
        }
        return std::nullopt;
    }

  private:
    /// Of the flight that decides; thin, and nearly right.
    [[nodiscard]] std::optional<BigInterval> margin_at(const BigInterval& place) const {
        const BigInterval r = midpoint(BigInterval(1) / enclose<BigInterval>(ratio(place)));
        std::optional<flight::Ray<BigInterval>> last;
        (void)count_at_most(extremal_ray(flight_.orbit, r), flight_.flight - 1, interrupted_,
                            [&](const Count& count, const BigInterval& c, const BigInterval& kappa) {
                                if (count == flight_.flight - 1) {
                                    last = {c, kappa, r};
                                }
                            });
        return last ? std::optional(midpoint(margin(*last))) : std::nullopt;
    }

    ExtremalFlight flight_;
    BigInterval last_, growth_;
    const Interrupted& interrupted_;
};

/// Without macro steps, which shorter orbits do not have, a flight loses little.
int bits_to_find(long n, int share_bits) {
    return n < flight::macro::least_with_few_bits ? share_bits + 64 : bits_of_step(share_bits);
}

/// The place of the step to n between the steps before and after it, to about 2^-share_bits.
std::optional<BigInterval> place_of_step(long n, int share_bits, const Interrupted& interrupted) {
    // By the law the place lies a little above 0; few bits lead near it, as doubles do for short orbits, and
    // two places near it to the rest.
    constexpr int first_bits = 24;
    BigInterval place(0);
    double near = 0x1p-6;
    int share = std::min(first_bits, share_bits);
    if (!flight::macro::is_long(n)) {
        place = Search(n, interrupted).place(guess_step(n, interrupted));
        near = 0x1p-20;
        share = share_bits;
    }
    for (;; share = share_bits) {
        const PrecisionScope scope(bits_to_find(n, share));
        const auto found = Search(n, interrupted).zero(place + BigInterval(near), place, share);
        if (!found || share == share_bits) {
            return found;
        }
        place = *found;
        near = std::ldexp(1, 4 - share);
    }
}

}  // namespace

double guess_step(long n, const Interrupted& interrupted) {
    // By the law sqrt q is (n - 2)/C and a little more; for few collisions a little less.
    const double about = static_cast<double>(n - 2) / rough_growth;
    const auto margin = [&](double root) { return guess_margin(n, root * root, interrupted); };
    double lo = std::max(1.0, about - 0.2);
    double hi = about + 0.2;
    double at_lo = margin(lo), at_hi = margin(hi);
    while (at_hi <= 0 && !interrupted()) {
        lo = std::exchange(hi, 1.5 * hi);
        at_lo = std::exchange(at_hi, margin(hi));
    }
    if (at_lo >= 0 || at_hi <= 0) {
        return lo * lo;
    }
    std::uintmax_t evaluations = 100;
    const auto [before, behind] = boost::math::tools::toms748_solve(
        margin, lo, hi, at_lo, at_hi, [](double x, double y) { return y - x <= 0x1p-50 * y; }, evaluations);
    return behind * behind;
}

std::optional<FineStep> find_step(long n, int share_bits, const Interrupted& interrupted) {
    const PrecisionScope scope(bits_to_find(n, share_bits));
    const auto place = place_of_step(n, share_bits, interrupted);
    if (!place) {
        return std::nullopt;
    }
    const Search search(n, interrupted);
    const BigInterval half(std::ldexp(1, 5 - share_bits));
    return FineStep{search.ratio(*place), search.ratio(*place - half), search.ratio(*place + half)};
}

}  // namespace dumbbell::collisions
