#include "collisions/plan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "collisions/section.hpp"
#include "number/decimal.hpp"
#include "number/parallel.hpp"
#include "number/part.hpp"

namespace dumbbell::collisions {
namespace {

constexpr long max_steps = 1'000'000;

/// x rounded down or up to a multiple of the greatest power of ten that is at most `grain`: short decimals in
/// the file.
Rational rounded(const Rational& x, double grain, bool up) {
    const Rational unit = exact(Decimal{1, static_cast<int>(std::floor(std::log10(grain)))});
    const Rational multiple = x / unit;
    Integer floor = numerator(multiple) / denominator(multiple);
    if (up && floor * denominator(multiple) != numerator(multiple)) {
        ++floor;
    }
    return Rational(floor) * unit;
}

/// The maximum at q, or one less or more: where growth sqrt q lies between whole numbers.
long about(const SectionRow& row, const Rational& q) {
    const Rational growth = parse_rational(row.growth), square = growth * growth * q;
    return 2 + sqrt(numerator(square) / denominator(square)).convert_to<long>();
}

/// The first steps that seem to lie near [lo, hi], with a neighbour on either side for the distances, and how
/// many follow them near the range, too.
std::pair<std::vector<Step>, std::size_t> steps_near(const SectionRow& row, const Rational& lo,
                                                     const Rational& hi, double gap,
                                                     const Interrupted& interrupted, Observer& observer) {
    const long first = std::max(4L, about(row, lo) - 1);
    const long last = about(row, hi) + 2;
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
            steps[i] = row.step(first + static_cast<long>(i), gap, interrupted);
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

PlannedPiece planned_as(const Piece& piece) {
    return {piece.q_lo, piece.q_hi, as_long(*piece.upper), as_long(piece.lower)};
}

std::string words_of(const PlannedPiece& planned) {
    return fmt::format("piece {} {} {} {}", to_fraction(planned.q_lo), to_fraction(planned.q_hi),
                       planned.upper, planned.lower);
}

Plan plan_staircase(const Claim& claim, const Rational& q_lo, const Interrupted& interrupted,
                    Observer& observer) {
    const Rational &q_hi = claim.range.hi, &gap = claim.gap;
    const auto width = gap.convert_to<double>();
    const auto [steps, beyond] =
        steps_near(staircase_of(claim.system), q_lo, q_hi, width, interrupted, observer);
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
