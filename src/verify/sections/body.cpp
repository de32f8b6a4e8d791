// The scene body (format-sections.md, section 4; L71 to L75): a rod with mass, a coin. And the section plain
// of the dumbbell (section 2; L16), which has rho = r and g = 1; a file spells it `lemmas minimal`, `section
// full`.
#include "verify/core/big.hpp"
#include "verify/machine/integer.hpp"
#include "verify/machine/meter.hpp"
#include "verify/sections/corner.hpp"
#include "verify/sections/flights.hpp"

namespace dumbbell_verify {
namespace {

constexpr std::size_t symmetric = witness + 1;  // opcode
constexpr std::size_t in_corner = 1;            // the second kind of witness

template <class N>
class Body : Flights<N> {
    using Base = Flights<N>;
    using Base::fact, Base::less, Base::height, Base::leaf_, Base::x0, Base::x1, Base::y0, Base::y1;
    using Base::half_turn, Base::one, Base::quarter, Base::r, Base::rho, Base::zero;
    using typename Base::I, typename Base::Flight, typename Base::Ray;

  public:
    Body(const Leaf& leaf, Log* log) : Base(leaf, leaf.box.lo[3] > 0 ? body() : plain(), log) {}

    const char* verdict() {
        return Base::judge([this] { return leaf_.opcode == witness ? witness_counts() : Base::counts(); });
    }

  private:
    /// L74.
    bool witness_counts() {
        const auto low = sin_cos(x0), high = sin_cos(x1);
        const I e(x0, x1), eta(y0, y1), sine(low.sin.lo, high.sin.hi), s(high.cos.lo, low.cos.hi);
        const I R = square(rho) / r, base = I(1) + R * square(s);
        const auto ray = [&](const I& lambda, const I& way) {
            return Flight{true, false, rho * lambda, {}, {}, rho * (sine + lambda * way)};
        };
        return less("0 < e", zero, e) && less("e < pi/2", e, quarter) && less("0 < eta", zero, eta) &&
               fact("V <= 1 + a + b", leaf_.claimed <= 1 + leaf_.a + leaf_.b) &&
               fact("a later collisions of X", at_least(leaf_.a, ray(s + eta, half_turn - e))) &&
               fact("b later collisions of sigma X",
                    at_least(leaf_.b, ray(eta * base / (base + I(2) * R * s * eta) - s, e)));
    }
    /// Certified: all have so many later collisions.
    bool at_least(const mpz_class& count, Flight f) {
        for (N z = zero, z_high = zero; f.n < count; ++f.n) {
            Work::collision();
            if (this->log_) this->log_->line({{("  " + f.n.get_str() + ": kappa ").c_str(), f.kappa}});
            const bool enough = f.n + 1 == count;
            if (!f.is_ray) {
                const I h = Base::not_negative(height(f, I(0)));
                if (!Base::certainly_above(h.lo, f.kappa.lo)) {
                    const auto met = Base::contacts(f.kappa.lo, h.hi, f.kappa.hi);
                    if (!met.all || enough) return met.all;
                    const auto at = Base::rebound(h, f.kappa, met.last);
                    const bool left = at.E.lo > zero;
                    if (!left && !(at.E.hi < zero)) return false;
                    f = Base::ray_behind(at, left, at.P / (left ? at.E : -at.E), f.n);
                    continue;
                }
                f.c = height(f, half_turn);
                if (!(f.c.lo > zero)) return false;
            }
            f.c = Base::not_negative(f.c);
            const Ray low{f.c.lo, f.kappa.lo, r.lo}, high{f.c.hi, f.kappa.hi, r.hi};
            if (!(high.kappa < one && guess_root(high.c, high.kappa, z_high))) return false;
            const auto last = Base::latest(high, z_high);
            if (!last || enough) return last.has_value();
            guess_root(low.c, low.kappa, z);
            const auto at = Base::wall(low, z, last, f.kappa);
            if (!(at.D.lo > zero)) return false;
            f = {false, false, Base::slope_behind(at, f.kappa), at.x, at.sine, {}, std::move(f.n)};
        }
        return true;
    }
};

const char* check_corner(const Leaf& leaf, Log* log) {
    const char* failed = nullptr;
    const auto fact = [&](const char* what, bool holds) {
        if (!holds) failed = what;
        if (log) log->fact(what, holds);
        return holds;
    };
    const mpq_class &lowest = leaf.box.lo[3], &greatest = leaf.box.hi[3];
    if (leaf.opcode == symmetric)
        fact("R0 = R1 = 1", lowest == 1 && greatest == 1) &&
            fact("ceil(pi/corner) <= U", !corner_has(leaf.claimed + 1, greatest, leaf.box.hi[2]));
    else
        fact("the values are 0b0 0b0 a 0", leaf.box.lo[0] == 0 && leaf.box.lo[1] == 0 && leaf.b == 0) &&
            fact("V <= 1 + a", leaf.claimed <= 1 + leaf.a) &&
            fact("1 + a <= ceil(pi/corner)", corner_has(1 + leaf.a, lowest, leaf.box.lo[2]));
    return failed;
}

const char* check_body(const Leaf& leaf, Log* log) {
    if (leaf.opcode == symmetric || (leaf.opcode == witness && leaf.chart == in_corner))
        return check_corner(leaf, log);
    return judged<Body>(leaf, log);
}

const char* check_plain(const Leaf& leaf, Log* log) {
    if (leaf.opcode == equal_masses || leaf.opcode == witness) return turning().check(leaf, log);
    return judged<Body>(leaf, log);
}

}  // namespace

/// b_j > 0 for 0 < j < n. Here a and b are a_j and b_j times the power j
/// of the denominators' product.
bool corner_has(const mpz_class& n, const mpq_class& rho, const mpq_class& q) {
    const mpz_class sum = rho.get_num() + rho.get_den(), step = sum * q.get_den(), back = sum * q.get_num();
    const mpz_class p = q.get_num() * rho.get_num() - q.get_den() * rho.get_den();
    mpz_class a = p, b = step;
    for (int j = 1; j < n; ++j) {
        if (b <= 0) return false;
        if (j > most_in_corner) throw std::length_error("more than 10,000 collisions in the corner");
        Meter::spend(1024 + 16 * (limbs(a) + limbs(b)) * (limbs(step) + limbs(back)));
        const mpz_class next = p * a - back * b;
        b = step * a + p * b;
        a = next;
    }
    return true;
}

const Section& plain() {
    static const Section section = full_section("minimal", check_plain);
    return section;
}

const Section& body() {
    static const Section section = {
        "body",
        "body",
        "full",
        "bridge",
        {{"contact", {"t", "eta", "q", "rho"}}, {"departure", {"e", "eta", "q", "rho"}}},
        {{"count", Place::leaf, 3, 1},
         {"outside", Place::leaf, 3, 0},
         {"meets", Place::leaf, 0, 0},
         {"meets-reversed", Place::leaf, 0, 0},
         {"equal-masses", Place::cover, 0, 0},
         {"witness", Place::witness, 3, 2},
         {"symmetric", Place::cover, 1, 0}},
        full_root,
        check_body,
        false,
        "corner"};
    return section;
}

}  // namespace dumbbell_verify
