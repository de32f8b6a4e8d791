// The section tangents of the scene body (format-sections.md, section 5; Theorem B, L82): the tangents of the
// bridge to the left, f, and into the valley, b, over the places e. Bounds from below, of one orbit each.
#include "verify/core/big.hpp"
#include "verify/sections/bridge.hpp"
#include "verify/sections/corner.hpp"

namespace dumbbell_verify {
namespace {

template <class N>
class Tangents : Bridge<N> {
    using Base = Bridge<N>;
    using Base::fact, Base::half_turn, Base::one, Base::quarter, Base::zero, Base::leaf_;
    using Base::rho_hi, Base::rho_lo, Base::r_lo, Base::x0, Base::x1;
    using typename Base::I, typename Base::Ray;

  public:
    Tangents(const Leaf& leaf, Log* log) : Base(leaf, tangents(), log) {}

    const char* verdict() {
        if (!(r_lo > zero && rho_lo > zero)) return "r or rho is out of the range of this precision";
        const bool holds = leaf_.opcode == outside ? Base::less("pi/2 < e0", quarter, x0) : counts();
        return holds ? nullptr : Base::failed();
    }

  private:
    bool counts() {
        const mpq_class& lowest = leaf_.box.lo[3];
        return fact("R0 = R1", lowest == leaf_.box.hi[3]) &&
               fact("2 (a + b) < U", 2 * (leaf_.a + leaf_.b) < leaf_.claimed) &&
               (lowest == 1 ||  // f = 0: over the top all is as high as the peaks
                Base::at_most("f(e1) <= a", x1 < quarter.lo ? upward() : Ray{rho_lo, zero, r_lo}, leaf_.a)) &&
               (leaf_.box.lo[0] > 0 ? fact("b(e0) <= b", hits_at_most(into_valley(), leaf_.b)) : corner());
    }
    /// At e = 0, J takes the place of b; and where U is odd the even value of Theorem B must not be reached.
    bool corner() {
        const mpq_class &lowest = leaf_.box.lo[3], &q = leaf_.box.hi[2];
        const mpz_class n = 2 * leaf_.b + 3, room = (leaf_.claimed - 1) / 2 - leaf_.b - 1;
        return fact("J <= b", hits_at_most(along_bridge(), leaf_.b) ||
                                  (n <= most_in_corner && !corner_has(n, lowest, q))) &&
               (mpz_even_p(leaf_.claimed.get_mpz_t()) != 0 || even_at_most(room) ||
                fact("ceil(pi/corner) <= 2 b + 1", n - 1 <= most_in_corner && !corner_has(n - 1, lowest, q)));
    }

    [[nodiscard]] Ray upward() const {
        const auto [s, w] = sin_cos(x1);
        const I rho(rho_lo, rho_hi);
        return {(rho * (s + (half_turn - x1) * w)).lo, (rho * w).lo, r_lo};
    }
    [[nodiscard]] Ray into_valley() const {
        const auto [s, w] = sin_cos(x0);
        const I rho(rho_lo, rho_hi);
        return {std::max(zero, (rho * (s - I(x0) * w)).lo), (-(rho * w)).lo, r_lo};
    }
    /// c = 0.
    [[nodiscard]] Ray along_bridge() const { return {zero, -rho_hi, r_lo}; }

    enum class Bounce { returns, leaves, misses, undecided };
    /// The bound `ray` from below, of flights from wall to wall, at the wall of height h: 1, or rho.
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
    /// Certified: no flight above `ray` hits the bridge more than `most` times.
    bool hits_at_most(Ray ray, const mpz_class& most) {
        N right = zero, left = zero;
        for (mpz_class hits = 0;; ++hits) {
            if (this->log_) this->log_->ray(hits, {{": c ", I(ray.c)}, {" kappa ", I(ray.kappa)}});
            const Bounce at_wall = bounce(ray, I(1), right);
            if (at_wall != Bounce::returns) return at_wall != Bounce::undecided;
            const Bounce at_bridge = bounce(ray, I(rho_lo, rho_hi), left);
            if (at_bridge == Bounce::misses) return true;
            if (hits == most) return false;
            if (at_bridge != Bounce::returns) return at_bridge == Bounce::leaves;
        }
    }
    /// Certified T <= most, if J is b.
    bool even_at_most(const mpz_class& most) {
        Ray ray = along_bridge();
        N z = zero;
        for (mpz_class left = 2 * leaf_.b + 1; left > 0; --left) {
            const Bounce done = bounce(ray, mpz_odd_p(left.get_mpz_t()) != 0 ? I(1) : I(rho_lo, rho_hi), z);
            if (done == Bounce::undecided) return false;
            if (done != Bounce::returns) return fact("T = 0 <= a number", most >= 0);
        }
        return Base::at_most("T <= (U - 1)/2 - b - 1", {(half_turn * I(ray.kappa)).lo, ray.kappa, r_lo},
                             most);
    }
};

Box tangents_root(std::size_t /*chart*/, const mpq_class& a, const mpq_class& b) {
    return {{0, 0, a}, {2, 0, b}};
}

/// The witness is that of the least Q: greater ones have as many (L83).
const char* check_tangents(const Leaf& leaf, Log* log) {
    if (leaf.opcode != witness) return judged<Tangents>(leaf, log);
    Leaf least = leaf;
    least.box.hi[2] = least.box.lo[2];
    return body().check(least, log);
}

}  // namespace

const Section& tangents() {
    static const Section section = {"body",
                                    "body",
                                    "tangents",
                                    "bridge",
                                    {{"tangent", {"e", "", "q", "rho"}}},
                                    {{"count", Place::leaf, 1, 2},
                                     {"outside", Place::leaf, 1, 0},
                                     {"meets", Place::leaf, 0, 0},
                                     {"meets-reversed", Place::leaf, 0, 0},
                                     {"equal-masses", Place::cover, 0, 0},
                                     {"witness", Place::witness, 3, 2}},
                                    tangents_root,
                                    check_tangents,
                                    false,
                                    "corner",
                                    true};
    return section;
}

}  // namespace dumbbell_verify
