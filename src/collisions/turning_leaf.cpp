#include "collisions/leaf_judges.hpp"
#include "flight/batch/count.hpp"
#include "flight/bridge_clearance.hpp"
#include "flight/chart.hpp"
#include "flight/count.hpp"

namespace dumbbell::collisions {

using flight::Ray;

namespace {

/// A box in enclosures. Positions are clipped to the section, e <= pi/2.
template <class I>
struct Bounds {
    I e_lo, slope_lo, slope_hi;
    flight::Position<I> low, high;
    flight::RatioRange<I> range;
};

template <class I>
Bounds<I> bounds_of(const Box& box) {
    const I e_lo = box.e_lo.enclosure<I>();
    return {e_lo,
            box.slope_lo.enclosure<I>(),
            box.slope_hi.enclosure<I>(),
            flight::position(e_lo),
            flight::position(box.e_hi.enclosure<I>()),
            {box.q_hi.inverse<I>(), box.q_lo.inverse<I>()}};
}

/// Beyond the peak, or X not in play (L3) on the whole box. X has slope >= r_lo * slope_lo in both charts.
template <class I>
bool beyond_section(const Bounds<I>& b) {
    return certainly_less(half_pi<I>(), b.e_lo) || certainly_at_most(I(1), b.range.r_lo * b.slope_lo);
}

/// What a box comes down to: the reason that closes it without a count, or the rays whose counts may close it
/// (without `reversed` if sigma X has no collision); neither: nothing is certain.
template <class I>
struct Case {
    std::optional<Leaf> leaf;
    std::optional<Ray<I>> out;
    std::optional<Ray<I>> reversed;
};

/// L8: X is lowest at the far end of the position, sigma X at the near end, both at the least steepness.
template <class I>
Case<I> bridge_case(const Bounds<I>& b) {
    if (beyond_section(b)) {
        return {Leaf{Reason::outside}, std::nullopt, std::nullopt};
    }
    const auto out = bridge_outgoing(b.high, b.slope_lo);
    const auto reversed = bridge_reversed(b.low, b.slope_lo, b.range.r_hi);
    return {std::nullopt, lowest_over(out, b.range), lowest_over(reversed, b.range)};
}

/// L9: sigma X descends on the whole box, so the collision is not turning there.
template <class I>
bool certainly_not_turning(const Bounds<I>& b) {
    const I& w = b.high.cos_e;
    return certainly_less(I(2) * w, b.slope_lo * (sqr(w) - b.range.r_hi));
}

/// L9: sigma X certainly flies left and crosses the bridge on the whole box.
template <class I>
bool reversed_meets_bridge(const Bounds<I>& b) {
    const I& w = b.high.cos_e;
    const I least_denominator = sqr(w) + I(2) * b.range.r_lo * b.slope_lo * w - b.range.r_hi;
    if (!certainly_positive(least_denominator)) {
        return false;
    }
    const auto steepest = flight::reversed_at_light_wall(b.slope_lo, w, b.range.r_hi);
    const I mu = max(I(0), steepest.numerator / steepest.denominator);
    return certainly_meets_bridge(b.high, mu, b.range);
}

template <class I>
Case<I> light_case(const Bounds<I>& b) {
    if (beyond_section(b) || certainly_not_turning(b)) {
        return {Leaf{Reason::outside}, std::nullopt, std::nullopt};
    }
    if (certainly_meets_bridge(b.high, b.slope_hi, b.range)) {
        return {Leaf{Reason::meets}, std::nullopt, std::nullopt};
    }
    if (reversed_meets_bridge(b)) {
        return {Leaf{Reason::meets_reversed}, std::nullopt, std::nullopt};
    }
    const I& w = b.low.cos_e;
    const I& r = b.range.r_lo;
    const Ray<I> out = light_outgoing(b.low, r * b.slope_lo, r);
    const I greatest_denominator = sqr(w) + I(2) * b.range.r_hi * b.slope_hi * w - r;
    if (certainly_at_most(greatest_denominator, I(0))) {
        return {std::nullopt, out, std::nullopt};  // sigma X leaves the cell (L1)
    }
    const auto lowest = flight::reversed_at_light_wall(b.slope_hi, w, r);
    if (!certainly_positive(lowest.denominator)) {
        return {};
    }
    const I mu = max(I(0), lowest.numerator / lowest.denominator);
    return {std::nullopt, out, light_outgoing(b.low, r * mu, r)};
}

template <class I>
Case<I> case_of(Chart chart, const Box& box) {
    const Bounds<I> bounds = bounds_of<I>(box);
    return chart == Chart::bridge ? bridge_case(bounds) : light_case(bounds);
}

/// The lower, flatter corner of a box of rays, as a question to the batch kernel.
flight::batch::Query query(const Ray<Interval>& ray, long cap) {
    return {{ray.c.lo(), ray.kappa.lo(), ray.r.lo()}, cap};
}

/// Batched counts for some of the boxes.
class Questions {
  public:
    void ask(std::size_t box, const Ray<Interval>& ray, long cap) {
        boxes_.push_back(box);
        queries_.push_back(query(ray, cap));
    }
    /// Calls use(box, answer, cap) for each question.
    template <class Use>
    void answer(const Interrupted& interrupted, Use use) {
        std::vector<flight::batch::Answer> answers(queries_.size());
        flight::batch::count_at_most(queries_, answers, flight::batch::chosen_backend(), interrupted);
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            use(boxes_[i], answers[i], queries_[i].cap);
        }
    }

