#include "adiabatic/search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "flight/contact_guess.hpp"
#include "number/parallel.hpp"

namespace dumbbell::adiabatic {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double inside =
    1e-9;  ///< relative distance from the ends of the hypotheses, so that enclosures fit in
constexpr double least_share = 1.0 / 16;  ///< of the greatest delta, where the least is 0

/// What the search needs of the hypotheses at one delta.
struct Domain {
    double delta, r, beta2, margin, nearest, farthest;

    Domain(const Hypotheses& of, double share) {
        const double lo = of.delta.first.convert_to<double>(), hi = of.delta.second.convert_to<double>();
        delta = lo + (hi - lo) * share;
        beta2 = 1 - delta * delta;
        r = delta * delta / beta2;
        margin = of.margin.convert_to<double>() * (1 + inside);
        nearest = margin;
        farthest = pi / 2;
        if (of.claim == Claim::bounce) {
            nearest = margin *= std::pow(delta, of.exponent / 16.0);
        } else if (of.claim != Claim::run) {
            nearest = margin *= std::sqrt(delta);
            farthest = std::min(
                pi / 2, 1.2 * std::sqrt(4 * pi * delta));  // farther away it is not the first collision
        }
        if (of.claim == Claim::bounce || of.claim == Claim::run) {
            const double y1 = of.heights.first.convert_to<double>(),
                         y2 = of.heights.second.convert_to<double>();
            nearest = std::max(nearest, std::acos(std::min(1.0, y2 / beta2 * (1 - inside))));
            farthest = std::min(farthest, std::acos(std::min(1.0, y1 / beta2 * (1 + inside) + inside)));
        }
    }
};

struct Step {
    double turn;  ///< D/(w^2 + r), the factor of |phidot|
    double slope;
    bool hits;
    double x;
};

Step step(double x, double kappa, double r) {
    const double w = std::cos(x);
    const double d = w * w - 2 * kappa * w - r;
    const double slope = (kappa * w * w + 2 * r * w - r * kappa) / d;
    const double c = std::sin(x) + slope * (x + pi);
    if (!(d > 0) || !(slope < 1) || !(c > r) || !(std::sin(x) > r)) {
        return {d / (w * w + r), slope, false, x};
    }
    const auto guess = flight::guess_contact(Interval(c), Interval(slope));
    return {d / (w * w + r), slope, guess.hits, approximate(guess.z)};
}

double bounce_error(const Search& search, const Domain& at, double u, double s) {
    const double x = pi / 2 - u, kappa = -at.delta * s / at.beta2, w = std::sin(u),
                 k = search.of.exponent / 16.0;
    const Step next = step(x, kappa, at.r);
    if (!next.hits || !(next.turn > 0)) {
        return 0;
    }
    const double rho = std::sqrt(w * w + 2 * at.r + at.r * at.r);
    if (!search.height_error) {
        return std::abs(next.turn - 1 - 2 * at.delta * s / rho) / std::pow(at.delta, 2 - 2 * k);
    }
    const double change = at.beta2 * (std::sin(next.x) - std::sin(x));
    const double f = pi / 2 + std::asin(at.beta2 * std::sin(x));
    return std::abs(change + 2 * f * at.delta * s) / (2 * std::pow(at.delta, 2 - k));
}

bool is_first(double x, double kappa) {
    const double z = std::acos(-kappa);
    return std::sin(z) < std::sin(x) - kappa * (x + pi + z);
}

/// Follows the orbit; the greatest error of a run, or that of a whole scattering.
void follow(const Search& search, const Domain& at, Sample& sample) {
    double x = pi / 2 - sample.u, kappa = -at.delta * sample.s / at.beta2;
    const bool run = search.of.claim == Claim::run;
    if (!run && !is_first(x, kappa)) {
        return;
    }
    const double f0 = pi / 2 + std::asin(at.beta2 * std::sin(x));
    const double unit = run ? at.delta : std::sqrt(at.delta);
    double speed = 1;
    for (long n = 0; n <= search.most_collisions; ++n) {
        const double f = pi / 2 + std::asin(at.beta2 * std::sin(x));
        const Step next = step(x, kappa, at.r);
        if (run) {
            if (pi / 2 - x < at.margin) {
                return;
            }
            const double error = std::abs(speed * f - f0) / unit;
            if (error > sample.error) {
                sample.error = error;
                sample.n = n;
            }
        }
        if (ends_early(n, search.interrupted)) {
            return;
        }
        if (!next.hits) {
            const bool ends = next.turn < 0 || next.slope >= 0;
            if (!run && ends && pi / 2 - x >= at.margin) {
                sample.error = std::abs(std::abs(speed * next.turn) * f - f0) / unit;
                sample.n = n;
            }
            return;
        }
        speed *= next.turn;
        kappa = next.slope;
        x = next.x;
    }
}

struct Grid {
    int u, s, share;
};

/// How densely initial conditions are looked at.
struct Effort {
    Grid coarse{192, 12, 4};
    double kept = 8;  ///< the best ones, which are refined
    double zooms = 16;
};

/// The less densely the longer the orbits are: about 1/delta collisions.
Effort effort_for(const Search& search) {
    const bool single = search.of.has_one_delta();
    Effort effort;
    effort.coarse.share = single ? 0 : effort.coarse.share;
    if (search.of.claim == Claim::bounce) {
        effort.coarse.u = 64;
        return effort;
    }
    const double orbits = single ? 8e3 : 3e4;
    const double lo = search.of.delta.first.convert_to<double>();
    const double least = lo > 0 ? lo : search.of.delta.second.convert_to<double>() * least_share;
    const double length = std::min(static_cast<double>(search.most_collisions), 1 / least);
    const double thinner = std::clamp(std::sqrt(most_collisions_in_all / (orbits * length)), 1.0 / 6, 1.0);
    effort.coarse.u = static_cast<int>(effort.coarse.u * thinner);
    effort.coarse.s = static_cast<int>(effort.coarse.s * thinner);
    effort.kept = std::ceil(effort.kept * thinner);
    effort.zooms = std::ceil(effort.zooms * thinner);
    return effort;
}

class GridSearch {
  public:
    explicit GridSearch(const Search& search) : search_(search), effort_(effort_for(search)) {}

