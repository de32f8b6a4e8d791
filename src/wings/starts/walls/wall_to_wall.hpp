#pragma once

#include <array>
#include <optional>
#include <utility>

#include "starts/air/flight.hpp"
#include "starts/air/jet.hpp"

namespace dumbbell::starts {

/// Some values over a box, as the parameters of what is computed next. In natural form they are that anyway.
template <class S, std::size_t n>
class Recentred {
  public:
    explicit Recentred(const std::array<S, n>& values) : values_(values) {}

    [[nodiscard]] const S& parameter(std::size_t i) const { return values_[i]; }
    /// f, computed from the parameters, as a function of what the values were computed from.
    [[nodiscard]] S composed(const S& f) const { return f; }

  private:
    std::array<S, n> values_;
};

/// In mean value form: values z(p), z(p_c) in C. A function f of them is computed as a jet over the box Z of
/// all values with a thin centre m, and
///
///     f(z(p_c)) in f(m) + f'(Z) (C - m),    d f(z(p)) / dp in f'(Z) z'(P),
///
/// by the mean value theorem and the chain rule, because Z is convex and contains m and z(p_c). So the
/// rounding errors in C, and what is lost of the correlations in z', are carried on by the derivative of f as
/// a whole, not by each of the operations that f consists of. Where the signs of f' allow it (a monotone f)
/// nothing is lost in these products.
template <class I, std::size_t n>
class Recentred<Jet<I>, n> {
  public:
    explicit Recentred(const std::array<Jet<I>, n>& values)
        : outer_displacement_(values[0].displacement()), displacement_(Gradient<I>::Zero()) {
        static_assert(n <= parameters);
        for (std::size_t i = 0; i < n; ++i) {
            const auto k = static_cast<int>(i);
            const I at_centre = intersection(values[i].centre(), values[i].range());
            middle_[i] = midpoint(at_centre);
            box_[i] = hull(values[i].range(), middle_[i]);
            displacement_[k] = box_[i] - middle_[i];
            error_[k] = at_centre - middle_[i];
            gradients_.col(k) = values[i].gradient();
        }
    }
    ~Recentred() = default;
    Recentred(const Recentred&) = delete;
    Recentred& operator=(const Recentred&) = delete;

    /// Valid as long as this object, as is all that is computed from it, unless it is composed.
    [[nodiscard]] Jet<I> parameter(std::size_t i) const {
        return Jet<I>::parameter(static_cast<int>(i), middle_[i], box_[i], displacement_);
    }

    [[nodiscard]] Jet<I> composed(const Jet<I>& f) const {
        const Column derivatives = f.gradient().template head<n>();
        return {f.centre() + derivatives.dot(error_), f.range(), gradients_ * derivatives,
                outer_displacement_};
    }

  private:
    using Column = Eigen::Matrix<I, n, 1>;

    std::array<I, n> middle_;
    std::array<I, n> box_;
    Column error_;                               ///< C - m
    Eigen::Matrix<I, parameters, n> gradients_;  ///< z'
    const Gradient<I>* outer_displacement_;
    Gradient<I> displacement_;
};

/// A box of orbits from contact to contact. Every step is enclosed twice; the common part is kept.
///
/// *Along the orbit*, as a function of the state before, with its velocities. Over wide boxes this keeps the
/// correlations of the velocities; but each of its many operations widens rounding errors anew, by more than
/// a bit per collision.
///
/// *Stepwise.* The flights are lines: the next contact and the reflection there depend on the angle phi at
/// which a flight begins, its slope d yhat / d phi and r only; how fast it is follows from the energy. So the
/// step is computed as a function of these three, at |phidot| = 1, and composed with what they are as
/// functions of the first box. From light wall to light wall, turned so that the flight goes right, the next
/// distance from the corner and slope do not decrease with the distance before, the slope or r (L5): the
/// derivatives have one sign each, and their products make rounding errors no wider than orbits diverge. Of
/// bodies other than the massless dumbbell it is left out.
template <class S>
class WallToWall {
  public:
    explicit WallToWall(Bounce<S> first)
        : last_(std::move(first)),
          slope_(last_.after.yhatdot / last_.after.phidot),
          speed_((certainly_positive(-range(last_.after.phidot)) ? -last_.after.phidot : last_.after.phidot) *
                 steepness()) {}

