#include "adiabatic_judge.hpp"

#include "adiabatic/bounce_leaf.hpp"
#include "adiabatic/orbit.hpp"
#include "adiabatic/pair_leaf.hpp"

namespace dumbbell_mutation {
namespace {

using namespace dumbbell;
using namespace dumbbell::adiabatic;
using Axis = adiabatic::Axis;
using Found = AdiabaticJudge::Found;
using Masses = adiabatic::Masses<Interval>;

Interval side(const AdiabaticSet& box, Axis axis) {
    const auto i = static_cast<std::size_t>(axis);
    return hull(enclose<Interval>(box.lo[i]), enclose<Interval>(box.hi[i]));
}

adiabatic::Potential<Interval> potential_of(const adiabatic::Class& one) {
    std::vector<adiabatic::Potential<Interval>::Cell> cells;
    for (const auto& cell : one.cells)
        cells.push_back({enclose<Interval>(cell.u), enclose<Interval>(cell.v)});
    return adiabatic::Potential<Interval>(std::move(cells));
}

Found found(bool bounded) { return bounded ? Found::bound : Found::nothing; }

Rational power(const Rational& x, int n) {
    Rational result = 1;
    for (; n > 0; --n) result *= x;
    return result;
}

/// The hypotheses, and the error in the claim's unit, of one orbit.
class Orbit {
    using I = Interval;

  public:
    Orbit(const adiabatic::Hypotheses& of, const adiabatic::State& state)
        : of_(of),
          state_(state),
          u_(enclose<I>(state.u)),
          s_(enclose<I>(state.s)),
          delta_(enclose<I>(state.delta)),
          orbit_(u_, s_, delta_) {}

    /// `second`: E2 of a bounce.
    [[nodiscard]] bool attains(bool second) {
        if (!certainly_positive(orbit_.at().x) || !certainly_positive(orbit_.at().w)) return false;
        switch (of_.claim) {
            case adiabatic::Claim::bounce:
                return has_heights() && orbit_.advance() && bounce(second);
            case adiabatic::Claim::run:
                return has_heights() && follow() && at_least(abs(orbit_.change()), delta_);
            default:
                return orbit_.certainly_begins() && follow() && orbit_.certainly_ends() && scattered();
        }
    }

  private:
    [[nodiscard]] bool at_least(const I& error, const I& unit) const {
        return certainly_at_most(enclose<I>(state_.value) * unit, error);
    }
    [[nodiscard]] bool has_heights() const {
        const I y = orbit_.masses().beta2 * orbit_.at().s;
        return certainly_at_most(enclose<I>(of_.heights.first), y) &&
               certainly_at_most(y, enclose<I>(of_.heights.second));
    }
    [[nodiscard]] bool is_apart(const I& margin) const { return certainly_at_most(margin, orbit_.angle()); }
    [[nodiscard]] bool follow() {
        for (long n = 0; n < state_.n; ++n)
            if (!orbit_.advance() ||
                (of_.claim == adiabatic::Claim::run && !is_apart(enclose<I>(of_.margin))))
                return false;
        return true;
    }
    [[nodiscard]] bool scattered() const {
        const I unit = sqrt(delta_);
        return is_apart(enclose<I>(of_.margin) * unit) && at_least(abs(orbit_.change_behind()), unit);
    }
    [[nodiscard]] bool bounce(bool second) const {
        const adiabatic::Bounce<I> first(u_, s_, orbit_.masses());
        const I k = delta_power(delta_, of_.exponent), square = sqr(delta_);
        if (!second) return at_least(first.speed_error(), square / sqr(k));
        const auto next = next_contact(first);
        return next && !next->none && at_least(height_error(first, *next), I(2) * square / k);
    }

