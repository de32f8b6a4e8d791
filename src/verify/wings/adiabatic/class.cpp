// A class of L35, and a leaf of its tree: the drift of S along the flights of a box (format-adiabatic.md,
// section 3).
#include "verify/machine/meter.hpp"
#include "verify/wings/adiabatic/check.hpp"

namespace dumbbell_verify::adiabatic {
namespace {

constexpr int class_parts = 64;  ///< of [-1, 1]

/// u: of the flight's upper contact; the slope is k = sigma sqrt(r).
template <class N>
class ClassCheck : Check<N> {
    using Base = Check<N>;
    using Base::fact, Base::leaf_, Base::m_, Base::quarter, Base::zero, Base::number;
    using typename Base::I;

  public:
    ClassCheck(const Leaf& leaf, Log* log)
        : Base(leaf, Masses<N>(Base::side(leaf.box, axis_delta)), log),
          J_(number(class_().J)),
          whole_u_(Base::side(axis_u)),
          u_(Base::cut(whole_u_)),
          sigma_(Base::side(axis_sigma)),
          k_(sigma_ * m_.root_r) {}

    /// nullptr if all is certified, else what is not.
    const char* verdict() {
        return (leaf_.part == Leaf::class_itself ? is_class()
                : leaf_.outside                  ? is_outside()
                                                 : is_bounded())
                   ? nullptr
                   : Base::failed();
    }

  private:
    [[nodiscard]] const Class& class_() const { return leaf_.terms->classes.at(leaf_.index); }

    /// Once for each class: no flight that it is about is steeper than 8 sqrt(r).
    bool is_class() {
        return Base::less("2 pi/sqrt(65) < J", I(4) * square(Base::half_turn), I(65) * square(J_));
    }

    bool is_outside() {
        if (Base::beyond("u beyond pi/2", whole_u_)) return true;
        if (!Base::reaches(u_)) return false;
        const auto [w, sine] = sin_cos_on(u_, quarter);
        const I x = quarter - u_;
        if (Base::less("no lower contact", sine, k_ * (Base::half_turn + x))) return true;
        if (Base::less("too steep for the upper contact", w, k_)) return true;
        N z = zero;
        const N from = lowest(0, z);
        z = zero;
        return Base::less("h < J sqrt(1 + sigma^2)", touch(from, highest(0, z)).h(-k_),
                          J_ * root(I(1) + square(sigma_)));
    }

    bool is_bounded() {
        if (!Base::reaches(u_)) return false;
        N below = zero, above = zero;  // guesses of the roots, from part to part
        N from = lowest(0, below);
        I drift = 0, potential = 0;
        for (int i = 0; i < class_parts; ++i) {
            if (!add_part(division(i), division(i + 1), touch(from, highest(i + 1, above)), drift, potential))
                return false;
            from = lowest(i + 1, below);
        }
        return Base::at_most("0 <= drift", I(0), drift) &&
               Base::at_most("drift <= potential", drift, root(I(1) + square(sigma_)) * potential);
    }
    /// The integrals of L34 and of the potential over [a, b], a part of [-1, 1]; the mean of 1 - lambda^2 is
    /// exact.
    bool add_part(const N& a, const N& b, const Touch<N>& at, I& drift, I& potential) {
        Meter::spend(1 << 14);
        const I l = I(a, b) * k_, gap = at.w - l, length = I(b) - a;
        if (!fact("w - l > 0", gap.lo > zero)) return false;
        const I mean = I(1) - (square(I(a)) + I(a) * b + square(I(b))) / I(3);
        const Rates rates = this->rates(at, gap);
        drift = drift + length * (rates.second * square(sigma_) * mean / I(2) + rates.first);
        potential = potential + length * I(class_().potential.least(quarter - at.x)) * at.F / gap;
        return true;
    }
    /// A' and B of L34, in terms of e = r/w^2.
    struct Rates {
        I second, first;
    };
    [[nodiscard]] Rates rates(const Touch<N>& at, const I& gap) const {
        const I &s = at.sine, &f = at.f, &F = at.F, &w = at.w, &rho = at.rho, &e = at.e;
        const I e1 = I(1) + e, square_e1 = square(e1), fF = f * F;
        const I part = (I(1) - e) / (square_e1 * at.square_w);
        const I n = fF * s * part;
        const I n_x = part * (w / rho * F * s + f * s + fF * w) +
                      I(2) * fF * square(s) * (I(1) - I(3) * e) / (e1 * square_e1 * w * at.square_w);
        return {(F * n_x + n * (I(1) + F * s / gap)) / square(gap),
                I(2) * fF * s / (gap * square_e1 * w * at.square_w) +
                    (F * (I(2) + m_.r) / (rho * (rho + w)) - at.asin_over_r) / (w * e1)};
    }

    /// lambda_i = 1 - 2 ((64 - i)/64)^3, exactly: finer where the contacts move fastest.
    [[nodiscard]] static N division(int i) {
        const I left = I(class_parts - i) / I(class_parts);
        return (I(1) - I(2) * left * left * left).lo;
    }
    /// The contact at X in [from, until]; no flight of the box has one beyond both.
    [[nodiscard]] Touch<N> touch(const N& from, const N& until) const {
        const I x = span(from, until);
        const auto [sine, cosine] = sin_cos_on(x, quarter);
        return {m_, x, sine, cosine};
    }
    /// The ray whose contact is X(lambda) for the flight of slope k from the upper contact at u.
    struct Line {
        I c, l;
    };
    [[nodiscard]] Line line(const N& u, const N& k, int i) const {
        const auto [w, sine] = sin_cos_on(I(u), quarter);
        const I x = quarter - u, l = I(division(i)) * I(k);
        return {sine - I(k) * (quarter + x) + l * quarter, l};
    }
    /// At most X(lambda_i): of the lowest upper contact and the greatest slope. z: a guess, before and after.
    [[nodiscard]] N lowest(int i, N& z) const {
        const Line at = line(u_.hi, k_.hi, i);
        if (!guess_root(at.c.lo, at.l.lo, z)) z = zero;
        return this->earliest({at.c.lo, at.l.lo, zero}, z).x;
    }
    /// At least X(lambda_i): that of the highest upper contact and the least slope, if the wall there is not
    /// flatter than that slope (else the line's least root is another one), or the upper contact.
    [[nodiscard]] N highest(int i, N& z) const {
        N most = (quarter - u_.lo).hi;
        if (!(sin_cos_on(I(u_.lo), quarter).sin.lo >= k_.lo)) return most;
        const Line at = line(u_.lo, k_.lo, i);
        if (!guess_root(at.c.hi, at.l.hi, z)) {
            z = zero;
            return most;
        }
        const auto contact = this->latest({at.c.hi, at.l.hi, zero}, z);
        return contact ? std::min(contact->x, most) : most;
    }

    const I J_, whole_u_, u_, sigma_, k_;
};

}  // namespace

const char* check_class(const Leaf& leaf, Log* log) { return judged<ClassCheck>(leaf, log); }

}  // namespace dumbbell_verify::adiabatic
