// The reflection at the first contact, for all states of a leaf (format-initial.md, section 6).
#pragma once
#include "verify/wings/starts/flight.hpp"
#include "verify/wings/starts/ray.hpp"

namespace dumbbell_verify::starts {

template <class N>
class FirstReflection : public Departures<N> {
  public:
    using Base = Departures<N>;
    using Base::fact, Base::half_turn, Base::quarter, Base::zero;
    using typename Base::Departure, typename Base::I;

    FirstReflection(const Flight<N>& flight, Log* log) : Base(flight.r, log), flight_(flight) {}

    /// The rays after the first contact, at phi in `angle`; `none`: they never collide again. The slope
    /// d yhat / d phi is a quotient top / D of m = w / -v for falling states, else of n = v / w.
    std::optional<Departure> behind_first(bool heavy, const I& angle, bool& none) {
        const I &v = flight_.v, &w = flight_.w, &r = flight_.r;
        const bool falling = v.hi < zero, backwards = w.hi < zero;
        if (!fact("falling, or turning in one direction", falling || backwards || w.lo > zero))
            return std::nullopt;
        const I x = falling ? w / -v : backwards ? -v / -w : v / w;
        const auto [sine, cosine] = sin_cos_on(angle, quarter);
        const auto top = [&](const I& p, const I& c) {
            const I turn = I(heavy ? 2 : -2) * r * c, rest = heavy ? I(1) - r * square(c) : r - square(c);
            return falling ? rest + turn * p : turn - p * rest;
        };
        const auto divisor = [&](const I& p, const I& c) {
            const I twice = I(heavy == falling ? -2 : 2) * c,
                    rest = heavy ? I(1) - r * square(c) : r - square(c);
            return falling ? p * rest + twice : rest + p * twice;
        };
        const bool reversed = !falling && backwards;  // D has the sign of the new phidot, or the other one
        const I D = divisor(x, cosine), rise = reversed ? -top(x, cosine) : top(x, cosine);
        none = rise.lo > zero && rise.lo >= std::max(-D.lo, D.hi);  // L3
        if (none || !fact("a certain direction", D.lo > zero || D.hi < zero)) return std::nullopt;
        // Decreases with x, and with the cosine (light) or its negative (heavy).
        const auto slope = [&](const N& p, const N& c) {
            return D.lo > zero ? top(p, c) / divisor(p, c) : -(top(p, c) / -divisor(p, c));
        };
        const I K = span(slope(x.hi, heavy ? cosine.lo : cosine.hi).lo,
                         slope(x.lo, heavy ? cosine.hi : cosine.lo).hi);
        return departure(heavy, angle, heavy ? r * sine : -sine, K, (D.lo > zero) != reversed, none);
    }

  protected:
    const Flight<N> flight_;

  private:
    /// The way out from the angle to the next corner; `none`: over the peak of a light wall (L1).
    std::optional<Departure> departure(bool heavy, const I& angle, const I& height, const I& K, bool right,
                                       bool& none) {
        const double humps = to_double(down, angle.lo) / to_double(down, half_turn.lo);
        if (!fact("an angle within reach", std::abs(humps) < most_quarters)) return std::nullopt;
        int n = static_cast<int>(std::floor(humps)) - 1;  // next to a corner doubles are not enough
        while ((I(n + 1) * half_turn).hi < angle.lo) ++n;
        const I begin = I(n) * half_turn, end = I(n + 1) * half_turn, peak = begin + quarter;
        if (!fact("all contacts on one wall", begin.hi < angle.lo && angle.hi < end.lo)) return std::nullopt;
        if (!heavy) {
            const bool before = angle.hi <= peak.lo, behind = angle.lo >= peak.hi;
            if (!fact("all contacts on one side of the peak", before || behind)) return std::nullopt;
            none = right == before;
            if (none) return std::nullopt;
        }
        const I way = right ? end - angle : angle - begin, rise = right ? K : -K;
        return Departure{!heavy, height + rise * way, rise};
    }
};

}  // namespace dumbbell_verify::starts
