// A leaf of the layer (format-law.md, section 3.1): steps of middle U <= 9/10 and half-length rho U, for
// every eps in (0, 1/1000].
#include "verify/wings/law/rule.hpp"

namespace dumbbell_verify::law {
namespace {

/// The quantities of a step (law.md) as functions of U, for all rho of an interval. What is 1 at U = 0 has no
/// factors of rho that cancel there.
template <class N>
struct LayerStep {
    using I = Interval<N>;
    using S = Slope<N>;

    LayerStep(const Along<N>& along, const I& rho_, const S& Q_) : rho(rho_), Q(Q_) {
        const S U = along.line(0, 1), d = along.line(0, rho);
        const S wave_d = along.sinc_of(rho), wave_U = along.sinc_of(1);
        const S wave_first = along.sinc_of(plus), wave_last = along.sinc_of(minus);
        cos_U = along.cos_of(1);
        sin_U = U * wave_U;
        F = along.line(pi<N>(), I(-1));
        const S cosine = Q / F, sine = square_root(I(1) - square(cosine));
        ehat = wave_d * wave_U * cosine / (sine * F);
        // tan beta = d b before the step, d b' after it; c, c' the cosines of beta.
        const S b = ehat / (plus * wave_first), b_last = ehat / (minus * wave_last);
        const S c = I(1) / square_root(I(1) + square(d * b));
        const S c_last = I(1) / square_root(I(1) + square(d * b_last));
        const S waves = wave_first * wave_last * product;
        const S doubles = ehat * (wave_U * cos_U) * (wave_d * along.cos_of(rho)) * I(4);
        const S kc = square(c * c_last) / (c + c_last) * doubles * ehat / square(waves);
        const S ks =
            doubles * c * c_last / (waves * (plus * (wave_first / c) + minus * (wave_last / c_last)));

        // X - X' = (2 d^3/U^2) fall/(1 - rho^2), X' = -(d^2/U) fall_last/(1 - rho): both are 1 at U = 0.
        const S ratio = square(wave_d / wave_U);
        const I d2 = square(rho * along.U);
        const S lost = along.curve(0, fraction<N>(2, 3) * below_one(d2, fraction<N>(1, 5)));
        const S fall = (ratio - lost) / (I(1) - (ratio - I(1)) * (square(rho) / product));
        const S fall_last =
            (cos_U * wave_d + along.times(sin_U * d, below_one(d2, fraction<N>(1, 10)) / I(3))) / wave_last;
        const S more = Q * kc + sine * ks - cosine * fall_last * d * kc * (rho / minus);
        const S kick = Q * square(b_last * c_last) / (I(1) + c_last) + sine * b_last * c_last;
        const S first_fall = c * fall, last_fall = c_last * fall_last;
        change = I(2) * (cosine * first_fall) + U * more * product;
        last = -(cosine * last_fall / minus) - U * kick;
        first = last + change * (rho / product);
        apart =
            cosine * along.line(0, (first_fall.bend - last_fall.bend) / minus) + more * (plus / I(2)) - kick;
    }

    I rho, plus = I(1) + rho, minus = I(1) - rho, product = I(1) - square(rho);
    S Q;
    S sin_U, cos_U, F;
    S ehat;         ///< eps = rho U^2 ehat
    S change;       ///< A - A' = (d^3/U^2) change/(1 - rho^2)
    S first, last;  ///< A, A' = (d^2/U) first, last
    S apart;        ///< last + change/(2 (1 - rho)) = U apart
};

template <class N>
class LayerRule : Rule<N> {
    using Base = Rule<N>;
    using Base::fact, Base::less, Base::within, Base::quarter;
    using I = Interval<N>;
    using S = Slope<N>;
    using Step = LayerStep<N>;

  public:
    LayerRule(const Leaf& leaf, Log* log) : Base(leaf, log), along_{Base::side(0)}, rho_(Base::side(1)) {}

