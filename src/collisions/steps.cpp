#include "collisions/steps.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "collisions/critical.hpp"
#include "collisions/critical_guess.hpp"
#include "collisions/critical_long.hpp"
#include "flight/growth_constant.hpp"
#include "number/parallel.hpp"

namespace dumbbell::collisions {
namespace {

constexpr long max_steps = 1'000'000;

/// x rounded down or up to a multiple of the greatest power of ten that is at most `grain`: short decimals in
/// the file.
Rational rounded(const Rational& x, double grain, bool up) {
    const int exponent = static_cast<int>(std::floor(std::log10(grain)));
    const Rational unit = exponent >= 0 ? Rational(pow(Integer(10), static_cast<unsigned>(exponent)))
                                        : Rational(1, pow(Integer(10), static_cast<unsigned>(-exponent)));
    const Rational multiple = x / unit;
    Integer floor = numerator(multiple) / denominator(multiple);
    if (up && floor * denominator(multiple) != numerator(multiple)) {
        ++floor;
    }
    return Rational(floor) * unit;
}

/// A step of the staircase: from n - 1 below `critical` to n above.
struct Step {
    long n = 0;
    Rational critical = 0;
    Rational slack = 0;  ///< the true step may be so far from `critical`, relatively
    bool exact = false;  ///< n - 1 holds at `critical` itself, which is the critical ratio exactly
};

/// Gaps at least this wide are placed with doubles: a step is off by up to 2^-48, which must be a small part
/// of the gap.
constexpr double narrow = 1e-13;

/// From this number of collisions on the steps are placed by macro steps. Flight by flight the four steps of
/// 1e12:1.00001e12 took 43 s; so all of `certify` takes 1.2 s.
constexpr long least_long = 100'000;

/// q_c(n) to a small part of the gap, which is at most a thousandth of the distance to the next step.
Step long_step(long n, double gap, const Interrupted& interrupted) {
    // Relative distances are 2/n times those between the steps.
    const double share = std::min(1e-3, gap * static_cast<double>(n) / 2);
    const int share_bits = std::clamp(12 - static_cast<int>(std::log2(share)), 24, 2000);
    const auto found = guess_long_critical_ratio(n, share_bits, interrupted);
    return found ? Step{n, *found, Rational(Integer(1), (Integer(1) << (share_bits - 6)) * n), false}
                 : Step{n, 0, 0, false};
}

/// q_c(n) to some digits beyond the gap's width. Were it wrong, pieces would stay open.
Step narrow_step(long n, double gap, const Interrupted& interrupted) {
    const int digits = 8 - static_cast<int>(std::log10(gap));
    const auto found = enclose_critical_ratio(n, {.digits = digits, .interrupted = interrupted});
    return found ? Step{n, found->q_lo, (found->q_hi - found->q_lo) / found->q_lo, false} : Step{};
}

/// cot^2(pi / (2 (n - 1))), where the wedges step.
Step wedge_step(long n, double gap) {
    if (n == 4) {
        return {n, 3, 0, true};
    }
    const PrecisionScope scope(64 + static_cast<int>(-3.33 * std::log10(gap)));
    const auto at = sin_cos(half_pi<BigInterval>() / BigInterval(static_cast<double>(n - 1)));
    const BigInterval q = sqr(at.cos / at.sin);
    return {n, exact_lo(q), (exact_hi(q) - exact_lo(q)) / exact_lo(q), false};
}

/// Where N* seems to step.
Step step_to(Scene scene, long n, double gap, const Interrupted& interrupted) {
    if (scene != Scene::dumbbell) {
        return wedge_step(n, gap);
    }
    if (n >= least_long) {
        return long_step(n, gap, interrupted);
    }
    return gap < narrow ? narrow_step(n, gap, interrupted)
                        : Step{n, exact(guess_critical_ratio(n, interrupted)), exact(0x1p-48), false};
}

/// 2 + C sqrt q, which is a little more than the maximum.
long asymptotic_value(const Rational& q) {
    const PrecisionScope scope(128);
    const BigInterval value = flight::growth_constant() * sqrt(enclose<BigInterval>(q));
    const Rational most = exact_hi(value);
    return 2 + (numerator(most) / denominator(most)).convert_to<long>();
}

long guessed_value(Scene scene, const Rational& ratio, const Interrupted& interrupted) {
    const auto q = ratio.convert_to<double>();
    // Where both ways are open.
    constexpr double far = 2e10;
    if (scene == Scene::dumbbell && q > far) {
        return asymptotic_value(ratio);
    }
    return scene == Scene::dumbbell ? guess_maximum(q, interrupted)
                                    : std::lround(std::numbers::pi / (2 * std::atan(1 / std::sqrt(q))));
}

struct NearSteps {
    std::vector<Step> steps;
    std::size_t beyond = 0;  ///< that follow them, near the range, too
};

/// The first steps that seem to lie near [lo, hi], with a neighbour on either side for the distances.
NearSteps steps_near(Scene scene, const Rational& lo, const Rational& hi, double gap,
                     const Interrupted& interrupted, Observer& observer) {
    const long first = std::max(4L, guessed_value(scene, lo, interrupted) - 1);
    const long last = guessed_value(scene, hi, interrupted) + 2;
    if (interrupted()) {
        return {};
    }
    if (last - first > max_steps) {
        throw InputError(
            fmt::format("the range holds about {} steps, more than {}: certify it in parts "
                        "(--part K/N)",
                        last - first, max_steps));
    }
    const auto all = static_cast<std::size_t>(last - first + 1);
    std::vector<Step> steps(std::min(all, most_steps_at_once));
    std::atomic<std::size_t> done = 0;
    in_parallel(steps.size(), [&](std::size_t i) {
        if (!interrupted()) {
            steps[i] = step_to(scene, first + static_cast<long>(i), gap, interrupted);
            observer.update(++done, steps.size(), std::nullopt);
        }
    });
    return {std::move(steps), all - std::min(all, most_steps_at_once)};
}

/// Half the width of the gap around a step: 0.9 of what is permitted; the rounding of the ends takes less
/// than the rest.
double half_gap(const std::vector<Step>& steps, std::size_t i, double relative_gap) {
    const Rational& at = steps[i].critical;
    const auto q = at.convert_to<double>();
    const double before = i > 0 ? Rational(at - steps[i - 1].critical).convert_to<double>() : q - 1;
    const double after =
        i + 1 < steps.size() ? Rational(steps[i + 1].critical - at).convert_to<double>() : before;
    return 0.45 * std::min(relative_gap * q, std::min(before, after) / 1000);
}

}  // namespace

PlannedPiece planned_as(const Piece& piece) { return {piece.q_lo, piece.q_hi, *piece.upper, piece.lower}; }

std::string words_of(const PlannedPiece& planned) {
    return fmt::format("piece {} {} {} {}", to_fraction(planned.q_lo), to_fraction(planned.q_hi),
                       planned.upper, planned.lower);
}

Plan plan_staircase(Scene scene, const Rational& q_lo, const Rational& q_hi, const Rational& gap,
                    const Interrupted& interrupted, Observer& observer) {
    const auto width = gap.convert_to<double>();
    const auto [steps, beyond] = steps_near(scene, q_lo, q_hi, width, interrupted, observer);
    if (interrupted()) {
        return {};
    }
    // An exactly known step at the left end still has to be taken, one at the right end not. A guessed one
    // may lie on the other side of an end of the range than the true one.
    const auto is_inside = [&](const Step& s) {
        const Rational &q = s.critical, &slack = s.slack;
        return s.exact ? q >= q_lo && q < q_hi : q * (1 + slack) > q_lo && q * (1 - slack) < q_hi;
    };
    long n = 3;  // the value at the left end
    for (const Step& s : steps) {
        n = s.critical <= q_lo && !is_inside(s) ? s.n : n;
    }

    Plan plan{{}, beyond};
    Rational from = q_lo;
    if (q_lo == 1) {
        plan.pieces.push_back({q_lo, q_lo, 2, 2});
        from = std::min(q_hi, Rational(1) + std::min(gap, Rational(1, 1000)));
        plan.pieces.push_back({q_lo, from, 3, 2});
    }
    const std::size_t placed = beyond == 0 ? steps.size() : steps.size() - 1;  // with both neighbours
    for (std::size_t i = 0; i < placed; ++i) {
        if (!is_inside(steps[i])) {
            continue;
        }
        const Rational& q = steps[i].critical;
        const double half = half_gap(steps, i, width);
        const Rational left =
            steps[i].exact ? q : std::clamp(rounded(q - exact(half), half / 20, false), from, q_hi);
        const Rational right = std::clamp(rounded(q + exact(half), half / 20, true), left, q_hi);
        if (left > from || (steps[i].exact && left == from)) {
            plan.pieces.push_back({from, left, n, n});
        }
        if (right > left) {
            plan.pieces.push_back({left, right, n + 1, n});
        }
        from = right;
        ++n;
    }
    if (beyond == 0 && from < q_hi) {
        plan.pieces.push_back({from, q_hi, n, n});
    }
    return plan;
}

}  // namespace dumbbell::collisions
