// The flight of a dumbbell from the air to its first contact, in time, for all states of a leaf
// (format-initial.md, sections 3 and 4).
#pragma once
#include <optional>
#include <vector>

#include "verify/functions/angle.hpp"
#include "verify/machine/meter.hpp"
#include "verify/wings/starts/grammar.hpp"

namespace dumbbell_verify::starts {

/// A box of states at time 0, and their flight. h = y (1 + r), v = ydot (1 + r).
template <class N>
class Flight {
  public:
    using I = Interval<N>;

    explicit Flight(const Box& box, bool any_spin = false)
        : phi(side(box, 0)),
          w(any_spin ? I(1) / I(0) : side(box, 1)),
          r(bound(down, 1 / box.hi[4], N(0)), bound(up, 1 / box.lo[4], N(0))),
          h(side(box, 2) * (I(1) + r)),
          v(side(box, 3) * (I(1) + r)) {}

    const I quarter = pi<N>() / I(2);
    const I phi, w, r, h, v;

    /// The height of a mass over the floor at time t, given the sine of phi + w t.
    [[nodiscard]] I clearance(bool heavy, const I& t, const I& sine) const {
        return h + v * t + (heavy ? -(r * sine) : sine);
    }
    [[nodiscard]] I clearance(bool heavy, const I& t) const {
        return clearance(heavy, t, sin_cos_on(phi + w * t, quarter).sin);
    }
    /// Its derivative in time, given the cosine of phi + w t.
    [[nodiscard]] I rate(bool heavy, const I& cosine) const {
        const I turning = w * cosine;
        return v + (heavy ? -(r * turning) : turning);
    }
    [[nodiscard]] I rate_over(bool heavy, const I& t) const {
        return rate(heavy, sin_cos_on(phi + w * t, quarter).cos);
    }

    /// Over all of [0, end], certified: both masses are above the floor, but `first`, if there is one, may
    /// come down to it, and then stays below.
    [[nodiscard]] bool is_closed(std::optional<bool> first, const N& end) const {
        std::vector<std::pair<N, N>> spans{{N(0), end}};
        for (int looked_at = 0; !spans.empty(); ++looked_at) {
            const auto [from, to] = spans.back();
            if (looked_at == most_spans) return false;
            spans.pop_back();
            if (span_is_closed(first, from, to)) continue;
            const N middle = ((I(from) + to) / I(2)).lo;
            if (!(from < middle && middle < to)) return false;
            spans.emplace_back(middle, to);
            spans.emplace_back(from, middle);
        }
        return true;
    }
    /// Certified: no state collides. It rises at once steeply (L3), or above all walls, or gets there.
    [[nodiscard]] bool never_collides() const {
        if (!(v.lo >= N(0))) return false;
        if ((v.lo > N(0) && v.lo >= std::max(-w.lo, w.hi)) || h.lo > N(1)) return true;
        return v.lo > N(0) && is_closed(std::nullopt, std::max(N(0), ((I(1) - h) / v).hi));
    }

    /// phi at the contact of a mass, all contacts being in `times`, where the clearance falls; none if the
    /// two enclosures exclude each other. Mean value form: the derivatives of phi + w t, clearance(t) = 0,
    /// by phi, w, h, v and r are v, t v, -w, -w t and 0 (light) or w sin (heavy), over the clearance's rate.
    [[nodiscard]] std::optional<I> contact_angle(bool heavy, const I& times) const {
        const Flight middle(*this, 0);
        const I direct = phi + w * times, at = mid(times);
        const auto [sine, cosine] = sin_cos_on(direct, quarter);
        const I fall = -rate(heavy, cosine), fall_m = -middle.rate_over(heavy, times);
        if (!(fall.lo > N(0) && fall_m.lo > N(0))) return std::nullopt;
        const auto time = common(times, at + middle.clearance(heavy, at) / fall_m);
        if (!time) return std::nullopt;
        I change =
            v * ((phi - middle.phi) + times * (w - middle.w)) - w * ((h - middle.h) + times * (v - middle.v));
        if (heavy) change = change + w * sine * (r - middle.r);
        return common(direct, middle.phi + middle.w * *time - change / fall);
    }

  private:
    static constexpr int most_spans = 2048;

    /// The state in the middle.
    Flight(const Flight& all, int)
        : quarter(all.quarter),
          phi(mid(all.phi)),
          w(mid(all.w)),
          r(mid(all.r)),
          h(mid(all.h)),
          v(mid(all.v)) {}

    static I side(const Box& box, std::size_t i) {
        return {bound(down, box.lo[i], N(0)), bound(up, box.hi[i], N(0))};
    }
    /// A number of X near its middle.
    static I mid(const I& x) { return std::clamp(((I(x.lo) + x.hi) / I(2)).lo, x.lo, x.hi); }
    static std::optional<I> common(const I& a, const I& b) {
        const I both(std::max(a.lo, b.lo), std::min(a.hi, b.hi));
        return both.lo <= both.hi ? std::optional(both) : std::nullopt;
    }

    [[nodiscard]] bool span_is_closed(std::optional<bool> first, const N& from, const N& to) const {
        Meter::spend(1 << 12);
        const I span(from, to);
        if ((h + v * span).lo > N(1)) return true;
        const I sine = sin_cos_on(phi + w * I(from), quarter).sin,
                cosine = sin_cos_on(phi + w * span, quarter).cos;
        const auto stays_clear = [&](bool heavy) {
            const I change = rate(heavy, cosine);
            if (first == heavy && change.hi < N(0)) return true;
            const I lowest = clearance(heavy, from, sine) + I(std::min(N(0), change.lo)) * (I(to) - from);
            return lowest.lo > N(0);
        };
        return stays_clear(false) && stays_clear(true);
    }
};

}  // namespace dumbbell_verify::starts