    const char* verdict() {
        const bool holds = this->leaf_.rule == Leaf::beyond ? is_beyond() : is_bounded();
        return holds ? nullptr : Base::failed();
    }
    /// Whether at U = 0, for this rho, D/D0(T) is 1, which takes the right k0.
    const char* normalised_verdict() { return is_normalised() ? nullptr : Base::failed(); }

  private:
    bool is_beyond() {
        const Step step(along_, rho_, along_.line(Base::crude_Q(), 0));
        return less("1/1000 < rho U^2 ehat", fraction<N>(most_eps),
                    rho_ * square(along_.U) * along_.values(step.ehat));
    }

    bool is_bounded() {
        I q = offset(Step(along_, rho_, along_.line(Base::crude_Q(), 0)));
        for (int i = 0; i < refinements; ++i) q = meet(q, offset(Step(along_, rho_, offset_by(q))));
        if (!less("(Q - pi/2)/(rho^2 U), its least and its most", I(q.lo), I(q.hi), false)) return false;
        const Step step(along_, rho_, offset_by(q));
        const Roots roots(*this, step);
        if (!less("0 < ((1 + rho)^2 k1 - 2 rho ehat)/((1 - rho)^2 ehat/2)", 0, along_.values(roots.rest)))
            return false;
        const S ratio = defect_ratio(step, roots);
        // By L57 (D/D0(T))' at U = 0 is -5/(3 pi) - rho^2 turn. With y = U v: (1 - D/D0(T))/U - 5 v/(3 pi) =
        // rho^2 turn + U bend.
        const I gamma = fraction<N>(5, 3) / pi<N>(),
                turn = (I(12) * q - I(1) / step.minus) / (I(3) * pi<N>());
        const I slope = ratio.first + gamma + square(rho_) * turn;
        const S v = roots.half * square_root(step.ehat * (square_root(I(3)) * pi<N>()));
        const I v_at = along_.values(v), bend = -(ratio.bend + gamma * v.rise);
        const I by_rho = rho_ * turn / v_at, by_U = bend / v_at,
                spread = I(1) / square(along_.values(roots.half));
        const I drift = along_.values(step.change) / (square(along_.values(step.ehat)) * step.product * I(2));
        // x = (1 - D/D0(T))/y - 5/(3 pi) beyond a y + b (T^(1/2) - (T - 1)^(1/2))^2, on the side of the sign.
        const auto bounded = [&](const char* what, const std::array<Ratio, 2>& a_b, int sign) {
            const auto& [a, b] = a_b;
            const I by_r = (by_rho - fraction<N>(b) * spread) * I(sign);
            const I by_u = (by_U - fraction<N>(a) * v_at) * I(sign), sum = rho_ * by_r + along_.U * by_u;
            if (this->log_)
                this->log_->line({{"  ", rho_ * by_rho + along_.U * by_U}, {", beyond by ", sum}});
            return fact(what, (by_r.lo >= N(0) && by_u.lo >= N(0)) || sum.lo >= N(0));
        };
        return within("D/D0(T) = 1 at U = 0", 1, I(ratio.zero.lo), I(ratio.zero.hi)) &&
               within("its derivative there, less that of L57, is 0", 0, I(slope.lo), I(slope.hi)) &&
               bounded("(1 - D/D0(T))/y - 5/(3 pi) is not too small", layer_least, 1) &&
               bounded("(1 - D/D0(T))/y - 5/(3 pi) is not too large", layer_most, -1) &&
               less("a/(2 ehat^2) <= 15.9", drift, fraction<N>(most_drift), false);
    }

    /// (J - pi/2)/(U rho^2), from its window; eps = rho U^2 ehat.
    [[nodiscard]] I J_offset(const Step& step) const {
        const I e2 = square(along_.values(step.ehat));
        return {-(Base::drift() * e2 / cube(step.plus)).hi, (cube(along_.U) * e2 * Base::rise()).hi};
    }
    /// (Q - pi/2)/(U rho^2), as Q = J - A.
    [[nodiscard]] I offset(const Step& step) const { return J_offset(step) - along_.values(step.first); }
    [[nodiscard]] S offset_by(const I& q) const { return along_.line(quarter, square(rho_) * q); }

