#pragma once

#include <cstddef>
#include <type_traits>

#include "base/interrupted.hpp"
#include "flight/contact.hpp"
#include "flight/macro/steps.hpp"
#include "flight/ray.hpp"
#include "flight/reflection.hpp"
#include "number/count.hpp"
#include "number/parallel.hpp"

/// Certified bounds of G, the number of later collisions of a set of rays with the light walls (lemmas L4,
/// L5).
namespace dumbbell::flight {

/// What the collisions of rays in I are counted with: double cannot tell greater numbers apart.
template <class I>
using CountOf = std::conditional_t<std::is_same_v<I, BigInterval>, Count, long>;

/// work(i) for each i < number, a count or a proof by counts: in multiple precision in_parallel, in double
/// one after the other, for they are soon done.
template <class I, class Work>
void each_count(std::size_t number, const Work& work) {
    constexpr bool is_long = std::is_same_v<I, BigInterval>;
    in_parallel(number, is_long ? 1 : number, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i != end; ++i) {
            work(i);
        }
    });
}

namespace detail {

/// Whether a count that has done so many flights is to end. In multiple precision each of them asks: with
/// thousands of bits it takes milliseconds.
template <class I>
[[nodiscard]] bool count_ends(const CountOf<I>& flights, const Interrupted& interrupted) {
    return std::is_same_v<I, BigInterval> ? interrupted() : ends_early(flights, interrupted);
}

/// Follows a bound of rays after a collision by macro steps, and counts them.
template <class I>
class MacroSteps {
  public:
    using N = CountOf<I>;

    MacroSteps(macro::BoundSide side, const I& r, const N& cap, const Interrupted& interrupted)
        : side_(side),
          r_(r),
          attempts_(cap >= macro::least_worth_a_macro_step<I>() && macro::may_have_macro_steps(r) ? 4 : 0),
          cap_(cap),
          interrupted_(interrupted) {}

    /// `state`, and c of the flight that leaves it, after count + 1 collisions. Whether there was a step.
    bool follow(macro::WallState<I>& state, I& c, N& count) {
        if (attempts_ == 0) {
            return false;
        }
        const N before = count;
        for (N steps = 1; steps > 0; count += steps) {
            steps = interrupted_() ? N(0) : N(macro_step(side_, r_, state, cap_ - count - 1, interrupted_));
            attempts_ -= steps == 0 ? 1 : 0;
        }
        if (count != before) {
            last_ = count;
            c = sin_cos(state.x).sin + state.kappa * (state.x + pi<I>());
        }
        return count != before;
    }
    /// Far from the last macro step: at this precision none is found, and one after the other they are too
    /// many.
    [[nodiscard]] bool hopeless(const N& count) const { return count - last_ > 4'000'000; }

  private:
    macro::BoundSide side_;
    const I& r_;
    int attempts_;  ///< that may fail: first where the orbit has hardly begun, at last where it ends
    N cap_;
    const Interrupted& interrupted_;
    N last_ = 0;
};

}  // namespace detail

/// Ignores the rays on the way.
inline constexpr auto unseen = [](const auto&, const auto&, const auto&) {};

/// An upper bound of G over all rays that lie at or above `lowest` in c, kappa and r: the lowest, flattest
/// ray is followed with lower bounds, and a contact counts unless a strict miss is certain. Stops at `cap` +
/// 1 ("more than cap"), also if interrupted. `see(n, c, kappa)` gets the bounds of the flight after n
/// collisions, but for those that macro steps pass over. Precondition: lowest.c >= 0, lowest.kappa >=
/// -lowest.r. Flattened, as the other one: intervals stay in registers.
template <class I, class See = decltype(unseen)>
[[gnu::flatten]] CountOf<I> count_at_most(const Ray<I>& lowest, const CountOf<I>& cap,
                                          const Interrupted& interrupted = never, const See& see = unseen) {
    const I r = low_end(lowest.r);
    I c = low_end(lowest.c);
    I kappa = low_end(lowest.kappa);
    detail::MacroSteps<I> macro_steps(macro::BoundSide::lower, r, cap, interrupted);
    ContactTrend<I> trend;
    for (CountOf<I> count = 0; count <= cap; ++count) {
        see(count, c, kappa);
        if (certainly_at_most(I(1), kappa)) {
            return count;  // L3
        }
        const auto contact = lowest_contact(c, kappa, trend.next());
        if (!contact) {
            return count;
        }
        const auto out = reflect_at_light_wall(kappa, contact->cos_x, r);
        const I denominator = high_end(out.denominator);
        if (certainly_at_most(denominator, I(0))) {
            return count + 1;  // L1: leaves the cell
        }
        if (!certainly_positive(out.numerator)) {
            return cap + 1;  // bounds too coarse to go on (or NaN): undecided
        }
        if (detail::count_ends<I>(count, interrupted) || macro_steps.hopeless(count)) {
            return cap + 1;
        }
        macro::WallState<I> state{contact->x, low_end(low_end(out.numerator) / denominator)};
        c = contact->sin_x + state.kappa * (state.x + pi<I>());
        trend.add(*contact, state.kappa);
        if (macro_steps.follow(state, c, count)) {
            trend.forget();
        }
        kappa = state.kappa;
        c = low_end(c);
    }
    return cap + 1;
}

/// A lower bound of G over all rays that lie at or below `highest` in c (c >= 0), kappa and r: the highest,
/// steepest ray is followed with upper bounds, and only certain, transversal collisions count. Stops at
/// `cap`, and early if interrupted.
template <class I>
[[gnu::flatten]] CountOf<I> count_at_least(const Ray<I>& highest, const CountOf<I>& cap,
                                           const Interrupted& interrupted = never) {
    const I r = high_end(highest.r);
    I c = high_end(highest.c);
    I kappa = high_end(highest.kappa);
    detail::MacroSteps<I> macro_steps(macro::BoundSide::upper, r, cap, interrupted);
    ContactTrend<I> trend;
    for (CountOf<I> count = 0; count < cap; ++count) {
        if (!certainly_less(kappa, I(1))) {
            return count;
        }
        const auto contact = highest_contact(c, kappa, trend.next());
        if (!contact) {
            return count;
        }
        const auto out = reflect_at_light_wall(kappa, contact->cos_x, r);
        if (!certainly_positive(out.denominator) || detail::count_ends<I>(count, interrupted) ||
            macro_steps.hopeless(count)) {
            return count + 1;
        }
        macro::WallState<I> state{contact->x, high_end(out.numerator / out.denominator)};
        c = contact->sin_x + state.kappa * (state.x + pi<I>());
        trend.add(*contact, state.kappa);
        if (macro_steps.follow(state, c, count)) {
            trend.forget();
        }
        kappa = state.kappa;
        c = high_end(c);
    }
    return cap;
}

}  // namespace dumbbell::flight
