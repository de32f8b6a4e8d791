#pragma once

#include <array>

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

}  // namespace dumbbell::starts
