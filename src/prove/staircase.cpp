#include "prove/staircase.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "arith/error.hpp"
#include "prove/critical_guess.hpp"

namespace dumbbell {
namespace {

constexpr long max_steps = 1'000'000;

/// x rounded down or up to a multiple of the greatest power of ten that is at most `grain`: short decimals in
/// the file.
Rational rounded(double x, double grain, bool up) {
    const int exponent = static_cast<int>(std::floor(std::log10(grain)));
    const Rational unit =
        exponent >= 0
            ? Rational(boost::multiprecision::pow(Integer(10), static_cast<unsigned>(exponent)))
            : Rational(1, boost::multiprecision::pow(Integer(10), static_cast<unsigned>(-exponent)));
    const Rational multiple = exact(x) / unit;
    Integer floor = numerator(multiple) / denominator(multiple);
    if (up && floor * denominator(multiple) != numerator(multiple)) {
        ++floor;
    }
    return Rational(floor) * unit;
}

/// A step of the staircase: from n - 1 below `critical` to n above.
struct Step {
    long n;
    double critical;
    bool exact;  ///< n - 1 holds at `critical` itself, which is the critical ratio exactly
};

/// Where N* seems to step: q_c(n), guessed for the dumbbell, cot^2(pi / (2 (n - 1))) for the wedges.
Step step_to(Scene scene, long n) {
    if (scene == Scene::dumbbell) {
        return {n, guess_critical_ratio(n), false};
    }
    const double t = std::tan(std::numbers::pi / (2 * static_cast<double>(n - 1)));
    return n == 4 ? Step{n, 3, true} : Step{n, 1 / (t * t), false};
}

long guessed_value(Scene scene, double q) {
    return scene == Scene::dumbbell ? guess_maximum(q)
                                    : std::lround(std::numbers::pi / (2 * std::atan(1 / std::sqrt(q))));
}

/// The steps that seem to lie near [lo, hi], with a neighbour on either side for the distances.
std::vector<Step> steps_near(Scene scene, double lo, double hi, const std::function<bool()>& interrupted) {
    const long first = std::max(4L, guessed_value(scene, lo) - 1);
    const long last = guessed_value(scene, hi) + 2;
    if (last - first > max_steps) {
        throw InputError(fmt::format("the range holds about {} steps, more than {}: certify it in parts",
                                     last - first, max_steps));
    }
    std::vector<Step> steps(static_cast<std::size_t>(last - first + 1));
    tbb::parallel_for(std::size_t{0}, steps.size(), [&](std::size_t i) {
        if (!interrupted()) {
            steps[i] = step_to(scene, first + static_cast<long>(i));
        }
    });
    return steps;
}

/// Half the width of the gap around a step: 0.9 of what is permitted; the rounding of the ends takes less
/// than the rest.
double half_gap(const std::vector<Step>& steps, std::size_t i, double relative_gap) {
    const double q = steps[i].critical;
    const double before = i > 0 ? q - steps[i - 1].critical : q - 1;
    const double after = i + 1 < steps.size() ? steps[i + 1].critical - q : before;
    return 0.45 * std::min(relative_gap * q, std::min(before, after) / 1000);
}

}  // namespace

std::vector<PlannedPiece> plan_staircase(Scene scene, const Rational& q_lo, const Rational& q_hi,
                                         const Rational& gap, const std::function<bool()>& interrupted) {
    const auto steps = steps_near(scene, q_lo.convert_to<double>(), q_hi.convert_to<double>(), interrupted);
    if (interrupted()) {
        return {};
    }
    // An exactly known step at the left end still has to be taken, one at the right end not. A guessed one
    // may lie a few doubles from the true one, on the other side of an end of the range.
    const Rational slack = exact(0x1p-48);
    const auto is_inside = [&](const Step& s) {
        const Rational q = exact(s.critical);
        return s.exact ? q >= q_lo && q < q_hi : q * (1 + slack) > q_lo && q * (1 - slack) < q_hi;
    };
    long n = 3;  // the value at the left end
    for (const Step& s : steps) {
        n = exact(s.critical) <= q_lo && !is_inside(s) ? s.n : n;
    }

    std::vector<PlannedPiece> plan;
    Rational from = q_lo;
    if (q_lo == 1) {
        plan.push_back({q_lo, q_lo, 2, 2});
        from = std::min(q_hi, Rational(1) + std::min(gap, Rational(1, 1000)));
        plan.push_back({q_lo, from, 3, 2});
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (!is_inside(steps[i])) {
            continue;
        }
        const double q = steps[i].critical;
        const double half = half_gap(steps, i, gap.convert_to<double>());
        const Rational left =
            steps[i].exact ? exact(q) : std::clamp(rounded(q - half, half / 20, false), from, q_hi);
        const Rational right = std::clamp(rounded(q + half, half / 20, true), left, q_hi);
        if (left > from || (steps[i].exact && left == from)) {
            plan.push_back({from, left, n, n});
        }
        if (right > left) {
            plan.push_back({left, right, n + 1, n});
        }
        from = right;
        ++n;
    }
    if (from < q_hi) {
        plan.push_back({from, q_hi, n, n});
    }
    return plan;
}

}  // namespace dumbbell
