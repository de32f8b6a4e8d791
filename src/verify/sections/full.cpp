// The section full (format-sections.md, section 1; L15): all collision states, counted forward
// along a lowest and a highest ray of the box.
#include "verify/core/big.hpp"
#include "verify/sections/bridge.hpp"

namespace dumbbell_verify {
namespace {

template <class N>
class Full : Bridge<N> {
    using Base = Bridge<N>;
    using Base::fact, Base::less, Base::at_most, Base::contact_ray, Base::trig, Base::half_turn,
        Base::quarter, Base::one, Base::zero, Base::leaf_;
    using Base::x0, Base::x1, Base::y0, Base::y1, Base::r_lo, Base::r_hi;
    using typename Base::I, typename Base::Ray;

  public:
    Full(const Leaf& leaf, Log* log) : Base(leaf, full(), log) {}

    const char* verdict() {
        return Base::judge([this] {
            return fact("1 + a <= U", 1 + leaf_.a <= leaf_.claimed) &&
                   (leaf_.chart == contact ? at_most("G <= a behind the bridge", contact_ray(x1, y0), leaf_.a)
                                           : departures());
        });
    }

  private:
    /// A bound, on one side, of the states after a collision with R or (mirrored) L at corner distance x.
    struct State {
        N x, sine, kappa;
        /// Bound of the height at t behind the corner's vertical (L15 (a)).
        [[nodiscard]] N height(Round d, const I& t) const {
            const I y = I(sine) + I(kappa) * (I(x) + t);
            return d == down ? y.lo : y.hi;
        }
    };

    bool departures() {
        State low, high;
        low.x = std::min(x0, quarter.lo);
        const auto at_low = sin_cos(low.x);
        low.sine = at_low.sin.lo;
        low.kappa = (y0 - at_low.cos).lo;
        const bool top = !(x1 < quarter.lo);
        const auto at_high = top ? SinCos<I>{I(1), I(0)} : sin_cos(x1);
        high.x = top ? quarter.hi : x1;
        high.sine = at_high.sin.hi;
        high.kappa = std::min(one, (y1 - at_high.cos).hi);
        N z = zero, z_high = zero;
        for (mpz_class n = 0;; ++n) {  // m <= a is certified where m arises
            Work::collision();
            if (this->log_)
                this->log_->line({{("  " + n.get_str() + ": x ").c_str(), I(low.x, high.x)},
                                  {" kappa ", I(low.kappa, high.kappa)}});
            if (low.kappa >= one) return fact("steep", true);
            Ray ray{std::max(zero, low.height(down, half_turn)), low.kappa, r_lo};
            if (low.kappa >= r_hi) return at_most("n + G <= a above the bridge", ray, leaf_.a - n);
            const N h = low.height(down, zero);
            if (!Base::certainly_above(h, low.kappa)) {
                const auto met = Base::contacts(low.kappa, high.height(up, zero), high.kappa);
                if (!fact("n + 1 <= a at the bridge", n + 1 <= leaf_.a) ||
                    !at_most("n + 1 + G <= a for the tangent ray", contact_ray(met.last, zero),
                             leaf_.a - n - 1))
                    return false;
                if (met.all) return true;
            }
            const bool seems_to_hit = guess_root(ray.c, ray.kappa, z);
            if ((!seems_to_hit || n == leaf_.a) && Base::misses(ray)) return fact("misses the wall", true);
            if (!fact("n + 1 <= a at the wall", n + 1 <= leaf_.a)) return false;
            const bool both = low_returns(low, ray, z);
            if (!both) return fact("D > 0 or D <= 0 is decided", decided_);
            follow_high(high, z_high);
        }
    }
    /// The lowest ray's next state; false if none returns (decided_), or if that is not decided.
    bool low_returns(State& low, const Ray& ray, const N& z) {
        const auto at = Base::earliest(ray, z);
        const I w = at.cosine, kappa = ray.kappa, r = r_lo;
        const I D = w * w - I(2) * kappa * w - r, top = kappa * w * w + I(2) * r * w - r * kappa;
        decided_ = D.lo > zero || D.hi <= zero;
        if (!(D.lo > zero)) return false;
        low = {at.x, std::max(zero, at.sine), (top / D).lo};
        return true;
    }
    /// The highest ray's next state; (pi/2, 1) is above all that stay in play.
    void follow_high(State& high, N& z) {
        const Ray ray{std::max(zero, high.height(up, half_turn)), high.kappa, r_hi};
        high = {quarter.hi, one, one};
        if (!(ray.kappa < one && guess_root(ray.c, ray.kappa, z))) return;
        const auto at = Base::latest(ray, z);
        if (!at) return;
        const I w = at->cosine, kappa = ray.kappa, r = r_hi;
        const I D = w * w - I(2) * kappa * w - r, top = kappa * w * w + I(2) * r * w - r * kappa;
        // Exactly the slope would be > -w (N.v' > 0); so heights grow up to this x.
        high = {at->x, std::min(one, at->sine),
                D.lo > zero ? std::max(-at->cosine, std::min(one, (top / D).hi)) : one};
    }

    bool decided_ = false;
};

const char* check_full(const Leaf& leaf, Log* log) {
    if (leaf.opcode == equal_masses || leaf.opcode == witness) return turning().check(leaf, log);
    return judged<Full>(leaf, log);
}

}  // namespace

const Section& full() {
    static const Section section = full_section("1", check_full);
    return section;
}

}  // namespace dumbbell_verify
