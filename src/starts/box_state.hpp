#pragma once

#include "starts/certificate.hpp"
#include "starts/jet.hpp"
#include "starts/state.hpp"

/// Boxes of initial conditions as states of the model.
namespace dumbbell::starts {

/// Throws InputError, in one line that names the quantity and the remedy, unless every state of the box is in
/// play: no value absurdly large, phi over less than a turn, both masses above the floor, and no dumbbell at
/// rest.
void require_in_play(const Box& box);

/// The state with these quantities: yhat = y (1 + rho), r = 1/q. `rho`: of bodies.
template <class S>
[[nodiscard]] State<S> state_of(const S& phi, const S& phidot, const S& y, const S& ydot, const S& q,
                                const S& rho, bool is_body) {
    const S r = S(1) / q;
    const S scale = S(1) + (is_body ? rho : r);
    return {phi, y * scale, phidot, ydot * scale, r, S(0), is_body ? rho : r, is_body};
}

/// The rho of a box of bodies; of others any number.
template <class I>
[[nodiscard]] I rho_of(const Box& box) {
    return enclose<I>(box.rho.value_or(1));
}

/// Whether q can only be 1. Then r is 1 itself, whatever the division loses: no trajectory has more than two
/// collisions (L7).
[[nodiscard]] inline bool has_equal_masses(const Box& box) { return box.upper(Axis::ratio) == 1; }

/// All states of the box, in natural form.
template <class I>
[[nodiscard]] State<I> natural_state(const Box& box) {
    const auto side = [&](std::size_t i) { return hull(enclose<I>(box.lo[i]), enclose<I>(box.hi[i])); };
    State<I> s = state_of(side(0), side(1), side(2), side(3), side(4), rho_of<I>(box), box.rho.has_value());
    s.r = has_equal_masses(box) ? I(1) : s.r;
    return s;
}

/// All states of the box as functions of the five quantities.
template <class I>
class BoxJets {
  public:
    explicit BoxJets(const Box& box)
        : equal_masses_(has_equal_masses(box)),
          is_body_(box.rho.has_value()),
          rho_(rho_of<I>(box)),
          displacement_(Gradient<I>::Zero()) {
        for (std::size_t i = 0; i < axis_count; ++i) {
            centre_[i] = enclose<I>((box.lo[i] + box.hi[i]) / 2);
            range_[i] = hull(enclose<I>(box.lo[i]), enclose<I>(box.hi[i]));
            if (box.lo[i] != box.hi[i]) {
                displacement_[static_cast<int>(i)] = range_[i] - centre_[i];
            }
        }
    }
    ~BoxJets() = default;
    BoxJets(const BoxJets&) = delete;
    BoxJets& operator=(const BoxJets&) = delete;

    /// Valid as long as this object.
    [[nodiscard]] State<Jet<I>> state() const {
        const auto side = [&](std::size_t i) {
            return Jet<I>::parameter(static_cast<int>(i), centre_[i], range_[i], displacement_);
        };
        State<Jet<I>> s = state_of(side(0), side(1), side(2), side(3), side(4), Jet<I>(rho_), is_body_);
        s.r = equal_masses_ ? Jet<I>(1) : s.r;
        return s;
    }

  private:
    bool equal_masses_;
    bool is_body_;
    I rho_;
    std::array<I, axis_count> centre_;
    std::array<I, axis_count> range_;
    Gradient<I> displacement_;
};

}  // namespace dumbbell::starts
