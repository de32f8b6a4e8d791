// The valley between R and the right half of the bridge (L79, L82, L86): bounds of flights from wall to wall,
// and how often they hit the bridge. Heights are 1 for R and rho for the bridge; rho encloses one number.
#pragma once
#include "verify/core/ray.hpp"

namespace dumbbell_verify {

template <class N>
class Valley : protected Rays<N> {
  protected:
    using Base = Rays<N>;
    using Base::fact, Base::half_turn, Base::one, Base::quarter, Base::zero;
    using typename Base::I, typename Base::Ray;
    /// Where a contact is looked for, at R and at the bridge.
    struct Guesses {
        N right{0}, left{0};
    };

    explicit Valley(Log* log) : Base(log) {}

    enum class Bounce { returns, leaves, misses, undecided };
    /// The bound `ray` from below, at the wall of height h.
    Bounce bounce(Ray& ray, const I& h, N& z) {
        Work::collision();
        const Ray scaled{(I(ray.c) / h).lo, (I(ray.kappa) / h).lo, ray.r};
        if (scaled.kappa >= one) return Bounce::misses;
        if (!guess_root(scaled.c, scaled.kappa, z)) {
            if (Base::misses(scaled)) return Bounce::misses;
            z = zero;
        }
        const auto at = Base::earliest(scaled, z);
        const I kappa = ray.kappa, r = ray.r, w = (h * at.cosine).hi;
        const I D = w * (w - (kappa + kappa)) - r, top = kappa * (w * w - r) + I(2) * r * w;
        if (this->log_) this->log_->there({{"  at ", I(at.x)}, {"  D ", D}, {"  P ", top}});
        if (D.hi <= zero) return Bounce::leaves;
        if (!(D.lo > zero || top.lo >= zero)) return Bounce::undecided;
        // The quotient is least at the other end of D where P may be negative.
        ray.kappa = div(down, top.lo, top.lo >= zero ? D.hi : D.lo);
        ray.c = std::max(zero, (h * at.sine + I(ray.kappa) * at.x).lo);
        return Bounce::returns;
    }
    /// Certified: J <= most, by the straight wedge's ray along the bridge (L82).
    bool corner_hits_at_most(const mpz_class& most, const I& rho, const N& r) {
        Ray ray;
        const Bounce last = along_bridge(most, rho, r, ray);
        return last == Bounce::returns ? passes_bridge(ray, rho) : last != Bounce::undecided;
    }
    /// Certified: T <= most, if J is `hits`.
    bool even_at_most(const mpz_class& hits, const I& rho, const N& r, const mpz_class& most) {
        Ray ray;
        const Bounce last = along_bridge(hits, rho, r, ray);
        if (last == Bounce::undecided) return false;
        if (last != Bounce::returns) return fact("T = 0 <= a number", most >= 0);
        return Base::at_most("T <= a number", over_bridge(down, ray), most);
    }

    /// Y_j(p) from below, for this rho or lesser ones and r or greater ones; false: none is known.
    bool outward_from_below(const mpz_class& j, const N& p, const I& rho, const N& r, Ray& ray) {
        const I h = wall(j, rho);
        Guesses at;
        const Ray level{(I(p) / h).lo, zero, r};
        if (!guess_root(level.c, level.kappa, at.left)) return false;
        const auto from = Base::earliest(level, at.left);
        const N kappa = div(down, r, (h * from.cosine).hi);
        ray = {(p + I(kappa) * from.x).lo, kappa, r};
        for (mpz_class i = j + 1; i < 2 * j; ++i) {
            look_at(ray, i);
            if (bounce(ray, wall(i, rho), mpz_odd_p(i.get_mpz_t()) != 0 ? at.right : at.left) !=
                Bounce::returns)
                return false;
        }
        return true;
    }
    /// The same from above, for this rho or greater ones and r or lesser ones, of which all have it.
    bool outward_from_above(const mpz_class& j, const N& p, const I& rho, const N& r, Ray& ray) {
        const I h = wall(j, rho);
        Guesses at;
        const auto from = contact_from_above({p, zero, r}, h, at.left);
        if (!from) return false;
        const N kappa = div(up, r, (h * from->cosine).lo);
        ray = {(p + I(kappa) * from->x).hi, kappa, r};
        for (mpz_class i = j + 1; i < 2 * j; ++i) {
            look_at(ray, i);
            if (!bounce_from_above(ray, wall(i, rho), mpz_odd_p(i.get_mpz_t()) != 0 ? at.right : at.left))
                return false;
        }
        return true;
    }
    /// Certified: all flights to the left below `ray` hit the bridge; all above it pass it.
    bool hits_bridge(const Ray& ray, const I& rho) {
        N z = zero;
        return contact_from_above(ray, rho, z).has_value();
    }
    bool passes_bridge(const Ray& ray, const I& rho) {
        const Ray scaled{(I(ray.c) / rho).lo, (I(ray.kappa) / rho).lo, ray.r};
        return scaled.kappa >= one || Base::misses(scaled);
    }
    /// A flight to the left, at the next corner.
    [[nodiscard]] Ray over_bridge(Round d, const Ray& ray) const {
        const I c = ray.c + half_turn * I(ray.kappa);
        return {d == down ? c.lo : c.hi, ray.kappa, ray.r};
    }

  private:
    /// That ray behind 2 hits + 1 bounces, or what becomes of it before.
    Bounce along_bridge(const mpz_class& hits, const I& rho, const N& r, Ray& ray) {
        ray = {zero, -rho.hi, r};
        Bounce last = Bounce::returns;
        N z = zero;
        for (mpz_class left = 2 * hits + 1; left > 0 && last == Bounce::returns; --left)
            last = bounce(ray, wall(left, rho), z);
        return last;
    }
    static I wall(const mpz_class& number, const I& rho) {
        return mpz_odd_p(number.get_mpz_t()) != 0 ? I(1) : rho;
    }
    void look_at(const Ray& ray, const mpz_class& number) {
        if (this->log_) this->log_->ray(number, {{": c ", I(ray.c)}, {" kappa ", I(ray.kappa)}});
    }
    auto contact_from_above(const Ray& ray, const I& h, N& z) -> decltype(Base::latest(ray, z)) {
        const Ray scaled{(I(ray.c) / h).hi, (I(ray.kappa) / h).hi, ray.r};
        if (!(scaled.kappa < one && guess_root(scaled.c, scaled.kappa, z))) return std::nullopt;
        return Base::latest(scaled, z);
    }
    bool bounce_from_above(Ray& ray, const I& h, N& z) {
        Work::collision();
        const auto at = contact_from_above(ray, h, z);
        if (!at) return false;
        const I kappa = ray.kappa, r = ray.r, w = (h * at->cosine).lo;
        const I D = w * (w - (kappa + kappa)) - r, top = kappa * (w * w - r) + I(2) * r * w;
        if (this->log_) this->log_->there({{"  at ", I(at->x)}, {"  D ", D}, {"  P ", top}});
        if (!(w.lo > zero && D.lo > zero)) return false;
        ray.kappa = div(up, top.hi, D.lo);
        ray.c = (h * at->sine + I(ray.kappa) * at->x).hi;
        return true;
    }
};

}  // namespace dumbbell_verify
