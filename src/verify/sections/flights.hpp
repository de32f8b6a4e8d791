// Flights of all states of a box together, by interval evaluation (format-sections.md, sections 2 and 4; L16,
// L71): E = g + 2 s kappa - rho s^2 and P = 2 r s - kappa (g - rho s^2) behind the bridge. For the dumbbell g
// = 1, rho = r.
#pragma once
#include <stdexcept>
#include <vector>

#include "verify/functions/angle.hpp"
#include "verify/sections/bridge.hpp"

namespace dumbbell_verify {

template <class N>
class Flights : protected Bridge<N> {
  protected:
    using Base = Bridge<N>;
    using Base::fact, Base::trig, Base::half_turn, Base::quarter, Base::one, Base::zero, Base::leaf_;
    using Base::x0, Base::x1, Base::y0, Base::y1, Base::r_lo, Base::r_hi, Base::is_body_;
    using typename Base::I, typename Base::Ray, typename Base::Contact;

    using Base::Base;

    /// Enclosures of the states in play behind n collisions: flights that leave a light wall at corner
    /// distance x, or rays, for which c counts instead.
    struct Flight {
        bool is_ray, clear;  ///< clear: the bridge is out of reach from here on
        I kappa, x, sine, c;
        mpz_class n = 0;
    };

    /// What a leaf `count` demands.
    bool counts() {
        return fact("1 + a <= U", 1 + leaf_.a <= leaf_.claimed) &&
               at_most_a(leaf_.chart == contact ? contact_ray() : departure_flight());
    }

    [[nodiscard]] I not_negative(const I& a) const { return {std::max(zero, a.lo), std::max(zero, a.hi)}; }
    /// Of departures, over the near corner (t = 0) or the far one (t = pi).
    [[nodiscard]] I height(const Flight& f, const I& t) const { return f.sine + f.kappa * (f.x + t); }

    /// The collision of rays with a light wall, of all that have one: (2) of L4 is top / D.
    struct Wall {
        I x, sine, w, D, top;
    };
    [[nodiscard]] Wall wall(const Ray& low, const N& z, const std::optional<Contact>& last,
                            const I& kappa) const {
        const Contact first = Base::earliest(low, z);
        const I x = span(first.x, last ? std::min(last->x, quarter.hi) : quarter.hi),
                sine = span(std::max(zero, first.sine), last ? std::min(one, last->sine) : one),
                w = span(std::max({zero, kappa.lo, last ? last->cosine : zero}), first.cosine);
        const I ww = square(w), D = meet(ww - I(2) * kappa * w - r, w * (w - I(2) * kappa) - r);
        return {x, sine, w, D, meet(kappa * ww + r * (I(2) * w - kappa), kappa * (ww - r) + I(2) * r * w)};
    }
    /// The slopes of those that return. Precondition: 0 < D, or 0 < top.
    [[nodiscard]] I slope_behind(const Wall& at, const I& kappa) const {
        I next = at.D.lo > zero ? at.top / at.D : I(div(down, at.top.lo, at.D.hi), div(up, one, zero));
        if (at.w.lo > zero) {
            const I A = (at.w - r / at.w) / I(2), p = A - kappa;
            if (p.lo > zero)
                next = meet(meet(next, (square(A) + r) / p - A), kappa + (r + square(kappa)) / p);
        }
        return next;
    }

    /// The first contacts with the bridge.
    struct Rebound {
        I t, rest, sine, E, P;
    };
    [[nodiscard]] Rebound rebound(const I& h, const I& kappa, const N& latest) const {
        I t = span(first_contact(h.lo, kappa.lo), std::min(latest, half_turn.lo));
        SinCos<I> at = over(t);
        I rest = half_turn - t;
        if (!(latest < half_turn.lo))
            at.sin.lo = std::min(zero, at.sin.lo), at.cos.lo = -one, rest.lo = zero, t.hi = half_turn.hi;
        const I s = at.cos, ss = square(s);
        return {t, not_negative(rest), at.sin, g + I(2) * s * kappa - rho * ss,
                meet(I(2) * r * s - kappa * (g - rho * ss), I(2) * r * s - kappa * g + kappa * rho * ss)};
    }
    /// Rays from there, with these slopes: to the left, or back to the right.
    [[nodiscard]] Flight ray_behind(const Rebound& at, bool left, const I& slope, const mpz_class& n) const {
        return {true, clear_, slope, {}, {}, rho * at.sine + slope * (left ? at.rest : at.t), n};
    }

    const I r{r_lo, r_hi}, rho{Base::rho_lo, Base::rho_hi};

  private:
    static constexpr std::size_t most_flights = 100'000;

    /// That of the chart contact.
    [[nodiscard]] Flight contact_ray() const {
        // The end pi of the chart: sine 0, cosine -1.
        const bool end = !(x1 < half_turn.lo);
        const I t(std::min(x0, half_turn.lo), end ? half_turn.lo : x1);
        SinCos<I> at = over(t);
        I rest = half_turn - t;
        if (end) at.sin.lo = std::min(zero, at.sin.lo), at.cos.lo = -one, rest.lo = zero;
        const I lambda = at.cos + I(y0, y1);
        return {true, clear_, rho * lambda, {}, {}, rho * (at.sin + lambda * not_negative(rest))};
    }
    /// That of the chart departure.
    [[nodiscard]] Flight departure_flight() const {
        const bool end = !(x1 < quarter.lo);
        const I x(std::min(x0, quarter.lo), end ? quarter.hi : x1);
        const auto low = sin_cos(x.lo), high = end ? SinCos<I>{I(1), I(0)} : sin_cos(x1);
        return {
            false, false, I(y0, y1) - I(high.cos.lo, low.cos.hi), x, {low.sin.lo, std::min(one, high.sin.hi)},
            {}};
    }

