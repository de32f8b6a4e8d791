// A part of the end (format-law.md, section 3.3): the last contact, u_b = 2 d, and the tangent flight after
// it, for every eps in (0, 1/1000].
#include "verify/law/rule.hpp"

namespace dumbbell_verify::law {
namespace {

template <class N>
class EndRule : Rule<N> {
    using Base = Rule<N>;
    using Base::fact, Base::less, Base::within, Base::quarter;
    using I = Interval<N>;
    using S = Slope<N>;

    /// The quantities of the end as functions of d, for all Q of a form.
    template <template <class> class Form>
    struct End {
        using T = Form<N>;
        End(const Along<N, Form>& along, const T& Q_) : Q(Q_) {
            const I at = values_of(along.U), d2 = square(at);
            const T d = along.line(0, I(1)), wave = along.sinc_of(1), double_wave = along.sinc_of(2);
            F = along.line(pi<N>(), I(-1));
            const T cosine = Q / F, sine = square_root(I(1) - square(cosine));
            // kappa = d^2 kh, and kh = (sinc^2 d + d^2 kh^2/4 [1, 1 + kappa^2])/F, again and again; at first
            // kh is in [0, 1/2], as rk, convex in kappa, is at most (pi/2 - 1) kappa, and kappa (2 pi - 2 d)
            // = 2 sin^2 d + rk.
            I k(N(0), fraction<N>(1, 2).hi);
            for (int i = 0; i < 4; ++i) {
                above = I(N(1), (I(1) + square(d2 * k)).hi);
                k = common(k, (square(sinc(at)) + d2 * square(k) / I(4) * values_of(above)) / (pi<N>() - at));
            }
            const T lift = along.line(0, at * square(k) / I(4) * above);  // rk/(2 d^2)
            kh = (square(wave) + lift) / F;
            epsh = kh * cosine / sine;
            const T b = epsh / (double_wave * I(2)), c = I(1) / square_root(I(1) + square(d * b));
            A = c * cosine * (wave / (along.cos_of(1) * I(2)) - I(1) + lift / (double_wave * I(2))) -
                Q * d * square(b * c) / (I(1) + c) - d * sine * b * c;
        }
        T Q, F, kh, epsh;                             ///< eps = d^2 epsh
        T A;                                          ///< J - Q = d A
        typename Along<N, Form>::Factor above{I(1)};  ///< [1, 1 + kappa^2]
    };

  public:
    EndRule(const Leaf& leaf, Log* log) : Base(leaf, log), d_(Base::side(0)) {}

    const char* verdict() { return is_beyond() || is_bounded() ? nullptr : Base::failed(); }

  private:
    bool is_beyond() {
        const Along<N, Interval> along{d_};
        return less("1/1000 < d^2 epsh", fraction<N>(most_eps),
                    square(d_) * End<Interval>(along, along.line(quarter, window())).epsh);
    }

    bool is_bounded() {
        const Along<N, Slope> along{d_};
        I q = window();
        for (int i = 0; i < refinements; ++i)
            q = common(q, offset(along, End<Slope>(along, along.line(quarter, q))));
        if (!less("(Q - pi/2)/d, its least and its most", I(q.lo), I(q.hi), false)) return false;
        const End<Slope> end(along, along.line(quarter, q));
        const S share = end_defect(along, end), root = square_root(end.epsh);
        const I k0 = comparison_constant<N>();
        return within("e_end/sqrt(eps) = k0 at d = 0", k0, I(share.zero.lo), I(share.zero.hi)) &&
               within("-0.23 <= (e_end - k0 sqrt(eps))/eps <= -0.0885",
                      share.rise / values_of(along.values(root)), fraction<N>(-23, 100),
                      fraction<N>(-885, 10'000));
    }

    /// (Q - pi/2)/d, to begin with (L53).
    static I window() { return {fraction<N>(-1, 10).lo, fraction<N>(3, 5).hi}; }
    /// (Q - pi/2)/d, as Q = J - A and u_b = 2 d.
    template <class Along, class End>
    [[nodiscard]] I offset(const Along& along, const End& end) const {
        const I e2 = values_of(square(along.values(end.epsh)));
        return I(-(Base::drift() * e2 / I(8)).hi, (cube(d_) * e2 * Base::rise()).hi) -
               values_of(along.values(end.A));
    }

    /// e_end/sqrt(eps).
    [[nodiscard]] S end_defect(const Along<N, Slope>& along, const End<Slope>& end) const {
        const S d = along.line(0, I(1)), cos_d = along.cos_of(1), sin_d = d * along.sinc_of(1);
        const Moments<N, Slope> moments(along, end.Q, end.Q);
        const auto size = up_to_size(along.values(end.A)) * along.U;
        const S me = middle_error(along, sin_d, cos_d, end.F, end.Q, I(1)) +
                     moments.over_way(2, 2 * this->leaf_.states->parts).H * end.A * I(4) +
                     d * square(end.A) * (moments.second_order(2, along.values(end.Q) + size) * I(2));
        const S root = square_root(end.epsh);
        return me / (end.epsh * root * I(2)) - d * end.kh * end.above / (end.F * root * I(4));
    }

    static constexpr int refinements = 3;
    const I d_;
};

}  // namespace

const char* check_end(const Leaf& leaf, Log* log) { return judged<EndRule>(leaf, log); }

}  // namespace dumbbell_verify::law