    /// With 2 k1 = ehat k: half is the mean of (1 + rho) k^(1/2) and (1 - rho) rest^(1/2), so that (T^(1/2) -
    /// (T - 1)^(1/2))^2 = rho/half^2. All are 1 at U = 0.
    struct Roots {
        S rest, half;
        Roots(const LayerRule& rule, const Step& step) {
            // Q + A: L57 knows its derivative at U = 0 by that of Q.
            const S J = step.Q + rule.along_.line(0, square(step.rho)) * step.first;
            S k = Moments<N>(rule.along_).way_G(step.plus, J, rule.leaf_.states->parts) / step.ehat * I(2);
            k.zero = meet(k.zero, I(1));
            rest = (k - I(1)) * square(step.plus / step.minus) + I(1);
            half = (square_root(k) * step.plus + square_root(rest) * step.minus) / I(2);
            half.zero = meet(half.zero, I(1));
        }
    };

    /// D/D0(T), with D0(T) = k0 eps^(1/2) (T^(1/2) - (T - 1)^(1/2))^3.
    [[nodiscard]] S defect_ratio(const Step& step, const Roots& roots) const {
        const Moments<N> moments(along_);
        const S way = moments.way_H(step.plus, step.Q, this->leaf_.states->parts),
                mean = moments.step_H(rho_, step.Q);
        // (mean - 2 (1 + rho) way)/(1 - rho) begins with f(0) + (4/3) U f'(0).
        S both = (mean - way * (step.plus * I(2))) / step.minus;
        const S R = square(pi<N>()) - square(step.Q), r3 = I(1) / (R * square_root(R));
        const S at0 = r3 * pi<N>(), turn = r3 / R * (I(3) * square(pi<N>())) - r3;
        const S start = at0 + along_.line(0, fraction<N>(4, 3)) * turn;
        both.zero = meet(both.zero, start.zero);
        both.first = meet(both.first, start.first);
        const S E1 = middle_error(along_, step.sin_U, step.cos_U, step.F, step.Q, rho_);
        // Second order in A: between Q and Q + A.
        const auto second = [&](const S& A, const I& p) {
            const I size = up_to_size(along_.values(A)) * square(rho_);
            return square(A) * moments.second_order(p, step.Q + along_.line(0, size)) * square(p);
        };
        const S E2 =
            along_.line(0, 1) * along_.tight(mean) * along_.tight(step.apart) -
            along_.tight(step.change) * along_.tight(both) / I(2) +
            along_.line(0, rho_) * (second(step.first, step.plus) - second(step.last, step.minus)) / I(2);
        return along_.tight(E1 + E2) * cube(along_.tight(roots.half)) / (step.ehat * square_root(step.ehat)) /
               (comparison_constant<N>() * I(2));
    }

    bool is_normalised() {
        const Step step(along_, rho_, offset_by(0));
        const I found = defect_ratio(step, Roots(*this, step)).zero;
        return within("D/D0(T) = 1 at U = 0", 1, I(found.lo), I(found.hi)) &&
               less("D/D0(T) at U = 0 to a millionth", I(found.hi) - found.lo, fraction<N>(1, 1'000'000));
    }

    static constexpr int refinements = 3;
    const Along<N> along_;
    const I rho_;
};

}  // namespace

const char* check_layer(const Leaf& leaf, Log* log) { return judged<LayerRule>(leaf, log); }

const char* check_constant(unsigned bits, bool multiple, Log* log) {
    Leaf leaf;
    leaf.box.hi[0] = mpq_class(1, 1000);
    Big::precision = bits;
    for (int i = 0; i <= 4; ++i) {
        leaf.box.lo[1] = leaf.box.hi[1] = mpq_class(i, 20);
        const char* missing = checked([&] {
            return multiple ? LayerRule<Big>(leaf, log).normalised_verdict()
                            : LayerRule<double>(leaf, log).normalised_verdict();
        });
        if (missing) return missing;
    }
    return nullptr;
}

}  // namespace dumbbell_verify::law
