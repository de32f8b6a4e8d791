// The collisions after a contact, for a box of rays: by the monotone counts, and from wall to wall
// (format-initial.md, sections 5 and 6).
#pragma once
#include "verify/core/ray.hpp"
#include "verify/functions/angle.hpp"
#include "verify/guess/numbers.hpp"
#include "verify/machine/integer.hpp"
#include "verify/machine/meter.hpp"

namespace dumbbell_verify::starts {

template <class N>
class Departures : public Rays<N> {
  public:
    using Base = Rays<N>;
    using Base::fact, Base::half_turn, Base::one, Base::quarter, Base::zero;
    using typename Base::I, typename Base::Ray;

    /// Rays that leave a wall: their height at the corner ahead and their slope.
    struct Departure {
        bool light;  ///< the wall that they leave; the bridge is ahead of these, else a light wall
        I height, slope;
    };

    Departures(const I& r, Log* log) : Base(log), r_(r) {}

    /// Certified: at least `least` and at most `most` later collisions.
    bool certify(Departure ray, std::uint64_t least, std::uint64_t most) {
        enough_ = least == 0;
        few_ = false;
        int counted = 0;
        for (std::uint64_t done = 0; done <= most && done <= most_followed; ++done) {
            note(done, ray);
            Meter::spend(1 << 14);
            enough_ = enough_ || done >= least;
            if (ray.slope.lo >= one) return fact("all leave steeply (L3), with enough collisions", enough_);
            const bool passes = ray.light && passes_bridge(ray);
            count(ray, passes, least - std::min(least, done), most - done);
            if (enough_ && few_) return true;
            counted += ray.slope.lo >= -r_.lo;
            if (counted > most_counted) break;
            bool last = false;
            const auto next = ray.light && !passes ? off_bridge(ray) : off_light_wall(ray, last);
            if (last)
                return fact("a last collision (L1), the number of all is as said",
                            least <= done + 1 && done + 1 <= most);
            if (!next) break;
            ray = *next;
        }
        return fact(few_ ? "at least so many collisions" : "at most so many collisions", false);
    }
    /// What the last certify() found, whatever it said of the other bound: at least `least`.
    [[nodiscard]] bool has_enough() const { return enough_; }

    /// Certified U <= most: G <= U for all c >= 0, kappa >= -r_lo.
    bool all_at_most(std::uint64_t most) {
        require_countable();
        return most >= 1 && this->at_most("1 + G(pi r_lo, r_lo, r_lo)",
                                          {(half_turn * r_.lo).lo, r_.lo, r_.lo}, integer(most - 1));
    }
    /// Certified M <= most: no trajectory at these mass ratios has more collisions. M is 1 + 2 U or 2 + 2 V;
    /// as V is U or U - 1, the former decides about odd numbers, the latter about even ones.
    bool trajectories_at_most(std::uint64_t most) {
        if (most < 2 || r_.lo >= one) return most >= 2;
        if (most % 2 == 1) return all_at_most(most / 2);
        require_countable();
        return this->at_most("G(r_lo, 0, r_lo)", {r_.lo, zero, r_.lo}, integer(most / 2 - 1));
    }

    /// Certified height + slope x > r sin x on [0, pi]: above a tangent of r sin x, the best one.
    bool passes_bridge(const Departure& ray) {
        if (ray.slope.lo >= r_.hi) return true;
        const I z = guess_slope(ray.slope.lo / r_.hi, half_turn.lo, quarter.lo);
        const auto [s, w] = sin_cos_on(z, quarter);
        return (ray.height - r_ * (s - z * w)).lo > zero &&
               (ray.height + ray.slope * half_turn - r_ * (s + (half_turn - z) * w)).lo > zero;
    }

    /// The rays after a contact with the bridge, if all touch it and go on, or all go back.
    std::optional<Departure> off_bridge(const Departure& ray) {
        const I height = ray.height / r_, steepness = ray.slope / r_;
        auto at = contacts(height, steepness);  // narrower, but before the top only
        if (!at) at = bridge_contacts(height, steepness);
        if (!at) return std::nullopt;
        const auto onward = [&](const I& k, const I& w) { return I(1) - r_ * square(w) + I(2) * k * w; };
        const I D = onward(ray.slope, at->cosine);
        if (!(D.lo > zero || D.hi < zero)) return std::nullopt;
        // Over D, which keeps its sign: decreases with the slope, increases with the cosine.
        const auto along = [&](const N& k, const N& w) {
            const I top = I(2) * r_ * w - I(k) * (I(1) - r_ * square(I(w))), d = onward(k, w);
            return D.lo > zero ? top / d : -(top / -d);
        };
        const I slope = span(along(ray.slope.hi, at->cosine.lo).lo, along(ray.slope.lo, at->cosine.hi).hi);
        const bool back = D.hi < zero;
        const I way = back ? at->x : half_turn - at->x, rise = back ? -slope : slope;
        return Departure{false, r_ * at->sine + rise * way, rise};
    }
    /// The rays that leave the bridge, or pass it, after a contact with the light wall ahead, if all touch it
    /// and turn back; `last`: all touch it and go on over the peak.
    std::optional<Departure> off_light_wall(const Departure& ray, bool& last) {
        const auto at = contacts(ray.light ? ray.height + ray.slope * half_turn : ray.height, ray.slope);
        if (!at) return std::nullopt;
        const auto divisor = [&](const I& k, const I& w) { return square(w) - I(2) * k * w - r_; };
        const I D = divisor(ray.slope, at->cosine);
        last = D.hi <= zero;
        if (!(D.lo > zero)) return std::nullopt;
        // Increases with the slope, decreases with the cosine.
        const auto reflected = [&](const N& k, const N& w) {
            return (I(k) * square(I(w)) + I(2) * r_ * w - r_ * k) / divisor(k, w);
        };
        const I slope =
            span(reflected(ray.slope.lo, at->cosine.hi).lo, reflected(ray.slope.hi, at->cosine.lo).hi);
        return Departure{true, at->sine + slope * at->x, slope};
    }