    /// Certified: none has more than a later collisions.
    bool at_most_a(const Flight& flight) {
        std::vector<Flight> todo{flight};
        while (!todo.empty()) {
            const Flight next = std::move(todo.back());
            todo.pop_back();
            if (!follow(next, todo)) return false;
            if (todo.size() > most_flights) throw std::length_error("more than 100,000 flights at once");
        }
        return true;
    }

    /// Of sine and cosine on [t.lo, t.hi] within [0, pi].
    [[nodiscard]] SinCos<I> over(const I& t) const {
        const auto a = trig(t.lo), b = trig(t.hi);
        I sine = hull(a.sin, b.sin);
        if (t.lo <= quarter.hi && quarter.lo <= t.hi) sine.hi = one;
        return {sine, {b.cos.lo, a.cos.hi}};
    }
    /// Certified: no more than a collisions; but what goes on from the bridge is added to `later`.
    bool follow(Flight f, std::vector<Flight>& later) {
        for (N z = zero, z_high = zero;; ++f.n) {
            if (this->log_) this->log_->line({{("  " + f.n.get_str() + ": kappa ").c_str(), f.kappa}});
            if (f.kappa.lo >= one) return fact("steep", true);
            f.kappa.hi = std::min(one, f.kappa.hi);
            if (!f.is_ray) {
                if (!f.clear)
                    if (const auto done = bridge(f, later)) return *done;
                f.c = height(f, half_turn);
            }
            Work::collision();
            f.c = not_negative(f.c);
            const Ray low{f.c.lo, f.kappa.lo, r_lo}, high{f.c.hi, f.kappa.hi, r_hi};
            const bool seems_to_hit = guess_root(low.c, low.kappa, z);
            if ((!seems_to_hit || f.n == leaf_.a) && Base::misses(low)) return fact("misses the wall", true);
            if (!fact("n + 1 <= a at the wall", f.n + 1 <= leaf_.a)) return false;
            std::optional<Contact> last;
            if (high.kappa < one && guess_root(high.c, high.kappa, z_high)) last = Base::latest(high, z_high);
            const Wall at = wall(low, z, last, f.kappa);
            if (at.D.hi <= zero) return fact("none returns", true);
            if (!(at.D.lo > zero) && !fact("0 < numerator, where D may be 0", at.top.lo > zero)) return false;
            f = {false, f.clear, slope_behind(at, f.kappa), at.x, at.sine, {}, std::move(f.n)};
        }
    }
    /// Contacts with the bridge. Nothing if flights go on that did not meet it.
    std::optional<bool> bridge(const Flight& f, std::vector<Flight>& later) {
        const I h = not_negative(height(f, I(0)));
        if (Base::certainly_above(h.lo, f.kappa.lo)) return std::nullopt;
        const auto met = Base::contacts(f.kappa.lo, h.hi, f.kappa.hi);
        if (!fact("n + 1 <= a at the bridge", f.n + 1 <= leaf_.a)) return false;
        const Rebound at = rebound(h, f.kappa, met.last);
        for (const bool left : {true, false}) {
            const I E = left ? at.E : -at.E;
            if (!(E.hi > zero)) continue;
            const auto slope = slopes(at.P, E);
            if (!slope) return false;
            if (slope->lo < one) later.push_back(ray_behind(at, left, *slope, f.n + 1));
        }
        return met.all ? std::optional(true) : std::nullopt;
    }
    /// The slopes top / bottom of the rays with bottom > 0; beyond 1 they do not matter.
    std::optional<I> slopes(const I& top, const I& bottom) {
        if (bottom.lo > zero) return top / bottom;
        if (!fact("0 < P, where E may be 0", top.lo > zero)) return std::nullopt;
        return I(div(down, top.lo, bottom.hi), std::max(one, div(down, top.lo, bottom.hi)));
    }
    /// Every flight above (h, kappa) that meets the bridge does so at or behind this t, where h + kappa t
    /// reaches rho_hi sin t: L12 (a), as sine is concave on [0, pi].
    [[nodiscard]] N first_contact(const N& h, const N& kappa) const {
        const I c = I(h) / rho.hi, k = I(kappa) / rho.hi;
        N best = zero;
        const auto root = Base::guess_crossing(c.lo, k.lo);
        for (const N& z : {zero, root ? *root : zero}) {
            const auto [s, w] = trig(z);
            const I p = w - I(k.lo);
            if (p.lo > zero) best = std::max(best, (z - (s - I(k.lo) * z - I(c.lo)) / p).lo);
        }
        return best;
    }

    const I g = is_body_ ? I(bound(down, 1 / (leaf_.box.hi[2] * leaf_.box.hi[3]), zero),
                             bound(up, 1 / (leaf_.box.lo[2] * leaf_.box.lo[3]), zero))
                         : I(1);
    /// L6 (c), L75: behind the bridge it is out of reach, if Q rho, which is between these, is 1.
    const bool clear_ =
        !is_body_ || (leaf_.box.lo[2] * leaf_.box.lo[3] == 1 && leaf_.box.hi[2] * leaf_.box.hi[3] == 1);
};

}  // namespace dumbbell_verify
