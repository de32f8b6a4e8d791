#pragma once

#include <array>
#include <utility>
#include <vector>

#include "wall_step.hpp"

/// A box of states followed from light wall to light wall in five forms of one and the same computation, to
/// compare how their enclosures grow. The steps are those of src/model; only the forms that re-express a box
/// after every step are put together here.
namespace dumbbell_test {

/// The enclosures after each collision from which all states certainly turn back.
template <class I>
struct Propagated {
    std::vector<WallState<I>> boxes{};
    End end = End::open;

    [[nodiscard]] bool finished() const { return end == End::passed || end == End::left; }
    /// The certified ones, of all states.
    [[nodiscard]] std::size_t collisions() const {
        return boxes.size() + (end == End::struck || end == End::left ? 1 : 0);
    }
};

enum class Form {
    natural,         ///< interval evaluation of every step over a box
    mean_value,      ///< mean value form of every step over a box
    correlated,      ///< mean value form of the whole orbit over the first box: a half of what `trace` does
    parallelepiped,  ///< a linear image of a box, preconditioned by its own matrix after every step
    monotone         ///< the lowest and the highest ray (L5): what the counts follow
};
inline constexpr Form all_forms[] = {Form::natural, Form::mean_value, Form::correlated, Form::parallelepiped,
                                     Form::monotone};

inline const char* name_of(Form form) {
    switch (form) {
        case Form::natural:
            return "natural";
        case Form::mean_value:
            return "mean value";
        case Form::correlated:
            return "correlated";
        case Form::parallelepiped:
            return "parallelepiped";
        default:
            return "monotone";
    }
}

/// A box as functions of its two coordinates.
template <class I>
WallState<dumbbell::starts::Jet<I>> as_parameters(const WallState<I>& box, const WallState<I>& centre,
                                                  dumbbell::starts::Gradient<I>& displacement) {
    displacement = {};
    displacement[0] = box.x - centre.x;
    displacement[1] = box.kappa - centre.kappa;
    return {dumbbell::starts::Jet<I>::parameter(0, centre.x, box.x, displacement),
            dumbbell::starts::Jet<I>::parameter(1, centre.kappa, box.kappa, displacement)};
}

template <class I>
WallState<I> middle(const WallState<I>& box) {
    return {midpoint(box.x), midpoint(box.kappa)};
}

template <class I>
using Column = std::array<I, 2>;

/// A matrix by its rows.
template <class I>
struct Square {
    Column<I> first, second;

    friend Column<I> operator*(const Square& m, const Column<I>& z) {
        return {m.first[0] * z[0] + m.first[1] * z[1], m.second[0] * z[0] + m.second[1] * z[1]};
    }
    friend Square operator*(const Square& m, const Square& other) {
        const Column<I> left = m * Column<I>{other.first[0], other.second[0]};
        const Column<I> right = m * Column<I>{other.first[1], other.second[1]};
        return {{left[0], right[0]}, {left[1], right[1]}};
    }
};

/// The set { centre + matrix z : z in `error` }.
template <class I>
class Parallelepiped {
  public:
    explicit Parallelepiped(const WallState<I>& box) : box_(box) { reset(); }

    [[nodiscard]] const WallState<I>& box() const { return box_; }

    /// f(centre + A z) lies in f(centre) + J A z, J the derivative over the box. With A' near J A and its
    /// inverse enclosed, z' = A'^-1 J A z + A'^-1 (f(centre) - centre').
    bool advance(const I& r, End& end) {
        dumbbell::starts::Gradient<I> displacement;
        const auto image = step(as_parameters(box_, centre_, displacement), r, end);
        if (!image) {
            return false;
        }
        const auto& x_rates = image->x.gradient();
        const auto& kappa_rates = image->kappa.gradient();
        const Square<I> product =
            Square<I>{{x_rates[0], x_rates[1]}, {kappa_rates[0], kappa_rates[1]}} * matrix_;
        const WallState<I> value{image->x.centre(), image->kappa.centre()};
        box_ = {image->x.range(), image->kappa.range()};
        centre_ = middle(value);
        matrix_ = {{midpoint(product.first[0]), midpoint(product.first[1])},
                   {midpoint(product.second[0]), midpoint(product.second[1])}};
        const auto& [top, bottom] = matrix_;
        const I determinant = top[0] * bottom[1] - top[1] * bottom[0];
        if (!certainly_positive(determinant) && !certainly_positive(-determinant)) {
            reset();
            return true;
        }
        const I inverse_determinant = I(1) / determinant;
        const Square<I> inverse{{bottom[1] * inverse_determinant, -top[1] * inverse_determinant},
                                {-bottom[0] * inverse_determinant, top[0] * inverse_determinant}};
        const Column<I> carried = inverse * product * error_;
        const Column<I> fresh = inverse * Column<I>{value.x - centre_.x, value.kappa - centre_.kappa};
        error_ = {carried[0] + fresh[0], carried[1] + fresh[1]};
        const Column<I> spread = matrix_ * error_;
        box_ = {intersection(box_.x, centre_.x + spread[0]),
                intersection(box_.kappa, centre_.kappa + spread[1])};
        return true;
    }

  private:
    void reset() {
        centre_ = middle(box_);
        matrix_ = {{I(1), I(0)}, {I(0), I(1)}};
        error_ = {box_.x - centre_.x, box_.kappa - centre_.kappa};
    }

    WallState<I> box_;
    WallState<I> centre_{I(0), I(0)};
    Square<I> matrix_;
    Column<I> error_;
};

/// Follows all states of `start` at mass ratio 1/r, through at most `limit` collisions.
template <class I>
Propagated<I> propagate(Form form, const WallState<I>& start, const I& r, long limit = 100'000) {
    using dumbbell::starts::Jet;
    Propagated<I> result;
    WallState<I> box = start;
    Parallelepiped<I> linear(start);
    dumbbell::starts::Gradient<I> first, displacement;
    WallState<Jet<I>> jets = as_parameters(start, middle(start), first);
    const auto advance = [&]() -> std::optional<WallState<I>> {
        switch (form) {
            case Form::natural:
                return step(box, r, result.end);
            case Form::monotone:
                return monotone_step(box, r, result.end);
            case Form::parallelepiped:
                return linear.advance(r, result.end) ? std::optional(linear.box()) : std::nullopt;
            default: {
                if (form == Form::mean_value) {
                    jets = as_parameters(box, middle(box), displacement);
                }
                auto next = step(jets, r, result.end);
                if (!next) {
                    return std::nullopt;
                }
                jets = std::move(*next);
                return WallState<I>{jets.x.range(), jets.kappa.range()};
            }
        }
    };
    while (static_cast<long>(result.boxes.size()) < limit) {
        const auto next = advance();
        if (!next) {
            break;
        }
        box = *next;
        result.boxes.push_back(box);
    }
    return result;
}

}  // namespace dumbbell_test
