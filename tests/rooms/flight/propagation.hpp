#pragma once

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
    displacement = dumbbell::starts::Gradient<I>::Zero();
    displacement[0] = box.x - centre.x;
    displacement[1] = box.kappa - centre.kappa;
    return {dumbbell::starts::Jet<I>::parameter(0, centre.x, box.x, displacement),
            dumbbell::starts::Jet<I>::parameter(1, centre.kappa, box.kappa, displacement)};
}

template <class I>
WallState<I> middle(const WallState<I>& box) {
    return {midpoint(box.x), midpoint(box.kappa)};
}

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
        Square derivative;
        derivative << image->x.gradient()[0], image->x.gradient()[1], image->kappa.gradient()[0],
            image->kappa.gradient()[1];
        const Square product = derivative * matrix_;
        const WallState<I> value{image->x.centre(), image->kappa.centre()};
        box_ = {image->x.range(), image->kappa.range()};
        centre_ = middle(value);
        matrix_ = product.unaryExpr([](const I& entry) { return midpoint(entry); });
        const I determinant = matrix_(0, 0) * matrix_(1, 1) - matrix_(0, 1) * matrix_(1, 0);
        if (!certainly_positive(determinant) && !certainly_positive(-determinant)) {
            reset();
            return true;
        }
        Square inverse;
        inverse << matrix_(1, 1), -matrix_(0, 1), -matrix_(1, 0), matrix_(0, 0);
        inverse = inverse * (I(1) / determinant);
        const Square change = inverse * product;
        const Column carried = change * error_;
        const Column fresh = inverse * Column(value.x - centre_.x, value.kappa - centre_.kappa);
        error_ = carried + fresh;
        const Column spread = matrix_ * error_;
        box_ = {intersection(box_.x, centre_.x + spread[0]),
                intersection(box_.kappa, centre_.kappa + spread[1])};
        return true;
    }

  private:
    using Square = Eigen::Matrix<I, 2, 2>;
    using Column = Eigen::Matrix<I, 2, 1>;

    void reset() {
        centre_ = middle(box_);
        matrix_ << I(1), I(0), I(0), I(1);
        error_ << box_.x - centre_.x, box_.kappa - centre_.kappa;
    }

    WallState<I> box_;
    WallState<I> centre_{I(0), I(0)};
    Square matrix_;
    Column error_;
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