  private:
    std::vector<std::size_t> boxes_;
    std::vector<flight::batch::Query> queries_;
};

}  // namespace

template <class I>
std::optional<Leaf> judge_turning(Chart chart, const Box& box, const Count& upper,
                                  const Interrupted& interrupted) {
    const Case<I> found = case_of<I>(chart, box);
    if (found.leaf || !found.out) {
        return found.leaf;
    }
    using N = flight::CountOf<I>;
    const N most = flight::count_in<I>(upper - 1);
    const N forward = count_at_most(*found.out, most, interrupted);
    if (forward > most) {
        return std::nullopt;
    }
    const N room = most - forward;
    const N backward = found.reversed ? count_at_most(*found.reversed, room, interrupted) : N(0);
    return backward > room ? std::nullopt : std::optional(Leaf{Reason::count, forward, backward});
}

template std::optional<Leaf> judge_turning<Interval>(Chart, const Box&, const Count&, const Interrupted&);
template std::optional<Leaf> judge_turning<BigInterval>(Chart, const Box&, const Count&, const Interrupted&);

std::vector<BoxJudgement> judge_turning_together(Chart chart, std::span<const Box> boxes, long upper,
                                                 std::span<std::optional<Leaf>> results,
                                                 const Interrupted& interrupted) {
    std::vector<BoxJudgement> verdicts(boxes.size(), BoxJudgement::unsure);
    std::vector<Case<Interval>> cases(boxes.size());
    Questions forward;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        cases[i] = case_of<Interval>(chart, boxes[i]);
        if (cases[i].leaf) {
            results[i] = cases[i].leaf;
            verdicts[i] = BoxJudgement::closed;
        } else if (cases[i].out) {
            forward.ask(i, *cases[i].out, upper - 1);
        }
    }
    const auto close = [&](std::size_t i, const Leaf& leaf) {
        results[i] = leaf;
        verdicts[i] = BoxJudgement::closed;
    };
    std::vector<bool> settled(boxes.size());
    Questions backward;
    forward.answer(interrupted, [&](std::size_t i, const flight::batch::Answer& answer, long cap) {
        settled[i] = flight::batch::settled(answer);
        if (answer.count > cap) {
            verdicts[i] = settled[i] ? BoxJudgement::open : BoxJudgement::unsure;
        } else if (cases[i].reversed) {
            results[i] = Leaf{Reason::count, answer.count, 0};
            backward.ask(i, *cases[i].reversed, cap - answer.count);
        } else {
            close(i, {Reason::count, answer.count, 0});
        }
    });
    backward.answer(interrupted, [&](std::size_t i, const flight::batch::Answer& answer, long cap) {
        if (answer.count > cap) {
            results[i].reset();
            verdicts[i] =
                settled[i] && flight::batch::settled(answer) ? BoxJudgement::open : BoxJudgement::unsure;
        } else {
            close(i, {Reason::count, results[i]->forward, answer.count});
        }
    });
    return verdicts;
}

}  // namespace dumbbell::collisions
