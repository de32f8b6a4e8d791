#include "adiabatic/classes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "adiabatic/drift.hpp"
#include "number/parallel.hpp"

namespace dumbbell::adiabatic {
namespace {

constexpr double right_angle = std::numbers::pi / 2;
constexpr double highest_cell = 1.57;  ///< where the cells begin, but for the first
constexpr int parts = 128;
constexpr int slopes = 40;
constexpr int contacts_per_cell = 4;
constexpr int density_bits = 9;
constexpr double greatest_sigma = 8;
constexpr double nearest_cells = 1e-4;  ///< to the vertical that cells reach: below nothing is certified

/// X of L34: the contact of the line of slope l through the point over the bridge's middle at height m.
double contact(double m, double l, double x) {
    for (int i = 0; i < 50; ++i) {
        const double step = (std::sin(x) - l * x - m - l * right_angle) / (std::cos(x) - l);
        x -= step;
        if (std::abs(step) < 1e-7) {  // what is left is its square
            break;
        }
    }
    return x;
}

struct Rates {
    double second, first, growth;
};

/// A', B and F/(w - l) of L34.
Rates rates(double x, double l, double r) {
    const double w = std::cos(x), s = std::sin(x), z = w * w, b2 = 1 / (1 + r);
    const double F = right_angle + x, f = right_angle + std::asin(b2 * s), rho = std::sqrt(z + 2 * r + r * r);
    const double over = 1 / (z + r), growth = F / (w - l), bent = f * F * s;
    const double n = bent * (z - r) * over * over;
    const double n_x = (z - r) * over * over * (w / rho * F * s + f * s + f * F * w) +
                       2 * bent * s * w * (z - 3 * r) * over * over * over;
    const double zeta = b2 * s * (2 + r) / (rho + w);
    return {(F * n_x + n * (1 + growth * s)) / ((w - l) * (w - l)),
            2 * bent * w / (w - l) * over * over + w * (F * (2 + r) / (rho * (rho + w)) - zeta) * over,
            growth};
}

/// The cells of one class, from the vertical's far side towards it.
class Densities {
  public:
    Densities(std::vector<double> ends, double least_share, std::vector<double> deltas,
              const Interrupted& interrupted)
        : ends_(std::move(ends)), least_share_(least_share), deltas_(std::move(deltas)) {
        for (std::size_t cell = 0; cell + 1 < ends_.size() && !interrupted(); ++cell) {
            density_.push_back(0);
            double need = 0;
            for (int i = 1; i <= contacts_per_cell; ++i) {
                const double u = ends_[cell] + (ends_[cell + 1] - ends_[cell]) * i / contacts_per_cell;
                for (const double delta : deltas_) {
                    need = std::max(need, needed(cell, u, delta));
                }
            }
            density_[cell] = std::max(need, cell > 0 ? 0.93 * density_[cell - 1] : 0);
        }
    }

    [[nodiscard]] const std::vector<double>& values() const { return density_; }

  private:
    /// Of this cell by the flights whose upper contact is at u, at the end of the cell or in it.
    [[nodiscard]] double needed(std::size_t cell, double u, double delta) const {
        if (u >= right_angle) {
            return 0;
        }
        const double r = delta * delta / (1 - delta * delta);
        const double steepest =
            std::min(greatest_sigma, std::sqrt(std::max(0.02, std::pow(3.4 / least_share_, 2) - 1)));
        double most = 0;
        for (int i = 0; i <= slopes; ++i) {
            const double sigma = steepest * i / slopes;
            const double k = sigma * std::sqrt(r);
            if (k > 0.98 * std::sin(u)) {
                break;
            }
            most = std::max(most, needed(cell, u, sigma, k, r));
        }
        return most;
    }

    [[nodiscard]] double needed(std::size_t cell, double u, double sigma, double k, double r) const {
        const double upper = right_angle - u;
        const double m = std::sin(upper) - k * (right_angle + upper);
        const double lower = contact(m, -k, upper);
        const double w = std::cos(lower);
        const double f = right_angle + std::asin(std::sin(lower) / (1 + r));
        if (lower < 0 || f * w * (w + k) / (w * w + r) < 0.98 * least_share_ * std::sqrt(1 + sigma * sigma)) {
            return 0;
        }
        double drift = 0, own = 0, before = 0;
        RootTrend trend;
        trend.add(lower);
        for (int i = 0; i < parts; ++i) {
            const double from = drift_part_end(i, parts), until = drift_part_end(i + 1, parts);
            const double lambda = (from + until) / 2;
            const double x = contact(m, lambda * k, trend.next());
            trend.add(x);
            const Rates at = rates(x, lambda * k, r);
            drift += (until - from) * (at.second * sigma * sigma * (1 - lambda * lambda) / 2 + at.first);
            const std::size_t in = cell_of(right_angle - x, cell);
            (in == cell ? own : before) += (until - from) * at.growth * (in == cell ? 1 : density_[in]);
        }
        const double root = std::sqrt(1 + sigma * sigma);
        return own > 0 ? (drift - root * before) / (root * own) : 0;
    }