    const adiabatic::Hypotheses& of_;
    const adiabatic::State& state_;
    I u_, s_, delta_;
    adiabatic::Orbit<I> orbit_;
};

}  // namespace

std::vector<Axis> class_axes() { return {Axis::u, Axis::sigma, Axis::delta}; }
std::vector<Axis> claim_axes(adiabatic::Claim claim) {
    if (claim == adiabatic::Claim::bounce) return {Axis::u, Axis::s, Axis::delta};
    return {Axis::u, Axis::s, Axis::v, Axis::delta};
}

AdiabaticJudge::AdiabaticJudge(const adiabatic::Certificate& certificate)
    : certificate_(certificate), sides_(certificate.hypotheses) {
    for (const adiabatic::Class& one : certificate.classes) potentials_.push_back(potential_of(one));
}

AdiabaticSet AdiabaticJudge::root(const std::vector<Axis>& axes) const {
    const auto& [from, to] = certificate_.hypotheses.delta;
    AdiabaticSet box;
    for (const Axis axis : axes) {
        const auto i = static_cast<std::size_t>(axis);
        if (axis == Axis::delta) box.lo[i] = from;
        box.hi[i] = axis == Axis::delta ? to : axis == Axis::sigma ? 8 : axis == Axis::s ? 1 : 2;
    }
    return box;
}

Found AdiabaticJudge::of_class(std::size_t number, const AdiabaticSet& box) const {
    const adiabatic::Class& one = certificate_.classes.at(number);
    const Masses masses(side(box, Axis::delta));
    const adiabatic::Verdict verdict =
        judge_flights(side(box, Axis::u), side(box, Axis::sigma), masses, sides_.margin(masses),
                      enclose<Interval>(one.least_share), potentials_.at(number));
    return verdict.outside ? Found::outside : found(verdict.closed());
}

Found AdiabaticJudge::of_claim(std::size_t number, const AdiabaticSet& box) const {
    return certificate_.hypotheses.claim == adiabatic::Claim::bounce ? of_bounce(box) : of_pair(number, box);
}

Found AdiabaticJudge::of_bounce(const AdiabaticSet& box) const {
    const Masses masses(side(box, Axis::delta));
    const auto u = admitted_angle(side(box, Axis::u), sides_.margin(masses));
    if (!u || sides_.certainly_elsewhere(*u, masses)) return Found::outside;
    const adiabatic::Bounce<Interval> bounce(*u, side(box, Axis::s), masses);
    if (certainly_at_most(bounce.forward(), Interval(0))) return Found::outside;
    const auto next = next_contact(bounce);
    if (!next) return Found::nothing;
    const Interval k = delta_power(masses.delta, certificate_.hypotheses.exponent);
    const Interval square = sqr(masses.delta);
    const auto bounded = [&](const Interval& error, std::size_t i) {
        return certainly_at_most(error, enclose<Interval>(certificate_.bounds.at(i)));
    };
    return found(next->none ||
                 (bounded(bounce.speed_error() * sqr(k) / square, 0) &&
                  bounded(magnitude(height_error(bounce, *next)) * k / (Interval(2) * square), 1)));
}

Found AdiabaticJudge::of_pair(std::size_t number, const AdiabaticSet& box) const {
    const bool run = certificate_.hypotheses.claim == adiabatic::Claim::run;
    const Masses masses(side(box, Axis::delta));
    const Interval margin = sides_.margin(masses);
    const auto u = admitted_angle(side(box, Axis::u), margin), v = admitted_angle(side(box, Axis::v), margin);
    if (!u || !v || (run && sides_.certainly_elsewhere(*u, masses))) return Found::outside;
    const adiabatic::Pair<Interval> pair(*u, side(box, Axis::s), *v, masses);
    if (!run && certainly_not_first(pair)) return Found::outside;
    const Interval share = enclose<Interval>(certificate_.classes.at(number).least_share);
    const auto& potential = potentials_.at(number);
    const auto error = run ? run_error(pair, share, potential) : scattering_error(pair, share, potential);
    return found(error && certainly_at_most(*error, enclose<Interval>(certificate_.bounds.at(0))));
}

bool AdiabaticJudge::attained(std::size_t number) const {
    const adiabatic::Hypotheses& of = certificate_.hypotheses;
    const adiabatic::State& state = certificate_.attained.at(number);
    const int exponent = of.claim == adiabatic::Claim::bounce ? of.exponent
                         : of.claim == adiabatic::Claim::run  ? 0
                                                              : 8;
    if (state.u <= 0 || state.s < 0 || state.s > 1 || state.delta <= 0 || state.n < 0 ||
        (of.claim == adiabatic::Claim::bounce && state.n != 1) || state.delta < of.delta.first ||
        state.delta > of.delta.second ||
        power(state.u, 16) < power(of.margin, 16) * power(state.delta, exponent))
        return false;
    return Orbit(of, state).attains(number == 1);
}

}  // namespace dumbbell_mutation