  protected:
    /// The contacts with a wall sin x over the corner, for all c + kappa x of these intervals.
    struct Contacts {
        I x, sine, cosine;
    };
    [[nodiscard]] std::optional<Contacts> contacts(const I& c, const I& kappa) const {
        if (!(c.lo > zero && kappa.hi < one)) return std::nullopt;
        const auto near = [&](const N& height, const N& slope) {
            N z = zero;
            guess_root(height, slope, z);
            return z > zero ? std::min(z, quarter.lo) : zero;
        };
        const auto first = this->earliest({c.lo, kappa.lo, r_.lo}, near(c.lo, kappa.lo));
        const auto last = this->latest({c.hi, kappa.hi, r_.hi}, near(c.hi, kappa.hi));
        if (!last) return std::nullopt;
        return Contacts{span(first.x, last->x), span(first.sine, last->sine),
                        span(last->cosine, first.cosine)};
    }

    /// L60: the same with a wall up to pi. Of the lowest ray nothing lies before its tangent's root; the
    /// highest one has a root before a point where sin x > c + kappa x.
    [[nodiscard]] std::optional<Contacts> bridge_contacts(const I& c, const I& kappa) const {
        if (!(c.lo > zero && kappa.hi < one)) return std::nullopt;
        const N low = near_bridge(c.lo, kappa.lo), high = near_bridge(c.hi, kappa.hi);
        const auto gap = [&](const N& height, const N& slope, const N& x) {
            return sin_cos_on(I(x), quarter).sin - I(slope) * x - height;
        };
        const auto rate = [&](const N& slope, const N& x) { return sin_cos_on(I(x), quarter).cos - slope; };
        const I p = rate(kappa.lo, low), p_high = rate(kappa.hi, high);
        if (!(p.lo > zero && p_high.lo > zero)) return std::nullopt;
        const N first = std::max(zero, (I(low) - gap(c.lo, kappa.lo, low) / p).lo);
        const I rest = gap(c.hi, kappa.hi, high), size = I(std::max(-rest.lo, rest.hi)) / p_high;
        for (const int factor : {2, 8, 64}) {
            const N last = (I(high) + I(factor) * size).hi;
            if (!(first <= last && last <= half_turn.lo)) return std::nullopt;
            if (!(gap(c.hi, kappa.hi, last).lo > zero)) continue;
            const auto [sine, cosine] = sin_cos_on(I(first, last), quarter);
            return Contacts{{first, last}, sine, cosine};
        }
        return std::nullopt;
    }

  private:
    /// Twice what format-initial.md asks for: of all rays, and of those that are counted by G.
    static constexpr std::uint64_t most_followed = 2000;
    static constexpr int most_counted = 128;
    static constexpr double least_ratio = 0x1p-43;  ///< of r: below are more than 10^6 collisions

    void require_countable() const {
        if (to_double(down, r_.lo) < least_ratio) throw std::length_error("a mass ratio beyond 2^43");
    }

    void note(std::uint64_t done, const Departure& ray) {
        if (this->log_)
            this->log_->line({{("  after " + std::to_string(done) +
                                (ray.light ? ": light wall" : ": bridge") + ", height at the corner ")
                                   .c_str(),
                               ray.height},
                              {", slope ", ray.slope}});
    }

    /// The bounds by G, without following the rays.
    void count(const Departure& ray, bool passes, std::uint64_t least, std::uint64_t most) {
        if (!(ray.slope.lo >= -r_.lo)) {
            few_ = few_ || (!ray.light && all_at_most(most));
            return;
        }
        const I c = ray.light ? ray.height + ray.slope * half_turn : ray.height;
        const auto bounded = [&] {
            return this->at_most("G <= most", {std::max(zero, c.lo), ray.slope.lo, r_.lo}, integer(most));
        };
        if (ray.light && !passes) {
            few_ = few_ || (most >= 1 && bounded() && all_at_most(most - 1));
            return;
        }
        few_ = few_ || bounded();
        enough_ = enough_ ||
                  this->at_least("least <= G", {std::max(zero, c.hi), ray.slope.hi, r_.hi}, integer(least));
    }

    /// Near the least root of sin x = c + kappa x in [0, pi], by Newton's iteration from the left.
    [[nodiscard]] N near_bridge(const N& c, const N& kappa) const {
        N z = zero;
        for (int i = 0; i < 100; ++i) {
            const auto [s, w] = sin_cos_on(I(z), quarter);
            const I step = (I(c) + I(kappa) * z - s) / (w - kappa);
            const N next = z + step.lo;
            if (!(next >= zero && next <= half_turn.lo)) break;
            const bool near = std::max(step.lo, -step.lo) <= z * guess_tolerance(z);
            z = next;
            if (near) break;
        }
        return z;
    }

    const I r_;
    bool enough_ = false, few_ = false;  ///< what has been certified of the present rays
};

}  // namespace dumbbell_verify::starts
