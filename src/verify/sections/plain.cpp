// The section plain (format-sections.md, section 2; L16): interval evaluation of all states of a box
// together. A file spells it `lemmas minimal`, `section full`.
#include "verify/core/big.hpp"
#include "verify/functions/angle.hpp"
#include "verify/sections/bridge.hpp"

namespace dumbbell_verify {
namespace {

template <class N>
class Plain : Bridge<N> {
    using Base = Bridge<N>;
    using Base::fact, Base::trig, Base::half_turn, Base::quarter, Base::one, Base::zero, Base::leaf_;
    using Base::x0, Base::x1, Base::y0, Base::y1, Base::r_lo, Base::r_hi;
    using typename Base::I, typename Base::Ray;

  public:
    Plain(const Leaf& leaf, Log* log) : Base(leaf, plain(), log) {}

    const char* verdict() {
        if (!(r_lo > zero)) return "r is out of the range of this precision";
        if (leaf_.opcode == outside)
            return Base::is_outside(leaf_.chart != departure) ? nullptr : "a reason of `outside`";
        if (leaf_.opcode == once_leaf) return Base::once() ? nullptr : Base::failed();
        const bool holds = fact("1 + a <= U", 1 + leaf_.a <= leaf_.claimed) &&
                           (leaf_.chart == contact ? contacts() : departures());
        return holds ? nullptr : Base::failed();
    }

  private:
    /// Enclosures over all states in play: a flight that leaves a wall at corner distance x, or a ray.
    struct State {
        I x, sine, kappa;
    };

    /// Of two enclosures of the same thing.
    static I meet(const I& a, const I& b) { return {std::max(a.lo, b.lo), std::min(a.hi, b.hi)}; }
    [[nodiscard]] I not_negative(const I& a) const { return {std::max(zero, a.lo), std::max(zero, a.hi)}; }
    /// Of sine and cosine on [t.lo, t.hi] within [0, pi].
    [[nodiscard]] SinCos<I> over(const I& t) const {
        const auto a = trig(t.lo), b = trig(t.hi);
        I sine = hull(a.sin, b.sin);
        if (t.lo <= quarter.hi && quarter.lo <= t.hi) sine.hi = one;
        return {sine, {b.cos.lo, a.cos.hi}};
    }

    bool contacts() {
        // The end pi of the chart: sine 0, cosine -1.
        const bool end = !(x1 < half_turn.lo);
        const I t(std::min(x0, half_turn.lo), end ? half_turn.lo : x1);
        SinCos<I> at = over(t);
        I rest = half_turn - t;
        if (end) at.sin.lo = std::min(zero, at.sin.lo), at.cos.lo = -one, rest.lo = zero;
        rest = not_negative(rest);
        const I lambda = at.cos + I(y0, y1);
        return plain_count(not_negative(r * (at.sin + lambda * rest)), r * lambda, 0);
    }
    /// Certified: rays (c, kappa) have at most a - n later collisions with the light walls.
    bool plain_count(I c, I kappa, mpz_class n) {
        State state;
        for (N z = zero, z_high = zero;; ++n) {
            log(n, kappa);
            if (kappa.lo >= one) return fact("steep", true);
            kappa.hi = std::min(one, kappa.hi);
            if (const auto done = wall(state, c, kappa, n, z, z_high)) return *done;
            kappa = state.kappa;
            c = height(state);
        }
    }
    [[nodiscard]] I height(const State& s) const {
        return not_negative(s.sine + s.kappa * (s.x + half_turn));
    }

    bool departures() {
        State state;
        const bool end = !(x1 < quarter.lo);
        state.x = {std::min(x0, quarter.lo), end ? quarter.hi : x1};
        const auto low = sin_cos(state.x.lo), high = end ? SinCos<I>{I(1), I(0)} : sin_cos(x1);
        state.sine = {low.sin.lo, std::min(one, high.sin.hi)};
        state.kappa = I(y0, y1) - I(high.cos.lo, low.cos.hi);
        mpz_class n = 0;
        for (N z = zero, z_high = zero;; ++n) {
            log(n, state.kappa);
            if (state.kappa.lo >= one) return fact("steep", true);
            state.kappa.hi = std::min(one, state.kappa.hi);
            if (const auto done = bridge(state, n)) return *done;
            const I c = height(state), kappa = state.kappa;
            if (const auto done = wall(state, c, kappa, n, z, z_high)) return *done;
        }
    }

