// A leaf of the layer (format-law.md, section 3.1): steps of middle U <= 9/10 and half-length rho U, for
// every eps in (0, 1/1000].
#include "verify/law/rule.hpp"

namespace dumbbell_verify::law {
namespace {

/// The quantities of a step (law.md) as functions of U, for all rho of an interval and all Q of a form.
template <class N, template <class> class Form>
struct LayerStep {
    using I = Interval<N>;
    using T = Form<N>;

    LayerStep(const Along<N, Form>& along, const I& rho_, const T& Q_) : rho(rho_), Q(Q_) {
        const T U = along.line(0, I(1)), d = along.line(0, rho);
        const T wave_d = along.sinc_of(rho), wave_U = along.sinc_of(1);
        const T wave_first = along.sinc_of(plus), wave_last = along.sinc_of(minus);
        cos_U = along.cos_of(1);
        sin_U = U * wave_U;
        F = along.line(pi<N>(), I(-1));
        const T cosine = Q / F, sine = square_root(I(1) - square(cosine));
        ehat = wave_d * wave_U * cosine / (sine * F);
        // tan beta = d b before the step, d b' after it; c, c' the cosines of beta.
        const T b = ehat / (plus * wave_first), b_last = ehat / (minus * wave_last);
        const T c = I(1) / square_root(I(1) + square(d * b));
        const T c_last = I(1) / square_root(I(1) + square(d * b_last));
        const T waves = wave_first * wave_last * (plus * minus);
        const T doubles = ehat * (wave_U * cos_U) * (wave_d * along.cos_of(rho)) * I(4);
        const T kc = square(c * c_last) / (c + c_last) * doubles * ehat / square(waves);
        const T ks =
            doubles * c * c_last / (waves * (plus * (wave_first / c) + minus * (wave_last / c_last)));
        const T ratio = wave_d / wave_U;
        const T xh = (square(ratio) -
                      square(U) * below_one(square(rho * along.U), fraction<N>(1, 5)) * fraction<N>(2, 3)) *
                     I(2) / (I(1) - square(ratio * rho));
        const T shift = d * below_one(square(rho * along.U), fraction<N>(1, 10)) / I(3);
        const T X_last = -(cos_U * wave_d + sin_U * shift) / (minus * wave_last);
        change = cosine * (c * xh + X_last * d * rho * kc * U) + Q * kc * U + sine * ks * U;
        last = cosine * c_last * X_last - Q * U * square(b_last * c_last) / (I(1) + c_last) -
               sine * U * b_last * c_last;
        first = last + change * rho;
    }

    I rho, plus = I(1) + rho, minus = I(1) - rho;
    T Q;
    T sin_U, cos_U, F;
    T ehat;                 ///< eps = rho U^2 ehat
    T change, first, last;  ///< A - A' = (d^3/U^2) change; A, A' = (d^2/U) first, last
};

template <class N>
class LayerRule : Rule<N> {
    using Base = Rule<N>;
    using Base::fact, Base::less, Base::within, Base::quarter;
    using I = Interval<N>;

  public:
    LayerRule(const Leaf& leaf, Log* log) : Base(leaf, log), U_(Base::side(0)), rho_(Base::side(1)) {}

    const char* verdict() {
        const bool holds = this->leaf_.rule == Leaf::beyond  ? is_beyond()
                           : this->leaf_.rule == Leaf::slope ? is_bounded<Slope>()
                                                             : is_bounded<Interval>();
        return holds ? nullptr : Base::failed();
    }
    /// Whether at U = 0, for this rho, D/D0(T) is 1, which takes the right k0.
    const char* normalised_verdict() { return is_normalised() ? nullptr : Base::failed(); }

  private:
    bool is_beyond() {
        const Along<N, Interval> along{U_};
        const LayerStep<N, Interval> step(along, rho_, Base::crude_Q());
        return less("1/1000 < rho U^2 ehat", fraction<N>(most_eps), rho_ * square(U_) * step.ehat);
    }

