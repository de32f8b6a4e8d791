#pragma once

#include <array>
#include <utility>

#include "starts/jet.hpp"

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
    explicit Recentred(const std::array<Jet<I>, n>& values) : outer_displacement_(values[0].displacement()) {
        static_assert(n <= parameters);
        for (std::size_t i = 0; i < n; ++i) {
            const I at_centre = intersection(values[i].centre(), values[i].range());
            middle_[i] = midpoint(at_centre);
            box_[i] = hull(values[i].range(), middle_[i]);
            displacement_[i] = box_[i] - middle_[i];
            error_[i] = at_centre - middle_[i];
            gradients_[i] = values[i].gradient();
        }
    }
    ~Recentred() = default;
    Recentred(const Recentred&) = delete;
    Recentred& operator=(const Recentred&) = delete;

    /// Valid as long as this object, as is all that is computed from it, unless it is composed.
    [[nodiscard]] Jet<I> parameter(std::size_t i) const {
        return Jet<I>::parameter(i, middle_[i], box_[i], displacement_);
    }

    [[nodiscard]] Jet<I> composed(const Jet<I>& f) const {
        I change = f.gradient()[n - 1] * error_[n - 1];
        Gradient<I> gradient = gradients_[n - 1] * f.gradient()[n - 1];
        for (std::size_t i = n - 1; i-- > 0;) {
            change = f.gradient()[i] * error_[i] + change;
            gradient = gradients_[i] * f.gradient()[i] + gradient;
        }
        return {f.centre() + change, f.range(), std::move(gradient), outer_displacement_};
    }

  private:
    std::array<I, n> middle_;
    std::array<I, n> box_;
    std::array<I, n> error_;                ///< C - m
    std::array<Gradient<I>, n> gradients_;  ///< z'
    const Gradient<I>* outer_displacement_;
    Gradient<I> displacement_;
};

}  // namespace dumbbell::starts
