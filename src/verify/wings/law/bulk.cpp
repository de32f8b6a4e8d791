// A part of the bulk (format-law.md, section 3.2): steps of middle U >= 9/10, by the angle th of their
// flight, for all eps in [0, 1/1000] at once.
#include "verify/wings/law/rule.hpp"

namespace dumbbell_verify::law {
namespace {

/// At [alpha, alpha'] of a step, with Q at its middle: W(x) = sin(Q/cos x) is the clock's integrand, and its
/// derivative with Q is w(x) = cos(Q/cos x)/cos x.
template <class N>
class Clock {
    using I = Interval<N>;

  public:
    explicit Clock(const I& right_angle) : quarter_(right_angle) {}

    [[nodiscard]] I by_Q(const I& x, const I& Q) const {
        const I c = sin_cos_on(x, quarter_).cos;
        return -sin_cos_on(Q / c - quarter_, quarter_).sin / c;
    }
    [[nodiscard]] I W_second(const I& x, const I& Q) const {
        const auto [s, c] = sin_cos_on(x, quarter_);
        const I a = Q / c, t2 = square(s / c);
        const auto [sin_y, cos_y] = sin_cos_on(a - quarter_, quarter_);
        return -(cos_y * square(a) * t2) - sin_y * a * (I(2) * t2 + I(1));
    }
    /// The angle where Q/cos = pi, if has_last_angle(Q).
    [[nodiscard]] I last_angle() const { return pi<N>() / I(3) + spread(); }
    [[nodiscard]] bool has_last_angle(const I& Q) const {
        const I half = Q / pi<N>(), from = pi<N>() / I(3) + spread().lo, until = pi<N>() / I(3) + spread().hi;
        return half.hi <= sin_cos_on(from, quarter_).cos.lo && sin_cos_on(until, quarter_).cos.hi <= half.lo;
    }
    /// P = -tau_J at fixed alpha: the integral of -w over [x, last angle], by the values at the parts.
    [[nodiscard]] I P(const I& x, const I& Q, int parts) const {
        const I length = last_angle() - x;
        I sum = 0;
        for (int i = 0; i < parts; ++i) sum = sum - by_Q(x + length * part(i, parts), Q);
        return sum * length / I(parts);
    }
    /// tau_JJ at fixed alpha.
    [[nodiscard]] I second(const I& x, const I& Q) const {
        constexpr int parts = 8;
        const I length = last_angle() - x;
        I sum = 0;
        for (int i = 0; i < parts; ++i) {
            const I c = sin_cos_on(x + length * part(i, parts), quarter_).cos;
            sum = sum + sin_cos_on(Q / c - quarter_, quarter_).cos / square(c);
        }
        return pi<N>() / (Q * square_root(square(pi<N>()) - square(Q))) - sum * length / I(parts);
    }

  private:
    static I part(int i, int parts) { return {fraction<N>(i, parts).lo, fraction<N>(i + 1, parts).hi}; }
    static I spread() { return {fraction<N>(-1, 50000).lo, fraction<N>(1, 50000).hi}; }
    const I quarter_;
};

template <class N>
class BulkRule : Rule<N> {
    using Base = Rule<N>;
    using Base::fact, Base::less, Base::within, Base::quarter;
    using I = Interval<N>;

  public:
    BulkRule(const Leaf& leaf, Log* log) : Base(leaf, log) {}

    const char* verdict() {
        const I P = Clock<N>(quarter).P(Base::side(0), Q(), 24 * this->leaf_.states->parts);
        // All eps, in as many parts.
        constexpr int parts = 4;
        const I all = Base::between(this->leaf_.states->least_eps, this->leaf_.states->most_eps);
        for (int i = 0; i < parts; ++i) {
            const I share(fraction<N>(i, parts).lo, fraction<N>(i + 1, parts).hi);
            if (!is_bounded(I(all.lo) + (I(all.hi) - all.lo) * share, P)) return Base::failed();
        }
        return nullptr;
    }
    const char* window_verdict() { return is_in_window() ? nullptr : Base::failed(); }