    /// The collision of rays (c, kappa) with a wall, after n others: the state after it, or the answer.
    std::optional<bool> wall(State& state, const I& c, const I& kappa, const mpz_class& n, N& z, N& z_high) {
        Work::collision();
        const Ray low{c.lo, kappa.lo, r_lo}, high{c.hi, kappa.hi, r_hi};
        const bool seems_to_hit = guess_root(low.c, low.kappa, z);
        if ((!seems_to_hit || n == leaf_.a) && Base::misses(low)) return fact("misses the wall", true);
        if (!fact("n + 1 <= a at the wall", n + 1 <= leaf_.a)) return false;
        const auto first = Base::earliest(low, z);
        state.x = {first.x, quarter.hi};
        state.sine = {std::max(zero, first.sine), one};
        I w(std::max(zero, kappa.lo), first.cosine);
        if (high.kappa < one && guess_root(high.c, high.kappa, z_high))
            if (const auto last = Base::latest(high, z_high)) {
                state.x.hi = std::min(last->x, quarter.hi);
                state.sine.hi = std::min(one, last->sine);
                w.lo = std::max(w.lo, last->cosine);
            }
        const I ww = square(w), D = meet(ww - I(2) * kappa * w - r, w * (w - I(2) * kappa) - r);
        if (D.hi <= zero) return fact("none returns", true);
        const I top = meet(kappa * ww + r * (I(2) * w - kappa), kappa * (ww - r) + I(2) * r * w);
        I next = top / D;
        if (!(D.lo > zero)) {
            if (!fact("0 < numerator, where D may be 0", top.lo > zero)) return false;
            next = {div(down, top.lo, D.hi), one};
        }
        if (w.lo > zero) {
            const I A = (w - r / w) / I(2), p = A - kappa;
            if (p.lo > zero)
                next = meet(meet(next, (square(A) + r) / p - A), kappa + (r + square(kappa)) / p);
        }
        state.kappa = next;
        return std::nullopt;
    }

    /// Contacts with the bridge, after n other collisions. Nothing if flights go on that did not meet it.
    std::optional<bool> bridge(const State& state, const mpz_class& n) {
        const I h = not_negative(state.sine + state.kappa * state.x), kappa = state.kappa;
        if (Base::certainly_above(h.lo, kappa.lo)) return std::nullopt;
        const auto met = Base::contacts(kappa.lo, h.hi, kappa.hi);
        if (!fact("n + 1 <= a at the bridge", n + 1 <= leaf_.a)) return false;
        const N last = std::min(met.last, half_turn.lo);
        const I t(std::min(first_contact(h.lo, kappa.lo), last), last);
        SinCos<I> at = over(t);
        I rest = half_turn - t;
        if (!(met.last < half_turn.lo))
            at.sin.lo = std::min(zero, at.sin.lo), at.cos.lo = -one, rest.lo = zero;
        const I& s = at.cos;
        const I ss = square(s), bottom = I(1) + I(2) * s * kappa - r * ss,
                top = meet(I(2) * r * s - kappa * (I(1) - r * ss), I(2) * r * s - kappa + kappa * r * ss);
        bool holds = true;
        if (bottom.hi > zero) {
            if (const auto slope = slopes(top, bottom)) {
                if (slope->lo < one)
                    holds =
                        plain_count(not_negative(r * at.sin + *slope * not_negative(rest)), *slope, n + 1);
            } else {
                return false;
            }
        }
        if (holds && bottom.lo < zero) {
            if (const auto slope = slopes(top, -bottom)) {
                if (slope->lo < one)
                    holds = plain_count(not_negative(r * at.sin + *slope * t), *slope, n + 1);
            } else {
                return false;
            }
        }
        if (!holds) return false;
        return met.all ? std::optional(true) : std::nullopt;
    }
    /// The slopes top / bottom of the rays with bottom > 0; beyond 1 they do not matter.
    std::optional<I> slopes(const I& top, const I& bottom) {
        if (bottom.lo > zero) return top / bottom;
        if (!fact("0 < P, where E may be 0", top.lo > zero)) return std::nullopt;
        return I(div(down, top.lo, bottom.hi), std::max(one, div(down, top.lo, bottom.hi)));
    }
    /// Every flight above (h, kappa) that meets the bridge does so at or behind this t, where h + kappa t
    /// reaches r_hi sin t: L12 (a), as sine is concave on [0, pi].
    [[nodiscard]] N first_contact(const N& h, const N& kappa) const {
        const I c = I(h) / r_hi, k = I(kappa) / r_hi;
        N best = zero;
        const auto root = Base::guess_crossing(c.lo, k.lo);
        for (const N& z : {zero, root ? *root : zero}) {
            const auto [s, w] = trig(z);
            const I p = w - I(k.lo);
            if (p.lo > zero) best = std::max(best, (z - (s - I(k.lo) * z - I(c.lo)) / p).lo);
        }
        return best;
    }
    void log(const mpz_class& n, const I& kappa) {
        if (this->log_) this->log_->line({{("  " + n.get_str() + ": kappa ").c_str(), kappa}});
    }

    const I r{r_lo, r_hi};
};

const char* check_plain(const Leaf& leaf, Log* log) {
    if (leaf.opcode == equal_masses || leaf.opcode == witness) return turning().check(leaf, log);
    return judged<Plain>(leaf, log);
}

}  // namespace

const Section& plain() {
    static const Section section = full_section("minimal", check_plain);
    return section;
}

}  // namespace dumbbell_verify
