#pragma once

#include <functional>

#include "starts/air/jet.hpp"
#include "starts/air/state.hpp"
#include "starts/cover/certificate.hpp"

/// Boxes of initial conditions as states of the model.
namespace dumbbell::starts {

/// Throws InputError, in one line that names the quantity and the remedy, unless every state of the box is in
/// play: no value absurdly large, phi over less than a turn, both masses above the floor, and no dumbbell at
/// rest.
void require_in_play(const Box& box);

/// The rho of a box of bodies; of others any number.
template <class I>
[[nodiscard]] I rho_of(const Box& box) {
    return enclose<I>(box.rho.value_or(1));
}

/// The state whose quantities `side` gives by the numbers of their axes: yhat = y (1 + rho), and r = 1/q, as
/// far as `limit` leaves it; if q can only be 1, r is 1 itself (for L7), whatever the division loses. `rho`:
/// of bodies.
template <class S, class Side, class Limit = std::identity>
[[nodiscard]] State<S> state_of(const Box& box, const Side& side, const S& rho, const Limit& limit = {}) {
    const S inverse = S(1) / side(4);
    const bool is_one = box.lower(Axis::ratio) == 1 && box.upper(Axis::ratio) == 1;
    const S r = is_one ? S(1) : limit(inverse);
    const S scale = S(1) + (box.rho ? rho : inverse);
    const auto body = box.rho ? flight::Body<S>::with_mass(rho, r) : flight::Body<S>::massless(r);
    return {side(0), side(2) * scale, side(1), side(3) * scale, body, S(0)};
}

/// All values of a quantity of the box.
template <class I>
[[nodiscard]] I side_of(const Box& box, std::size_t i) {
    return hull(enclose<I>(box.lo.at(i)), enclose<I>(box.hi.at(i)));
}

/// All states of the box, in natural form.
template <class I>
[[nodiscard]] State<I> natural_state(const Box& box) {
    return state_of(
        box, [&](std::size_t i) { return side_of<I>(box, i); }, rho_of<I>(box));
}

/// All states of the box as functions of the five quantities.
template <class I>
class BoxJets {
  public:
    explicit BoxJets(const Box& box) : box_(box), displacement_(Gradient<I>::Zero()) {
        for (std::size_t i = 0; i < axis_count; ++i) {
            if (box.lo[i] != box.hi[i]) {
                displacement_[static_cast<int>(i)] = side_of<I>(box, i) - centre(i);
            }
        }
    }
    ~BoxJets() = default;
    BoxJets(const BoxJets&) = delete;
    BoxJets& operator=(const BoxJets&) = delete;

    /// Valid as long as this object.
    [[nodiscard]] State<Jet<I>> state() const {
        const auto side = [&](std::size_t i) {
            return Jet<I>::parameter(static_cast<int>(i), centre(i), side_of<I>(box_, i), displacement_);
        };
        return state_of(box_, side, Jet<I>(rho_of<I>(box_)));
    }

  private:
    [[nodiscard]] I centre(std::size_t i) const { return enclose<I>((box_.lo.at(i) + box_.hi.at(i)) / 2); }

    Box box_;
    Gradient<I> displacement_;
};

}  // namespace dumbbell::starts