    [[nodiscard]] const Bounce<S>& last() const { return last_; }

    /// Goes to the next contact, if there is certainly one; then last() is that.
    Next advance() {
        Next next = Next::unknown;
        auto step = along_the_orbit(next);
        if (const auto other = stepwise(next)) {
            step = step ? common_part(*step, *other) : *other;
        }
        if (step) {
            last_ = std::move(step->bounce);
            slope_ = std::move(step->slope);
        }
        return next;
    }

  private:
    struct Step {
        Bounce<S> bounce;
        S slope;  ///< after it
    };

    std::optional<Step> along_the_orbit(Next& next) const {
        const Event<S> event = event_after_contact(last_.after, last_.end);
        next = event.next;
        if (next != Next::contact) {
            return std::nullopt;
        }
        Bounce<S> b = bounce(last_.after, event.end, *event.time);
        S slope = b.after.yhatdot / b.after.phidot;
        return Step{std::move(b), std::move(slope)};
    }

    /// Leaves `next` alone if nothing is certain.
    std::optional<Step> stepwise(Next& next) const {
        const State<S>& from = last_.after;
        const bool right = certainly_positive(range(from.phidot));
        if (!from.body.is_massless || (!right && !certainly_positive(-range(from.phidot)))) {
            return std::nullopt;
        }
        const S along(right ? 1 : -1);
        const Recentred<S, 3> box({from.phi, slope_, from.body.r});
        const S& phi = box.parameter(0);
        const auto body = flight::Body<S>::massless(box.parameter(2));
        const State<S> start{phi,   body.contact_height(last_.end, sin_cos(phi).sin),
                             along, along * box.parameter(1),
                             body,  S(0)};
        const Event<S> event = event_after_contact(start, last_.end);
        next = event.next == Next::unknown ? next : event.next;
        if (event.next != Next::contact) {
            return std::nullopt;
        }
        const Bounce<S> unit = bounce(start, event.end, *event.time);
        const S spin = common_part(along * from.phidot, speed_ / steepness());
        const State<S> before{box.composed(unit.before.phi),
                              box.composed(unit.before.yhat),
                              along * spin,
                              common_part(from.yhatdot, along * slope_ * spin),
                              from.body,
                              from.time + box.composed(*event.time) / spin};
        State<S> after = before;
        after.phidot = box.composed(unit.after.phidot) * spin;
        after.yhatdot = box.composed(unit.after.yhatdot) * spin;
        return Step{{event.end, before, after}, box.composed(unit.after.yhatdot / unit.after.phidot)};
    }

    static State<S> common_part(const State<S>& a, const State<S>& b) {
        return {common_part(a.phi, b.phi),
                common_part(a.yhat, b.yhat),
                common_part(a.phidot, b.phidot),
                common_part(a.yhatdot, b.yhatdot),
                a.body,
                common_part(a.time, b.time)};
    }
    static Step common_part(const Step& a, const Step& b) {
        return {{a.bounce.end, common_part(a.bounce.before, b.bounce.before),
                 common_part(a.bounce.after, b.bounce.after)},
                common_part(a.slope, b.slope)};
    }
    static S common_part(const S& a, const S& b) {
        using dumbbell::common_part;
        return common_part(a, b);
    }

    /// The energy, phidot^2 + yhatdot^2 / r, is (|phidot| steepness)^2.
    [[nodiscard]] S steepness() const { return sqrt(S(1) + sqr(slope_) / last_.after.body.r); }

    Bounce<S> last_;
    S slope_;  ///< means nothing while the direction is uncertain
    S speed_;
};

}  // namespace dumbbell::starts
