// The section `turning` of the scene dumbbell: its charts bridge (L8) and light (L9), and the witness (L11).
// The box is rounded outwards to numbers N, r to [r_lo, r_hi]: what holds for a larger box holds for the box.
#include "verify/core/big.hpp"
#include "verify/core/ray.hpp"
#include "verify/core/section.hpp"

namespace dumbbell_verify {
namespace {

enum { bridge, light };

template <class N>
class Turning : Rays<N> {
    using Base = Rays<N>;
    using Base::at_least, Base::at_most, Base::fact, Base::less;
    using Base::half_turn, Base::one, Base::quarter, Base::zero;
    using typename Base::I, typename Base::Ray;

  public:
    Turning(const Leaf& leaf, Log* log) : Base(log), leaf_(leaf) {
        if (log) log->box(leaf, turning().charts[leaf.chart], bits(zero));
    }

    /// nullptr if all that format.md demands of the leaf is certified, else what is not.
    const char* verdict() {
        if (!(r_lo > zero)) return "r is out of the range of this precision";
        if (leaf_.opcode == outside) return is_outside() ? nullptr : "a reason of `outside`";
        return holds() ? nullptr : Base::failed();
    }

  private:
    bool holds() {
        switch (leaf_.opcode) {
            case count_leaf:
                return fact("1 + a + b <= U", 1 + leaf_.a + leaf_.b <= leaf_.claimed) &&
                       (leaf_.chart == bridge ? bridge_counts() : light_counts());
            case meets:
                return bridge_meets(y1);
            case meets_reversed:
                return reversed_meets();
            case equal_masses:
                return fact("A = B = 1", leaf_.box.lo[2] == 1 && leaf_.box.hi[2] == 1) &&
                       fact("2 <= U", leaf_.claimed >= 2);
            default:
                return witness_counts();
        }
    }

    [[nodiscard]] Ray bridge_ray(Round d, const N& e, const N& eta) const {
        const auto [s, w] = sin_cos(e);
        const N& r = d == down ? r_lo : r_hi;
        const I slope = w + eta, c = r * (s + slope * (half_turn - e)), kappa = r * slope;
        return d == down ? Ray{std::max(zero, c.lo), kappa.lo, r} : Ray{c.hi, kappa.hi, r};
    }
    /// sigma X in units of r: c/r and lambda = kappa/r, with eta' computed at r.
    [[nodiscard]] std::pair<I, I> bridge_reversed(const N& e, const N& eta, const N& r) const {
        const auto [s, w] = sin_cos(e);
        const I top = I(1) + r * w * w, lambda = eta * top / (top + I(2) * r * w * eta) - w;
        return {s + lambda * e, lambda};
    }
    /// Bound of sigma X for all r in [r_lo, r_hi]: eta' decreases with r (L8 (b)); the ray (r c, r lambda)
    /// with that c and lambda is the lowest at r_lo and the highest at r_hi, for lambda < 0 by L10, where c
    /// <= 1.
    [[nodiscard]] Ray bridge_reversed_ray(Round d, const N& e, const N& eta) const {
        const auto [height, slope] = bridge_reversed(e, eta, d == down ? r_hi : r_lo);
        const N lambda = std::max(-one, d == down ? slope.lo : slope.hi), &r = d == down ? r_lo : r_hi;
        const N c = std::max(zero, d == down ? height.lo : height.hi);
        return {mul(d, r, lambda < zero ? std::min(c, one) : c), mul(d, r, lambda), r};
    }
    /// The least c and kappa of X are at the greatest e (they still decrease just behind pi/2), of sigma X at
    /// the least.
    bool bridge_counts() {
        return at_most("G <= a for X", bridge_ray(down, std::min(e1, quarter.hi), y0), leaf_.a) &&
               at_most("G <= b for sigma X", bridge_reversed_ray(down, std::min(e0, quarter.lo), y0),
                       leaf_.b);
    }
    bool witness_counts() {
        return less("0 < e", zero, e0) && less("e < pi/2", e1, quarter) && less("0 < eta", zero, y0) &&
               less("r_hi (cos e + eta) < 1", r_hi * (sin_cos(e0).cos + y1), one) &&
               less("0 < sin e + (eta' - cos e) e", zero, bridge_reversed(e0, y0, r_hi).first) &&
               fact("V <= 1 + a + b", leaf_.claimed <= 1 + leaf_.a + leaf_.b) &&
               at_least("a <= G for X", bridge_ray(up, e0, y1), leaf_.a) &&
               at_least("b <= G for sigma X", bridge_reversed_ray(up, e1, y1), leaf_.b);
    }

