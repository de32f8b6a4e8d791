// A part of the end (format-law.md, section 3.3): the last contact, u_b = 2 d, and the tangent flight after
// it, for every eps in (0, 1/1000].
#include "verify/wings/law/rule.hpp"

namespace dumbbell_verify::law {
namespace {

template <class N>
class EndRule : Rule<N> {
    using Base = Rule<N>;
    using Base::fact, Base::less, Base::within, Base::quarter;
    using I = Interval<N>;
    using S = Slope<N>;

    /// The quantities of the end as functions of d.
    struct End {
        End(const Along<N>& along, const S& Q_) : Q(Q_) {
            const I at = along.U, d2 = square(at);
            const S d = along.line(0, 1), wave = along.sinc_of(1), double_wave = along.sinc_of(2);
            F = along.line(pi<N>(), I(-1));
            const S cosine = Q / F, sine = square_root(I(1) - square(cosine));
            // kappa = d^2 kh, and kh = (sinc^2 d + d^2 kh^2/4 [1, 1 + kappa^2])/F, again and again; at first
            // kh is in [0, 1/2], as rk, convex in kappa, is at most (pi/2 - 1) kappa, and kappa (2 pi - 2 d)
            // = 2 sin^2 d + rk.
            I k(N(0), fraction<N>(1, 2).hi), most = 1;
            for (int i = 0; i < 4; ++i) {
                most = I(N(1), (I(1) + square(d2 * k)).hi);
                k = meet(k, (square(sinc(at)) + d2 * square(k) / I(4) * most) / (pi<N>() - at));
            }
            above = along.curve(1, I(N(0), (d2 * square(k)).hi));
            const S lift = along.curve(0, square(k) / I(4) * most);  // rk/(2 d^2)
            kh = (square(wave) + lift) / F;
            epsh = kh * cosine / sine;
            const S b = epsh / (double_wave * I(2)), c = I(1) / square_root(I(1) + square(d * b));
            A = c * cosine * (wave / (along.cos_of(1) * I(2)) - I(1) + lift / (double_wave * I(2))) -
                Q * d * square(b * c) / (I(1) + c) - d * sine * b * c;
        }
        S Q, F, kh, epsh;  ///< eps = d^2 epsh
        S A;               ///< J - Q = d A
        S above;           ///< of [1, 1 + kappa^2]
    };

  public:
    EndRule(const Leaf& leaf, Log* log) : Base(leaf, log), d_(Base::side(0)) {}

    const char* verdict() { return is_beyond() || is_bounded() ? nullptr : Base::failed(); }

  private:
    bool is_beyond() {
        return less("1/1000 < d^2 epsh", fraction<N>(most_eps),
                    square(d_) * along_.values(End(along_, along_.line(quarter, window())).epsh));
    }

    bool is_bounded() {
        I q = window();
        for (int i = 0; i < refinements; ++i) q = meet(q, offset(End(along_, along_.line(quarter, q))));
        if (!less("(Q - pi/2)/d, its least and its most", I(q.lo), I(q.hi), false)) return false;
        const End end(along_, along_.line(quarter, q));
        const S share = end_defect(end);
        const I k0 = comparison_constant<N>();
        // The derivative of e_end/sqrt(eps) at d = 0 by L58.
        const I turn = -(square_root(square_root(I(3))) * (I(16) * q + I(7)) /
                         (I(36) * Base::half_turn * square_root(Base::half_turn)));
        const I surplus = (turn + d_ * share.bend) / square_root(along_.values(end.epsh));
        const I slack = fraction<N>(end_slack[0]) + fraction<N>(end_slack[1]) * I(d_.lo);
        return within("e_end/sqrt(eps) = k0 at d = 0", k0, I(share.zero.lo), I(share.zero.hi)) &&
               within("|(e_end - k0 sqrt(eps))/eps + 0.1657| <= 0.003 + 0.5 d", surplus,
                      fraction<N>(end_surplus) - slack, fraction<N>(end_surplus) + slack);
    }

    /// (Q - pi/2)/d, to begin with (L53).
    static I window() { return {fraction<N>(end_least_Q).lo, fraction<N>(end_most_Q).hi}; }
    /// (Q - pi/2)/d, as Q = J - A and u_b = 2 d.
    [[nodiscard]] I offset(const End& end) const {
        const I e2 = square(along_.values(end.epsh));
        return I(-(Base::drift() * e2 / I(8)).hi, (cube(d_) * e2 * Base::rise()).hi) - along_.values(end.A);
    }

    /// e_end/sqrt(eps).
    [[nodiscard]] S end_defect(const End& end) const {
        const S d = along_.line(0, 1), cos_d = along_.cos_of(1), sin_d = d * along_.sinc_of(1);
        const Moments<N> moments(along_);
        const I size = up_to_size(along_.values(end.A));
        const S me = middle_error(along_, sin_d, cos_d, end.F, end.Q, I(1)) +
                     moments.way_H(2, end.Q, this->leaf_.states->parts) * end.A * I(4) +
                     d * square(end.A) * (moments.second_order(2, end.Q + along_.line(0, size)) * I(2));
        const S root = square_root(end.epsh);
        return me / (end.epsh * root * I(2)) - d * end.kh * end.above / (end.F * root * I(4));
    }

    static constexpr int refinements = 3;
    const I d_;
    const Along<N> along_{d_};
};

}  // namespace

const char* check_end(const Leaf& leaf, Log* log) { return judged<EndRule>(leaf, log); }

}  // namespace dumbbell_verify::law
