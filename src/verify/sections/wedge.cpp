// The scenes wedge and hybrid (format-sections.md, section 3; L17, L18): exact rational arithmetic, so a tie
// is a tie. The hybrid wedge has the same maximum, a cover and a witness of the straight one prove it.
#include <algorithm>
#include <stdexcept>

#include "verify/core/section.hpp"
#include "verify/machine/integer.hpp"
#include "verify/machine/meter.hpp"

namespace dumbbell_verify {
namespace {

constexpr unsigned most_wedge_collisions = 10'000;  ///< a + b
constexpr std::size_t most_bits = 4'000'000;        ///< of a numerator

/// kappa of a ray, and r, as integers: kappa = top / bottom, bottom > 0; r = light / heavy. Not reduced.
class Wedge {
  public:
    Wedge(const Leaf& leaf, Log* log) : leaf_(leaf), log_(log) {
        if (log)
            log->text += "  exact, claimed " + leaf.claimed.get_str() + "\n  lambda in [" + y0.get_str() +
                         ", " + y1.get_str() + "]\n  q in [" + leaf.box.lo[2].get_str() + ", " +
                         leaf.box.hi[2].get_str() + "]\n";
    }

    const char* verdict() {
        if (leaf_.opcode == outside)
            return fact("1 <= r_lo lambda0", r_lo * y0 >= 1) ||
                           fact("2 < lambda0 (1 - r_hi)", y0 * (1 - r_hi) > 2)
                       ? nullptr
                       : "a reason of `outside`";
        return (leaf_.opcode == count_leaf ? counts() : leaf_.opcode == witness && witness_counts())
                   ? nullptr
                   : failed_;
    }

  private:
    bool fact(const char* what, bool holds) {
        if (!holds) failed_ = what;
        if (log_) log_->fact(what, holds);
        return holds;
    }
    /// G_w(kappa, r), or limit + 1 if it is greater than the limit.
    unsigned count(const mpq_class& kappa, const mpq_class& r, const mpz_class& hint) {
        const auto limit = static_cast<unsigned>(unsigned_64(hint));  // it is small
        const mpz_class &light = r.get_num(), &heavy = r.get_den(), rest = heavy - light;
        mpz_class top = kappa.get_num(), bottom = kappa.get_den();
        unsigned n = 0;
        while (n <= limit && top < bottom) {
            ++n;
            Meter::spend(products(bottom, heavy));
            const mpz_class divisor = bottom * rest - 2 * top * heavy;  // D bottom heavy
            if (divisor <= 0) break;
            top = top * rest + 2 * light * bottom;
            bottom = divisor;
            if (mpz_sizeinbase(top.get_mpz_t(), 2) + mpz_sizeinbase(bottom.get_mpz_t(), 2) > most_bits)
                throw std::length_error("exact numbers of more than 4,000,000 bits");
        }
        if (log_)
            log_->text += "  kappa " + std::to_string(kappa.get_d()) + ": " +
                          (n > limit ? "more than " : "") + std::to_string(std::min(n, limit)) +
                          " collision(s)\n";
        return n;
    }
    /// The work of a few products of numbers of this size.
    static std::uint64_t products(const mpz_class& a, const mpz_class& b) {
        return 1024 + 16 * limbs(a) * limbs(b);
    }
    [[nodiscard]] bool hints_are_small() const {
        if (leaf_.a > most_wedge_collisions || leaf_.b > most_wedge_collisions ||
            leaf_.a + leaf_.b > most_wedge_collisions)
            throw std::length_error("a + b beyond 10,000 in a wedge");
        return true;
    }
    static mpq_class divisor(const mpq_class& lambda, const mpq_class& r) { return 1 + 2 * r * lambda - r; }
    static mpq_class numerator(const mpq_class& lambda, const mpq_class& r) {
        return 2 + r * lambda - lambda;
    }

    bool counts() {
        if (!fact("1 + a + b <= U", 1 + leaf_.a + leaf_.b <= leaf_.claimed) || !hints_are_small() ||
            !fact("G_w <= a for X", count(r_lo * y0, r_lo, leaf_.a) <= leaf_.a))
            return false;
        const mpq_class d = divisor(y1, r_lo), p = numerator(y1, r_lo);
        mpq_class mu = 0;
        if (d > 0 && p > 0) mu = p / d;
        return fact("G_w <= b for sigma X", count(r_lo * mu, r_lo, leaf_.b) <= leaf_.b);
    }
    bool witness_counts() {
        const auto returns = [&](const mpq_class& r) { return divisor(y0, r) > 0 && numerator(y0, r) >= 0; };
        return fact("the first value is 0", leaf_.box.lo[0] == 0) && fact("0 <= lambda", y0 >= 0) &&
               fact("r_hi lambda < 1", r_hi * y0 < 1) &&
               fact("0 < 1 + 2 r lambda - r, 0 <= 2 + r lambda - lambda", returns(r_lo) && returns(r_hi)) &&
               fact("V <= 1 + a + b", leaf_.claimed <= 1 + leaf_.a + leaf_.b) && hints_are_small() &&
               fact("a <= G_w for X", count(r_hi * y0, r_hi, leaf_.a) >= leaf_.a) &&
               fact("b <= G_w for sigma X",
                    count(r_hi * numerator(y0, r_hi) / divisor(y0, r_hi), r_hi, leaf_.b) >= leaf_.b);
    }

    const Leaf& leaf_;
    Log* log_;
    const char* failed_ = "";
    const mpq_class &y0 = leaf_.box.lo[1], &y1 = leaf_.box.hi[1];
    const mpq_class r_lo = 1 / leaf_.box.hi[2], r_hi = 1 / leaf_.box.lo[2];
};

Box wedge_root(std::size_t, const mpq_class& a, const mpq_class& b) {
    return {{0, 0, a}, {0, power_of_two(b), b}};
}

const char* check_wedge(const Leaf& leaf, Log* log) { return Wedge(leaf, log).verdict(); }

Section section(std::string_view scene) {
    return {"1",
            scene,
            "turning",
            "wedge",
            {{"wedge", {"", "lambda", "q"}}},
            {{"count", Place::leaf, 1, 2},
             {"outside", Place::leaf, 1, 0},
             {"meets", Place::leaf, 0, 0},
             {"meets-reversed", Place::leaf, 0, 0},
             {"equal-masses", Place::cover, 0, 0},
             {"witness", Place::witness, 1, 2}},
            wedge_root,
            check_wedge};
}

}  // namespace

const Section& wedge() {
    static const Section result = section("wedge");
    return result;
}
const Section& hybrid() {
    static const Section result = section("hybrid");
    return result;
}

}  // namespace dumbbell_verify