  private:
    bool is_bounded(const I& eps, const I& P) {
        const auto [M, K, J] = defect(eps, P);
        const I th = Base::side(0), x = square(th), x2 = square(x), x4 = square(x2);
        const I p = fraction<N>(bulk_p[1]) * x + fraction<N>(bulk_p[2]) * x2 + fraction<N>(bulk_p[3]) * x4 +
                    fraction<N>(bulk_p[0]);
        const I slack = fraction<N>(bulk_slack[0]) + fraction<N>(bulk_slack[1]) * I(x4.lo);
        return fact("Q/cos = pi at pi/3 within 1/50000, and J/cos", Clock<N>(quarter).has_last_angle(J)) &&
               within("|D/((eps/2) (alpha' - alpha)) - p(th)| <= 0.006 + 0.75 th^8", M, p - slack,
                      p + slack) &&
               less("(J - J')/(eps^2 (alpha' - alpha)) in its range", K,
                    fraction<N>(most_fall.at(this->leaf_.range)), false);
    }
    static I not_negative(const I& x) { return {std::max(N(0), x.lo), std::max(N(0), x.hi)}; }

    [[nodiscard]] I Q() const {
        return quarter + Base::between(this->leaf_.states->least_Q, this->leaf_.states->most_Q);
    }

    struct Defect {
        I M, K, J;  ///< J: and Q, and all between
    };
    /// Every term is a power of eps times what is bounded at eps = 0: these powers are left out. P is that at
    /// th.
    [[nodiscard]] Defect defect(const I& eps, const I& P) const {
        const I th = Base::side(0), Q_ = Q();
        const auto [sine, cosine] = sin_cos_on(th, quarter);
        const I tangent = sine / cosine, F = Q_ / cosine, U = pi<N>() - F;
        const auto [sin_U, cos_U] = sin_cos_on(U, quarter);
        // sin d = eps t = x; asin x lies in x [1, 1 + (x^2/6) (1 + x^2)].
        const I t = tangent * F / sin_U, x = eps * t, x2 = square(x);
        const I grown(N(1), (I(1) + x2 / I(6) * (I(1) + x2)).hi), d1 = t * grown, d = eps * d1,
                                                                  d2 = square(d);
        const I cos_d = square_root(I(1) - x2);
        // sin u, sin u'; tan beta = eps/sin u and its cosine.
        const I w = sin_U * cos_d + cos_U * x, w_last = sin_U * cos_d - cos_U * x;
        const I tan2 = square(eps / w), tan2_last = square(eps / w_last);
        const I c = I(1) / square_root(I(1) + tan2), c_last = I(1) / square_root(I(1) + tan2_last);

        const I both = w * w_last, cc = c * c_last, doubles = sin_U * cos_U * t * cos_d * I(4);
        const I turn = square(cc) / (c + c_last) * doubles / square(both);  // (c - c')/eps^3
        const I lift = doubles * cc / (both * (w / c + w_last / c_last));   // (sin beta' - sin beta)/eps^2
        const I X_fall =
            I(2) * d1 *
            (square(t / sin_U) - fraction<N>(2, 3) * square(d1) * below_one(d2, fraction<N>(1, 5))) /
            (I(1) - square(x / sin_U));
        const I X_last =
            -(d1 * t * cos_U + square(d1) * sin_U * d / I(3) * below_one(d2, fraction<N>(1, 10))) / w_last;
        const I fall = cosine * (c * X_fall + square(eps) * X_last * turn) + Q_ * turn + sine * d1 * lift;
        const I A_last = cosine * c_last * X_last - Q_ * square(c_last / w_last) / (I(1) + c_last) -
                         sine * d1 * c_last / w_last;
        const I A = A_last + eps * fall;

        const auto angle = [](const I& sin_u, const I& tan2_beta) {  // beta/eps
            return below_one(tan2_beta, fraction<N>(1, 3)) / sin_u;
        };
        const I beta = angle(w, tan2), beta_last = angle(w_last, tan2_last), betas = beta + beta_last;
        const I W_part = clock_part(th, eps, beta, beta_last,
                                    {Q_, F, tangent, sin_U, cos_U, t, d1, d2, w, w_last, tan2, tan2_last});
        const Clock<N> clock(quarter);
        const I alpha = th - eps * beta, alpha_last = th + eps * beta_last, way = hull(alpha, alpha_last);
        const I size = up_to_size(hull(A, A_last)) * square(eps);
        const I J = Q_ + size, second = clock.second(way, J);  // at two places
        const I by_Q = clock.by_Q(way, Q_);  // P' as well, so that P at alpha' is P + (alpha' - th) by_Q
        const I defect = W_part - (P + eps * beta_last * by_Q) * fall + by_Q * betas * A +
                         eps * (second * square(A) - second * square(A_last)) / I(2);
        return {defect / betas, fall / betas, J};
    }

