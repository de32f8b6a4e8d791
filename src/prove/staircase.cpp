#include "prove/staircase.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
};

/// The steps that seem to lie strictly inside (lo, hi), with a neighbour on either side for the distances.
std::vector<Step> steps_between(double lo, double hi) {
    const long first = std::max(4L, guess_maximum(lo) - 1);
    const long last = guess_maximum(hi) + 2;
    if (last - first > max_steps) {
        throw InputError(fmt::format("the range holds about {} steps, more than {}: certify it in parts",
                                     last - first, max_steps));
    }
    std::vector<Step> steps;
    for (long n = first; n <= last; ++n) {
        steps.push_back({n, guess_critical_ratio(n)});
    }
    return steps;
}

}  // namespace

std::vector<PlannedPiece> plan_staircase(const Rational& q_lo, const Rational& q_hi, const Rational& gap) {
    const double relative_gap = gap.convert_to<double>();
    std::vector<PlannedPiece> plan;
    Rational from = q_lo;
    const auto steps = steps_between(q_lo.convert_to<double>(), q_hi.convert_to<double>());
    const auto is_inside = [&](const Step& s) {
        return exact(s.critical) > q_lo && exact(s.critical) < q_hi;
    };
    const auto inside = std::find_if(steps.begin(), steps.end(), is_inside);
    // The value at the left end: one less than the first step inside, or what holds between the two that
    // enclose the range.
    long n = inside != steps.end() ? inside->n - 1 : 3;
    if (inside == steps.end()) {
        for (const Step& s : steps) {
            n = exact(s.critical) <= q_lo ? s.n : n;
        }
    }

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
        const double before = i > 0 ? q - steps[i - 1].critical : q - 1;
        const double after = i + 1 < steps.size() ? steps[i + 1].critical - q : before;
        // 0.9 of the permitted width, and the rounding of the ends takes less than the rest.
        const double half = 0.45 * std::min(relative_gap * q, std::min(before, after) / 1000);
        const Rational left = std::max(from, rounded(q - half, half / 20, false));
        const Rational right = std::min(q_hi, rounded(q + half, half / 20, true));
        if (left > from) {
            plan.push_back({from, left, n, n});
        }
        plan.push_back({left, right, n + 1, n});
        from = right;
        ++n;
    }
    if (from < q_hi) {
        plan.push_back({from, q_hi, n, n});
    }
    return plan;
}

}  // namespace dumbbell
