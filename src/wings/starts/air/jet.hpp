#pragma once

#include <utility>

#include "flight/eigen_interval.hpp"
#include "number/enclosure.hpp"

namespace dumbbell::starts {

/// The parameters of a box of initial conditions: phi, phidot, y, ydot and the mass ratio.
inline constexpr int parameters = 5;
template <class I>
using Gradient = Eigen::Matrix<I, parameters, 1>;

/// A differentiable function f of the parameters p over a box P with centre p_c, in mean value form:
/// enclosures of f(p_c), of f(P) and of the gradient of f on P. For all p in P, f(p) lies in f(p_c) +
/// gradient (P - p_c), so the range is intersected with that after every operation. This is what keeps the
/// correlations between the quantities of an orbit.
///
/// A constant may stand for an unknown number in an interval; then all this holds for each of its values.
template <class I>
class Jet {
  public:
    explicit Jet(double constant) : Jet(I(constant)) {}
    explicit Jet(const I& constant)
        : centre_(constant), range_(constant), gradient_(Gradient<I>::Zero()), displacement_(nullptr) {}

    /// `displacement` (P - p_c) must outlive the jet and everything that is computed from it.
    Jet(I centre, const I& range, Gradient<I> gradient, const Gradient<I>* displacement)
        : centre_(std::move(centre)),
          range_(range),
          gradient_(std::move(gradient)),
          displacement_(displacement) {
        if (displacement_ != nullptr) {
            range_ = intersection(range_, centre_ + gradient_.dot(*displacement_));
        }
    }

    /// The parameter with this index.
    static Jet parameter(int index, const I& centre, const I& range, const Gradient<I>& displacement) {
        Gradient<I> unit = Gradient<I>::Zero();
        unit[index] = I(1);
        return {centre, range, std::move(unit), &displacement};
    }

    [[nodiscard]] const I& centre() const noexcept { return centre_; }
    [[nodiscard]] const I& range() const noexcept { return range_; }
    [[nodiscard]] const Gradient<I>& gradient() const noexcept { return gradient_; }
    [[nodiscard]] const Gradient<I>* displacement() const noexcept { return displacement_; }

    friend Jet operator-(const Jet& a) { return {-a.centre_, -a.range_, -a.gradient_, a.displacement_}; }
    friend Jet operator+(const Jet& a, const Jet& b) {
        return {a.centre_ + b.centre_, a.range_ + b.range_, a.gradient_ + b.gradient_, common(a, b)};
    }
    friend Jet operator-(const Jet& a, const Jet& b) {
        return {a.centre_ - b.centre_, a.range_ - b.range_, a.gradient_ - b.gradient_, common(a, b)};
    }
    friend Jet operator*(const Jet& a, const Jet& b) {
        return {a.centre_ * b.centre_, a.range_ * b.range_, a.gradient_ * b.range_ + b.gradient_ * a.range_,
                common(a, b)};
    }
    friend Jet operator/(const Jet& a, const Jet& b) {
        const I quotient = a.range_ / b.range_;
        const I inverse = I(1) / b.range_;
        return {a.centre_ / b.centre_, quotient, (a.gradient_ - b.gradient_ * quotient) * inverse,
                common(a, b)};
    }
    friend Jet sqr(const Jet& a) {
        return {sqr(a.centre_), sqr(a.range_), a.gradient_ * (I(2) * a.range_), a.displacement_};
    }
    friend SinCos<Jet> sin_cos(const Jet& a) {
        const SinCos<I> centre = dumbbell::sin_cos(a.centre_);
        const SinCos<I> range = dumbbell::sin_cos(a.range_);
        return {Jet(centre.sin, range.sin, a.gradient_ * range.cos, a.displacement_),
                Jet(centre.cos, range.cos, a.gradient_ * (-range.sin), a.displacement_)};
    }
    /// Precondition: all values are positive.
    friend Jet sqrt(const Jet& a) {
        const I root = sqrt(a.range_);
        return {sqrt(a.centre_), root, a.gradient_ * (I(1) / (I(2) * root)), a.displacement_};
    }

    /// What two enclosures of the same function say together.
    friend Jet common_part(const Jet& a, const Jet& b) {
        const auto entry = [](const I& x, const I& y) { return common_part(x, y); };
        return {entry(a.centre_, b.centre_), entry(a.range_, b.range_),
                a.gradient_.binaryExpr(b.gradient_, entry), common(a, b)};
    }

  private:
    static const Gradient<I>* common(const Jet& a, const Jet& b) {
        return a.displacement_ != nullptr ? a.displacement_ : b.displacement_;
    }

    I centre_;
    I range_;
    Gradient<I> gradient_;
    const Gradient<I>* displacement_;
};

template <class I>
[[nodiscard]] const I& range(const Jet<I>& x) noexcept {
    return x.range();
}

}  // namespace dumbbell::starts

template <class I>
struct dumbbell::EnclosureOf<dumbbell::starts::Jet<I>> {
    using Type = I;
};