    std::vector<Sample> found() {
        fill(effort_.coarse, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5});
        std::vector<Found> best = std::move(found_);
        std::ranges::stable_sort(best, std::greater<>(), error);
        best.resize(std::min(best.size(), static_cast<std::size_t>(effort_.kept)));
        std::vector<Sample> samples;
        for (const Found& one : best) {
            samples.push_back(refined(one));
        }
        std::ranges::stable_sort(samples, std::greater<>(), &Sample::error);
        return samples;
    }

  private:
    struct Point {
        double a, s, share;  ///< a: the share of the way through the angles
    };
    struct Found {
        Point at;
        Sample sample;
    };
    static double error(const Found& one) { return one.sample.error; }

    [[nodiscard]] Sample at(const Point& point) const {
        const Domain domain(search_.of, point.share);
        const double u = domain.nearest + (domain.farthest - domain.nearest) * point.a;
        return simulated(search_, u, point.s, point.share);
    }

    /// All points of a grid around `centre`; ends of the unit cube count.
    void fill(const Grid& grid, const Point& centre, const Point& half) {
        found_.clear();
        const auto place = [](double middle, double span, int i, int n, double least = 0) {
            return n == 0 ? middle : std::clamp(middle + span * (2.0 * i / n - 1), least, 1.0);
        };
        // Runs have the more collisions the smaller delta is.
        const double from = search_.of.delta.first == 0 ? least_share : 0;
        const bool single = search_.of.has_one_delta();
        for (int i = 0; i <= grid.u; ++i) {
            for (int j = 0; j <= grid.s; ++j) {
                for (int k = 0; k <= grid.share; ++k) {
                    found_.push_back({{place(centre.a, half.a, i, grid.u), place(centre.s, half.s, j, grid.s),
                                       single ? 0 : place(centre.share, half.share, k, grid.share, from)},
                                      {}});
                }
            }
        }
        run_with_threads(search_.jobs, [&] {
            in_parallel(found_.size(), [&](std::size_t i) {
                found_[i].sample = search_.interrupted() ? Sample{} : at(found_[i].at);
            });
        });
    }

    /// The best near it.
    Sample refined(Found best) {
        const Grid& coarse = effort_.coarse;
        Point half{1.0 / coarse.u, 1.0 / coarse.s, coarse.share > 0 ? 1.0 / coarse.share : 0};
        for (int i = 0; i < effort_.zooms; ++i) {
            fill({8, 4, coarse.share > 0 ? 2 : 0}, best.at, half);
            const Found& top = *std::ranges::max_element(found_, {}, error);
            if (top.sample.error > best.sample.error) {
                best = top;
            }
            half = {half.a / 2, half.s / 2, half.share / 2};
        }
        return best.sample;
    }

    const Search& search_;
    Effort effort_;
    std::vector<Found> found_;  ///< on the grid that was filled last
};

}  // namespace

Sample simulated(const Search& search, double u, double s, double share) {
    Sample sample{u, s, share, search.of.claim == Claim::bounce ? 1 : 0, 0};
    const Domain at(search.of, share);
    if (!(u >= at.nearest) || !(u <= at.farthest) || !(at.delta > 0)) {
        return sample;
    }
    if (search.of.claim == Claim::bounce) {
        sample.error = bounce_error(search, at, u, s);
    } else {
        follow(search, at, sample);
    }
    return sample;
}

std::vector<Sample> search_errors(const Search& search) { return GridSearch(search).found(); }

}  // namespace dumbbell::adiabatic