    [[nodiscard]] std::size_t cell_of(double u, std::size_t last) const {
        const auto end = std::lower_bound(ends_.begin() + 1, ends_.end(), u, std::greater<>());
        return std::min(last, static_cast<std::size_t>(end - ends_.begin() - 1));
    }

    std::vector<double> ends_;  ///< in u, decreasing
    double least_share_;
    std::vector<double> deltas_;
    std::vector<double> density_;
};

double rounded(double x, bool up) {
    if (x == 0) {
        return 0;
    }
    const double scale = std::ldexp(1.0, density_bits - 1 - std::ilogb(x));
    return (up ? std::ceil(x * scale) : std::floor(x * scale)) / scale;
}

struct Range {
    double least, greatest;
};

/// S_0/sqrt(E) over the hypotheses, about.
Range shares(const Hypotheses& of, double delta) {
    const double b2 = 1 - delta * delta;
    const auto share = [&](double u, double s) {
        const double x = right_angle - u, w = std::cos(x), r = delta * delta / b2;
        return (right_angle + std::asin(b2 * std::sin(x))) * w * (w + delta * s / b2) / (w * w + r) /
               std::sqrt(1 + s * s / b2);
    };
    const double margin = of.margin.convert_to<double>();
    if (of.claim == Claim::run) {
        const double highest = std::min(1.0, of.heights.second.convert_to<double>() / b2);
        const double lowest = std::min(1.0, of.heights.first.convert_to<double>() / b2);
        return {share(std::max(margin, std::acos(lowest)), 1),
                share(std::max(margin, std::acos(highest)), 1)};
    }
    const double farthest =
        std::sqrt(4 * std::numbers::pi * delta);  // beyond it a collision is not the first
    return {share(std::min(1.2, farthest), 1), share(margin * std::sqrt(delta), 1)};
}

}  // namespace

std::vector<Class> guess_classes(const Hypotheses& of, int jobs, const Interrupted& interrupted) {
    const double longest = of.delta.second.convert_to<double>();
    const double shortest = std::max(of.delta.first.convert_to<double>(), longest / 256);
    std::vector<double> deltas{longest};
    for (int i = 1; i <= 3 && shortest < longest; ++i) {
        deltas.push_back(longest * std::pow(shortest / longest, i / 3.0));
    }
    const bool run = of.claim == Claim::run;
    const double margin =
        std::max(nearest_cells, of.margin.convert_to<double>() * (run ? 1 : std::sqrt(shortest)));
    const auto [least, greatest] = shares(of, longest);

    std::vector<double> ends{11.0 / 7};
    const int cells = std::max(16, static_cast<int>(24 * std::log(highest_cell / margin)));
    for (int i = 0; i <= cells; ++i) {
        const double u =
            highest_cell * std::pow(margin / highest_cell * (1 - 1.0 / 64), static_cast<double>(i) / cells);
        ends.push_back(rounded(u, false));
    }
    const double floor = 0.785;  // above 2 pi/sqrt(65)
    const double low = std::max(floor, least * (run ? std::max(0.5, 0.9 - 6 * longest) : 0.6));
    const double high = greatest * 0.98;
    constexpr std::size_t number = 6;
    std::vector<Class> classes(number);
    run_with_threads(jobs, [&] {
        in_parallel(number, [&](std::size_t i) {
            const double share = low + (high - low) * static_cast<double>(i) / (number - 1);
            const Densities densities(ends, share, deltas, interrupted);
            classes[i].least_share = exact(rounded(share, false));
            for (std::size_t j = 0; j < densities.values().size(); ++j) {
                classes[i].cells.push_back({exact(ends[j + 1]), exact(rounded(densities.values()[j], true))});
            }
        });
    });
    if (interrupted()) {
        return {};
    }
    const auto same = [](const Class& a, const Class& b) { return a.least_share == b.least_share; };
    classes.erase(std::unique(classes.begin(), classes.end(), same), classes.end());
    return classes;
}

Class with_slack(Class one, double slack) {
    for (auto& cell : one.cells) {
        cell.v = exact(rounded(cell.v.convert_to<double>() * slack, true));
    }
    return one;
}

}  // namespace dumbbell::adiabatic
