// For all sections with a chart contact: flights from the wall R, at psi = pi/2 - t at height h + kappa t,
// over the bridge of height rho sin t, 0 < t < pi (L15, L71), and the rays that leave it. For the dumbbell
// rho = r.
#pragma once
#include "verify/core/ray.hpp"
#include "verify/core/section.hpp"
#include "verify/guess/numbers.hpp"

namespace dumbbell_verify {

enum { contact, departure, again };
inline constexpr std::size_t once_leaf = witness + 1;

template <class N>
class Bridge : protected Rays<N> {
  protected:
    using Base = Rays<N>;
    using Base::fact, Base::less, Base::at_most, Base::half_turn, Base::one, Base::quarter, Base::zero;
    using typename Base::I, typename Base::Ray;

    Bridge(const Leaf& leaf, const Section& section, Log* log) : Base(log), leaf_(leaf) {
        if (log) log->box(leaf, section.charts[leaf.chart], bits(zero));
    }

    /// sin t and cos t for a number t in [0, pi].
    [[nodiscard]] SinCos<I> trig(const N& t) const {
        if (t <= N(2)) return sin_cos(t);
        const I u = half_turn - t;
        if (!(t <= half_turn.lo)) return {I(N(-1), one), I(N(-1), one)};
        const auto near = sin_cos(std::max(zero, u.lo)), far = sin_cos(u.hi);
        return {I(near.sin.lo, far.sin.hi), -I(far.cos.lo, near.cos.hi)};
    }
    /// A lower bound, for all r of the box, of the rays c/r = sin t + lambda (pi - t), lambda = cos t + eta
    /// for lesser t and greater eta; t from pi on counts as pi.
    [[nodiscard]] Ray contact_ray(const N& t, const N& eta) const {
        const bool end = !(t < half_turn.lo);
        const SinCos<I> at = end ? SinCos<I>{I(0), I(-1)} : trig(t);
        const I slope = at.cos + eta;
        const N height = end ? zero : std::max(zero, (at.sin + slope * (half_turn - t)).lo);
        const N lambda = std::max(-one, slope.lo);
        return {mul(down, r_lo, lambda < zero ? std::min(height, one) : height), mul(down, r_lo, lambda),
                r_lo};
    }

    /// Near the least root of sin t = c + k t in (0, pi) by Newton's iteration, which comes from the left; or
    /// none.
    [[nodiscard]] std::optional<N> guess_crossing(const N& c, const N& k) const {
        N t(0);
        for (long i = 0; i < most_steps(t); ++i) {
            const auto [s, w] = guess_sin_cos(t);
            const N p = w - k;
            if (!(p > N(0))) return std::nullopt;
            const N step = (c + k * t - s) / p;
            t = t + step;
            if (!(t < half_turn.lo)) return std::nullopt;
            if (std::max(step, -step) <= t * guess_tolerance(t)) break;
        }
        return std::max(N(0), t);
    }
    /// Certified h + kappa t >= rho sin t for all t in [0, pi], rho in the box: above a tangent of the
    /// bridge.
    bool certainly_above(const N& h, const N& kappa) {
        if (h >= zero && kappa >= rho_hi) return fact("above the bridge: 0 <= h, rho_hi <= kappa", true);
        const N z = guess_slope(kappa / rho_hi, half_turn.lo, quarter.lo);
        if (!(z >= zero && z <= half_turn.lo)) return false;
        const auto [s, w] = trig(z);
        const I rho = rho_hi;
        return (rho * (s - z * w)).hi <= h &&
               (rho * (s + (half_turn - z) * w)).hi <= (h + I(kappa) * half_turn).lo &&
               fact("above a tangent of the bridge", true);
    }
    /// Certified h + kappa t < rho_lo sin t.
    [[nodiscard]] bool certainly_below(const N& h, const N& kappa, const N& t) const {
        return t > zero && t < half_turn.lo && (h + I(kappa) * t).hi < (rho_lo * trig(t).sin).lo;
    }

    /// The first contacts with the bridge of all flights of slope >= kappa_low and below (h_high,
    /// kappa_high) that have one come at t <= last; `all`: every flight has one.
    struct Contacts {
        N last;
        bool all;
    };
    Contacts contacts(const N& kappa_low, const N& h_high, const N& kappa_high) {
        Contacts result{half_turn.hi, false};
        // At the contact kappa <= rho cos t.
        const N k = kappa_low / (kappa_low < zero ? rho_lo : rho_hi);
        widen_until(one / N(64), [&](const N& pad) {
            const N t = guess_slope(k, half_turn.lo, quarter.lo) + pad;
            if (!(t > zero && t < half_turn.lo)) return true;
            const I w = trig(t).cos;
            if (!((rho_lo * w).hi <= kappa_low && (rho_hi * w).hi <= kappa_low)) return false;
            result.last = t;
            return true;
        });
        const auto take = [&](const N& t) {
            if (!certainly_below(h_high, kappa_high, t)) return false;
            result = {std::min(result.last, t), true};
            return true;
        };
        if (const auto root = guess_crossing(h_high / rho_lo, kappa_high / rho_lo))
            widen_until(one, [&](const N& pad) { return take(*root + (half_turn.lo - *root) * pad); });
        if (!result.all) take(guess_slope(kappa_high / rho_lo, half_turn.lo, quarter.lo));
        if (this->log_)
            this->log_->line(
                {{result.all ? "  the bridge is met by all, at t <= " : "  the bridge may be met at t <= ",
                  I(result.last)}});
        return result;
    }