    struct Values {
        I Q, F, tangent, sin_U, cos_U, t, d1, d2, w, w_last, tan2, tan2_last;
    };
    /// The integral of W over [alpha, alpha'], less 2 eps, over eps^3.
    [[nodiscard]] I clock_part(const I& th, const I& eps, const I& beta, const I& beta_last,
                               const Values& s) const {
        const auto excess = [](const I& w, const I& tan2) {  // tan beta - beta
            return cube(I(1) / w) / I(3) * below_one(tan2, fraction<N>(3, 5));
        };
        const I spread = I(2) * s.cos_U * s.t / (s.w * s.w_last);  // tan beta' - tan beta
        const I most2(std::max(s.tan2.hi, s.tan2_last.hi));
        const I angles = spread * I((I(1) / (I(1) + most2)).lo, N(1));  // beta' - beta
        const I way = hull(th - eps * beta, th + eps * beta_last);
        return -(s.sin_U * (excess(s.w, s.tan2) + excess(s.w_last, s.tan2_last))) +
               s.sin_U * square(s.d1) / I(2) * below_one(s.d2, fraction<N>(1, 12)) *
                   (I(1) / s.w + I(1) / s.w_last) +
               s.cos_U * s.t * spread - s.cos_U * s.F * s.tangent * angles * (beta + beta_last) / I(2) +
               Clock<N>(quarter).W_second(way, s.Q) * (cube(beta) + cube(beta_last)) / I(6);
    }

    /// With J in pi/2 + [-1e-5, eps^2/4]: Q >= J, as A <= 0, so that sin d sin U <= eps F sqrt(F^2 - J^2)/J,
    /// and |A| <= cos th d^2 cot U + F beta^2/2 + d beta with d <= 1.001 sin d, beta <= eps/sin U, cos th <=
    /// (J + |A|)/F.
    bool is_in_window() {
        constexpr int parts = 700;
        const I J = quarter + I(fraction<N>(bulk_least_Q).lo, fraction<N>(1, 4'000'000).hi);
        const I least = fraction<N>(layer_U), length = quarter + fraction<N>(1, 1000) - least;
        if (!less("th < 0.7944 for U >= 9/10",
                  sin_cos_on(fraction<N>(bulk_angles.back()), quarter).cos * (pi<N>() - least), J))
            return false;
        for (int i = 0; i < parts; ++i) {
            const I share(fraction<N>(i, parts).lo, fraction<N>(i + 1, parts).hi), U = least + length * share;
            const I F = pi<N>() - U, R = square(F) - square(J), root = square_root(not_negative(R));
            const auto [s, c] = sin_cos_on(U, quarter);
            const I cosine = not_negative(c);
            const I d = fraction<N>(1001, 1000) * F * root / (J * s);
            const I A =
                (J + fraction<N>(1, 100)) / F * square(d) * cosine / s + F / (I(2) * square(s)) + d / s;
            if (!less("1.001 sin d < 1/10", d * fraction<N>(most_eps), fraction<N>(1, 10)) ||
                !less("|A|/eps^2 <= 20", A, 20, false))
                return false;
        }
        return true;
    }
};

}  // namespace

const char* check_bulk(const Leaf& leaf, Log* log) { return judged<BulkRule>(leaf, log); }

const char* check_bulk_window(unsigned bits, bool multiple, Log* log) {
    const Leaf leaf;
    Big::precision = bits;
    return multiple ? BulkRule<Big>(leaf, log).window_verdict()
                    : BulkRule<double>(leaf, log).window_verdict();
}

}  // namespace dumbbell_verify::law
