// The orbit of one attained state, enclosed, and the value that it has (format-adiabatic.md, section 6).
#include "verify/wings/adiabatic/bounce.hpp"
#include "verify/wings/adiabatic/check.hpp"

namespace dumbbell_verify::adiabatic {
namespace {

template <class N>
class OrbitCheck : Check<N> {
    using Base = Check<N>;
    using Base::fact, Base::leaf_, Base::claim_, Base::m_, Base::quarter, Base::half_turn, Base::zero,
        Base::one, Base::number, Base::margin_;
    using typename Base::I, typename Base::Ray;

  public:
    OrbitCheck(const Leaf& leaf, Log* log)
        : Base(leaf, Masses<N>(number(leaf.terms->claim.attained.at(leaf.index).delta)), log),
          state_(claim_.attained.at(leaf.index)),
          climb_(m_.delta * number(state_.s)),
          kappa_0_(-(climb_ / m_.beta2)) {}

    /// nullptr if all is certified, else what is not.
    const char* verdict() { return is_attained() ? nullptr : Base::failed(); }

  private:
    /// A flight off the light wall, after the contact `from`: its slope, and its height at the far corner.
    struct Flight {
        I slope, corner;
    };

    bool is_attained() {
        const Touch<N> first = Touch<N>::at(m_, number(state_.u), quarter);
        if (!fact("the rod is not vertical, nor level or beyond",
                  first.x.lo > zero && first.w.lo > zero && first.x.hi < quarter.lo))
            return false;
        if (claim_.has_heights()) {
            const I y = m_.beta2 * first.sine;
            if (!(Base::at_most("Y1 <= y", number(claim_.y_lo), y) &&
                  Base::at_most("y <= Y2", y, number(claim_.y_hi))))
                return false;
        } else if (!is_first(first)) {
            return false;
        }
        Touch<N> last = first;
        I kappa = kappa_0_;
        for (std::uint64_t count = 0; count < state_.collisions; ++count) {
            Work::collision();
            const auto flight = behind(last, kappa);
            if (!(flight && passes(last, *flight))) return false;
            const auto next = contact(*flight);
            if (!fact("the next collision", next.has_value())) return false;
            last = *next;
            kappa = flight->slope;
            if (claim_.kind == Claim::run && !is_apart(last)) return false;
        }
        if (this->log_) this->log_->line({{"  last contact at x ", last.x}, {", slope ", kappa}});
        switch (claim_.kind) {
            case Claim::bounce:
                return has_errors(first, last, kappa);
            case Claim::run:
                return has_change(first, last, kappa, I(1));
            default:
                return is_last(last, kappa) && has_change(first, last, kappa, turned(last, kappa));
        }
    }

    [[nodiscard]] bool is_apart(const Touch<N>& at) {
        return Base::at_most("u >= margin", margin_, quarter - at.x);
    }
    /// The reversed flight before collision 0 never comes down: it passes the bridge and misses the wall.
    bool is_first(const Touch<N>& at) {
        const I slope = -kappa_0_;
        const Flight back{slope, at.sine + slope * (at.x + half_turn)};
        return passes(at, back) && fact("no collision before the first", leaves(back));
    }
    /// Behind collision n: on over the peak, too steep, or over everything.
    bool is_last(const Touch<N>& at, const I& kappa) {
        if (!is_apart(at)) return false;
        const I D = onward(m_, at.w, kappa);
        if (D.hi < zero) return fact("the last flight goes on (L1)", true);
        const auto flight = behind(at, kappa);
        if (!flight) return false;
        if (flight->slope.lo >= one) return fact("the last flight is steep (L3)", true);
        return passes(at, *flight) && fact("no collision after the last", leaves(*flight));
    }
    /// Certified: a flight that ascends misses the wall ahead.
    bool leaves(const Flight& flight) {
        return flight.slope.lo >= zero && flight.slope.lo < one &&
               this->misses({flight.corner.lo, flight.slope.lo, zero});
    }
    /// The flight back from a collision, which certainly exists.
    std::optional<Flight> behind(const Touch<N>& at, const I& kappa) {
        if (!Base::less("0 < D", I(0), onward(m_, at.w, kappa))) return std::nullopt;
        const I slope = slope_behind(m_, at.w, kappa);
        return Flight{slope, corner_behind(at, slope)};
    }
    /// Certified: above the bridge, which is at most r high, and lies below its tangents.
    bool passes(const Touch<N>& at, const Flight& flight) {
        return fact("passes the bridge",
                    (at.sine.lo > m_.r.hi && flight.corner.lo > m_.r.hi) ||
                        this->passes_bridge({true, at.sine + flight.slope * at.x, flight.slope}));
    }
    /// The next contact with a light wall, if there certainly is one.
    std::optional<Touch<N>> contact(const Flight& flight) {
        const Ray lowest{flight.corner.lo, flight.slope.lo, zero},
            highest{flight.corner.hi, flight.slope.hi, zero};
        if (!(lowest.c > zero && highest.kappa < one)) return std::nullopt;
        N z = zero;
        guess_root(lowest.c, lowest.kappa, z);
        const auto from = this->earliest(lowest, z);
        if (!guess_root(highest.c, highest.kappa, z)) return std::nullopt;
        const auto until = this->latest(highest, z);
        if (!until || !(zero < from.x)) return std::nullopt;
        return Touch<N>(m_, span(from.x, until->x), span(from.sine, until->sine),
                        span(until->cosine, from.cosine));
    }

    /// |phidot_+ / phidot_-| of a collision with D > 0 or D < 0.
    [[nodiscard]] I turned(const Touch<N>& at, const I& kappa) const {
        const I D = onward(m_, at.w, kappa);
        return (D.lo > zero ? D : -D) / (at.square_w + m_.r);
    }
    /// I_n before the collision times the factor, against I_0 = f_0.
    bool has_change(const Touch<N>& first, const Touch<N>& last, const I& kappa, const I& factor) {
        const I spin = root((m_.r + square(kappa_0_)) / (m_.r + square(kappa)));
        const I change = last.f * spin * factor - first.f;
        const unsigned order = claim_.kind == Claim::run ? 16 : 8;
        return Base::at_most("the value is attained", number(state_.value) * sixteenths(m_.delta, order),
                             least_size(change));
    }
    bool has_errors(const Touch<N>& first, const Touch<N>& next, const I& slope) {
        const auto k = static_cast<unsigned>(claim_.exponent);
        const I value = number(state_.value);
        if (leaf_.index == 0)
            return Base::at_most("E1 is attained", value * sixteenths(m_.delta, 32 - 2 * k),
                                 error_of_spin(m_, first, kappa_0_));
        return Base::at_most("E2 is attained", I(2) * value * sixteenths(m_.delta, 32 - k),
                             least_size(error_of_height(m_, first, climb_, kappa_0_, slope, next.x)));
    }
    /// At most the size of any number of the interval.
    [[nodiscard]] static I least_size(const I& x) { return I(std::max(N(0), std::max(x.lo, -x.hi))); }

    const Claim::Attained& state_;
    const I climb_, kappa_0_;
};

}  // namespace

const char* check_attained(const Leaf& leaf, Log* log) { return judged<OrbitCheck>(leaf, log); }

}  // namespace dumbbell_verify::adiabatic