    /// Tries ever wider pads, from about the precision of a guess up to the limit, until one is good enough.
    template <class Attempt>
    void widen_until(const N& limit, const Attempt& is_enough) const {
        N pad = N(16) * guess_tolerance(one) * guess_tolerance(one);
        while (pad < limit && !is_enough(pad)) pad = pad * N(64);
    }

    /// L19, for t <= x1 and eta in [y0, y1]: the rays that come back from the next light wall have slope >=
    /// r.
    bool once() {
        const N cosine = x1 < half_turn.lo ? trig(x1).cos.lo : -one;
        const N lambda = (I(std::max(-one, cosine)) + y0).lo;
        const N kappa = std::min(mul(down, r_lo, lambda), mul(down, r_hi, lambda));
        if (kappa >= one) return fact("steep", true);
        // D > 0 needs w > z wherever z^2 - 2 kappa z - r <= 0.
        N z = (kappa + guess_square_root(kappa * kappa + r_lo)) * (one - guess_tolerance(one) / N(1024));
        if (!(z > zero) || !((I(z) * z - I(2) * kappa * z - r_lo).hi <= zero)) z = zero;
        const I f = I(z) * (I(z) + I(2) * r_lo) - r_hi, greatest = I(2) + y1;
        return fact("0 <= f", f.lo >= zero) || less("0 <= (2 + eta1) f + (z + r_lo) / 2", zero,
                                                    I(greatest.hi) * f + (I(z) + r_lo) / I(2), false);
    }

    const Leaf& leaf_;
    const N x0 = bound(down, leaf_.box.lo[0], zero), x1 = bound(up, leaf_.box.hi[0], zero);
    const N y0 = bound(down, leaf_.box.lo[1], zero), y1 = bound(up, leaf_.box.hi[1], zero);
    const N r_lo = bound(down, 1 / leaf_.box.hi[2], zero), r_hi = bound(up, 1 / leaf_.box.lo[2], zero);
    const bool is_body_ = leaf_.box.lo[3] > 0;
    const N rho_lo = is_body_ ? bound(down, leaf_.box.lo[3], zero) : r_lo;
    const N rho_hi = is_body_ ? bound(up, leaf_.box.hi[3], zero) : r_hi;

    /// What the sections say alike; `holds` is what they certify of `count`, or of a witness.
    template <class Holds>
    const char* judge(const Holds& holds) {
        if (!(r_lo > zero && rho_lo > zero)) return "r or rho is out of the range of this precision";
        if (leaf_.opcode == outside) return is_outside() ? nullptr : "a reason of `outside`";
        return (leaf_.opcode == once_leaf ? once() : holds()) ? nullptr : Base::failed();
    }
    bool is_outside() {
        if (leaf_.chart != departure)
            return less("pi < t0", half_turn, x0) ||
                   fact("1 <= rho_lo (eta0 - 1), exactly",
                        (is_body_ ? leaf_.box.lo[3] : 1 / leaf_.box.hi[2]) * (leaf_.box.lo[1] - 1) >= 1);
        return less("pi/2 < e0", quarter, x0) ||
               less("1 <= eta0 - cos e0", one, y0 - I(sin_cos(x0).cos), false);
    }
};

/// The parts of the sections that are the same.
inline Box full_root(std::size_t chart, const mpq_class& a, const mpq_class& b) {
    return chart == departure ? Box{{0, 0, a}, {2, 2, b}} : Box{{0, 0, a}, {4, power_of_two(b + 1), b}};
}
inline Section full_section(std::string_view lemmas, const char* (*check)(const Leaf&, Log*)) {
    return {lemmas,
            "dumbbell",
            "full",
            "bridge",
            {{"contact", {"t", "eta", "q"}}, {"departure", {"e", "eta", "q"}}, {"again", {"t", "eta", "q"}}},
            {{"count", Place::leaf, 3, 1},
             {"outside", Place::leaf, 7, 0},
             {"meets", Place::leaf, 0, 0},
             {"meets-reversed", Place::leaf, 0, 0},
             {"equal-masses", Place::cover, 1, 0},
             {"witness", Place::witness, 1, 2},
             {"once", Place::leaf, 4, 0}},
            full_root,
            check,
            true};
}

}  // namespace dumbbell_verify
