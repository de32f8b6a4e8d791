// The section tangents of the scene body (format-sections.md, section 5; Theorem B, L82): the tangents of the
// bridge to the left, f, and into the valley, b, over the places e. Bounds from below, of one orbit each.
#include "verify/core/big.hpp"
#include "verify/core/section.hpp"
#include "verify/sections/corner.hpp"
#include "verify/sections/valley.hpp"

namespace dumbbell_verify {
namespace {

template <class N>
class Tangents : Valley<N> {
    using Base = Valley<N>;
    using Base::fact, Base::half_turn, Base::hits_at_most, Base::one, Base::quarter, Base::zero;
    using typename Base::I, typename Base::Ray;

  public:
    Tangents(const Leaf& leaf, Log* log) : Base(log), leaf_(leaf) {
        if (log) log->box(leaf, tangents().charts[0], bits(zero));
    }

    const char* verdict() {
        if (!(r > zero && rho.lo > zero)) return "r or rho is out of the range of this precision";
        const bool holds = leaf_.opcode == outside ? Base::less("pi/2 < e0", quarter, x0) : counts();
        return holds ? nullptr : Base::failed();
    }

  private:
    bool counts() {
        const mpq_class& lowest = leaf_.box.lo[3];
        return fact("R0 = R1", lowest == leaf_.box.hi[3]) &&
               fact("2 (a + b) < U", 2 * (leaf_.a + leaf_.b) < leaf_.claimed) &&
               (lowest == 1 ||  // f = 0: over the top all is as high as the peaks
                Base::at_most("f(e1) <= a", x1 < quarter.lo ? upward() : Ray{rho.lo, zero, r}, leaf_.a)) &&
               (leaf_.box.lo[0] > 0 ? fact("b(e0) <= b", hits_at_most(into_valley(), rho, leaf_.b))
                                    : corner());
    }
    /// At e = 0, J takes the place of b; and where U is odd the even value of Theorem B must not be reached.
    bool corner() {
        const mpq_class &lowest = leaf_.box.lo[3], &q = leaf_.box.hi[2];
        const mpz_class n = 2 * leaf_.b + 3, room = (leaf_.claimed - 1) / 2 - leaf_.b - 1;
        return fact("J <= b", hits_at_most(Base::along_bridge(rho, r), rho, leaf_.b) ||
                                  (n <= most_in_corner && !corner_has(n, lowest, q))) &&
               (mpz_even_p(leaf_.claimed.get_mpz_t()) != 0 || Base::even_at_most(leaf_.b, rho, r, room) ||
                fact("ceil(pi/corner) <= 2 b + 1", n - 1 <= most_in_corner && !corner_has(n - 1, lowest, q)));
    }

    [[nodiscard]] Ray upward() const {
        const auto [s, w] = sin_cos(x1);
        return {(rho * (s + (half_turn - x1) * w)).lo, (rho * w).lo, r};
    }
    [[nodiscard]] Ray into_valley() const {
        const auto [s, w] = sin_cos(x0);
        return {std::max(zero, (rho * (s - I(x0) * w)).lo), (-(rho * w)).lo, r};
    }

    const Leaf& leaf_;
    const N x0 = bound(down, leaf_.box.lo[0], zero), x1 = bound(up, leaf_.box.hi[0], zero);
    const N r = bound(down, 1 / leaf_.box.hi[2], zero);
    const I rho{bound(down, leaf_.box.lo[3], zero), bound(up, leaf_.box.hi[3], zero)};
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