    template <template <class> class Form>
    bool is_bounded() {
        if (std::is_same_v<Form<N>, I> && !less("0 < U", 0, U_)) return false;
        const Along<N, Form> along{U_};
        const Along<N, Interval> wide{U_};
        I q = offset(wide, LayerStep<N, Interval>(wide, rho_, Base::crude_Q()));
        for (int i = 0; i < refinements; ++i)
            q = common(q, values_of(offset(along, LayerStep<N, Form>(along, rho_, offset_by(along, q)))));
        if (!less("(Q - pi/2)/(rho^2 U), its least and its most", I(q.lo), I(q.hi), false)) return false;
        const LayerStep<N, Form> step(along, rho_, offset_by(along, q));
        Form<N> excess;
        const Form<N> ratio = defect_ratio(along, step, excess);
        if (!less("0 < (1 + rho)^2 k1 - 2 rho ehat", 0, values_of(along.values(excess)))) return false;
        I gamma = (I(1) - values_of(along.values(ratio))) / U_;
        if constexpr (!std::is_same_v<Form<N>, I>) {
            if (!within("D/D0(T) = 1 at U = 0", 1, I(ratio.zero.lo), I(ratio.zero.hi))) return false;
            gamma = U_.lo > Base::zero ? common(gamma, -ratio.rise) : -ratio.rise;
        }
        const I drift = values_of(along.values(step.change / (square(step.ehat) * I(2))));
        const bool near = this->leaf_.box.hi[0] <= mpq_class(3, 4);
        return within("0 <= (1 - D/D0(T))/U <= 13/10, or 111/100 if U > 3/4", gamma, 0,
                      near ? fraction<N>(13, 10) : fraction<N>(111, 100)) &&
               less("a/(2 ehat^2) <= 15.9", drift, fraction<N>(159, 10), false);
    }

    /// (J - pi/2)/(U rho^2), from its window; eps = rho U^2 ehat.
    template <class Step, class Along>
    [[nodiscard]] typename Along::Factor J_offset(const Along& along, const Step& step) const {
        const I e2 = values_of(square(along.values(step.ehat)));
        return I{-(Base::drift() * e2 / cube(step.plus)).hi, (cube(U_) * e2 * Base::rise()).hi};
    }
    /// (Q - pi/2)/(U rho^2), as Q = J - A.
    template <class Step, class Along>
    [[nodiscard]] typename Along::Factor offset(const Along& along, const Step& step) const {
        return J_offset(along, step) - along.values(step.first);
    }
    template <class Along>
    [[nodiscard]] typename Along::T offset_by(const Along& along, const typename Along::Factor& q) const {
        return along.line(quarter, square(rho_) * q);
    }

    /// (1 + rho)^2 k1/ehat - 2 rho = 2 rho (T - 1) in `excess`; and D/D0(T), with T = (1 + rho)^2 k1/(2 rho
    /// ehat) and D0(T) = k0 eps^(1/2) (T^(1/2) - (T - 1)^(1/2))^3.
    template <template <class> class Form>
    Form<N> defect_ratio(const Along<N, Form>& along, const LayerStep<N, Form>& step, Form<N>& excess) const {
        using T = Form<N>;
        const T J = offset_by(along, J_offset(along, step));
        const Moments<N, Form> moments(along, step.Q, J);
        const auto way = moments.over_way(step.plus, this->leaf_.states->parts);
        const T E1 = middle_error(along, step.sin_U, step.cos_U, step.F, step.Q, rho_);
        // Second order in A: between Q and Q + A.
        const auto second = [&](const T& A, const I& p) {
            const auto size = up_to_size(along.values(A)) * square(rho_) * along.U;
            return along.whole(square(A)) *
                   (moments.second_order(p, along.values(step.Q) + size) * square(p));
        };
        const T E2 =
            way.H * step.change * square(step.plus) + moments.over_step(rho_) * step.last +
            along.line(0, rho_) * (second(step.first, step.plus) - second(step.last, step.minus)) / I(2);
        const T k = way.G / step.ehat * square(step.plus);  // 2 rho T
        excess = k - rho_ * I(2);
        const T roots = square_root(k) + square_root(excess);
        const I norm = I(4) * square_root(I(2)) * comparison_constant<N>();
        return (E1 + E2) * cube(roots) / (step.ehat * square_root(step.ehat)) / norm;
    }

    bool is_normalised() {
        const Along<N, Slope> along{U_};
        const LayerStep<N, Slope> step(along, rho_, offset_by(along, I(0)));
        Slope<N> excess;
        const I found = defect_ratio(along, step, excess).zero;
        return within("D/D0(T) = 1 at U = 0", 1, I(found.lo), I(found.hi)) &&
               less("D/D0(T) at U = 0 to a millionth", I(found.hi) - found.lo, fraction<N>(1, 1'000'000));
    }

    static constexpr int refinements = 3;
    const I U_, rho_;
};

}  // namespace

const char* check_layer(const Leaf& leaf, Log* log) { return judged<LayerRule>(leaf, log); }

const char* check_constant(unsigned bits, bool multiple, Log* log) {
    Leaf leaf;
    leaf.box.hi[0] = mpq_class(1, 1000);
    Big::precision = bits;
    for (int i = 0; i <= 4; ++i) {
        leaf.box.lo[1] = leaf.box.hi[1] = mpq_class(i, 20);
        if (const char* missing = multiple ? LayerRule<Big>(leaf, log).normalised_verdict()
                                           : LayerRule<double>(leaf, log).normalised_verdict())
            return missing;
    }
    return nullptr;
}

}  // namespace dumbbell_verify::law