    bool is_outside() {
        if (less("pi/2 < e0", quarter, e0)) return true;
        if (fact("1 <= r_lo eta0 (or lambda0), exactly", leaf_.box.lo[1] >= leaf_.box.hi[2])) return true;
        if (leaf_.chart == bridge || !less("e1 < pi/2", e1, quarter)) return false;
        const I w = sin_cos(e1).cos;
        return less("2 w1 < lambda0 (w1^2 - r_hi)", I(2) * w, y0 * (w * w - r_hi));
    }
    /// All rays r slope from R at e <= e1 < pi/2 meet the bridge.
    bool bridge_meets(const N& slope) {
        const N t = guess_top(slope, quarter.lo);
        return less("e1 < pi/2", e1, quarter) && less("0 < t", zero, t) && less("t < pi", t, half_turn) &&
               less("sin(e1)/r_lo + slope (e1 + t) < sin t", sin_cos(e1).sin / r_lo + slope * (I(e1) + t),
                    sin_cos(t).sin);
    }
    [[nodiscard]] I reversed_divisor(const I& w, const N& lambda, const N& r_product, const N& r) const {
        return w * w + I(2) * r_product * lambda * w - r;
    }
    [[nodiscard]] I mu(const I& w, const N& lambda, const N& r) const {
        return (I(2) * w + I(r) * lambda - lambda * w * w) / reversed_divisor(w, lambda, r, r);
    }
    bool reversed_meets() {
        if (!less("e1 < pi/2", e1, quarter)) return false;
        const I w = sin_cos(e1).cos;
        return less("0 < D1", zero, reversed_divisor(w, y0, r_lo, r_hi)) &&
               bridge_meets(std::max(zero, mu(w, y0, r_hi).hi));
    }
    bool light_counts() {
        const N e = std::min(e0, quarter.lo);
        const auto [s, w] = sin_cos(e);
        const auto ray = [&, &s = s](const N& slope) {
            const I kappa = I(r_lo) * slope;
            return Ray{(s + kappa * (half_turn + e)).lo, kappa.lo, r_lo};
        };
        if (!at_most("G <= a for X", ray(y0), leaf_.a)) return false;
        if (less("w0^2 + 2 r_hi lambda1 w0 - r_lo <= 0", reversed_divisor(w, y1, r_hi, r_lo), zero, false))
            return true;
        return less("0 < D0", zero, reversed_divisor(w, y1, r_lo, r_lo)) &&
               at_most("G <= b for sigma X", ray(std::max(zero, mu(w, y1, r_lo).lo)), leaf_.b);
    }

    const Leaf& leaf_;
    const N e0 = bound(down, leaf_.box.lo[0], zero), e1 = bound(up, leaf_.box.hi[0], zero);
    const N y0 = bound(down, leaf_.box.lo[1], zero), y1 = bound(up, leaf_.box.hi[1], zero);
    const N r_lo = bound(down, 1 / leaf_.box.hi[2], zero), r_hi = bound(up, 1 / leaf_.box.lo[2], zero);
};

/// The section lies in e <= pi/2 < 2, and eta, lambda < q (r eta < 1): at most the least power of two >= B.
Box root(std::size_t, const mpq_class& a, const mpq_class& b) { return {{0, 0, a}, {2, power_of_two(b), b}}; }

const char* check(const Leaf& leaf, Log* log) { return judged<Turning>(leaf, log); }

}  // namespace

const Section& turning() {
    static const Section section = {"1",
                                    "dumbbell",
                                    "turning",
                                    "bridge",
                                    {{"bridge", {"e", "eta", "q"}}, {"light", {"e", "lambda", "q"}}},
                                    {{"count", Place::leaf, 3, 2},
                                     {"outside", Place::leaf, 3, 0},
                                     {"meets", Place::leaf, 2, 0},
                                     {"meets-reversed", Place::leaf, 2, 0},
                                     {"equal-masses", Place::cover, 3, 0},
                                     {"witness", Place::witness, 1, 2}},
                                    root,
                                    check};
    return section;
}

}  // namespace dumbbell_verify
