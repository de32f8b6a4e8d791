// The rule of cells (L87): the lower and the upper side of a rectangle of bodies bound N.
#pragma once
#include "verify/core/big.hpp"
#include "verify/core/section.hpp"
#include "verify/sections/corner.hpp"
#include "verify/sections/valley.hpp"

namespace dumbbell_verify {

/// What is claimed of a rectangle of bodies, and by which orbits.
struct Cell {
    std::uint64_t line = 0;
    unsigned bits = 53;
    bool multiple = false;
    Box box;                                              ///< the last two sides: Q, rho
    mpz_class upper, lower, j;                            ///< U, V
    mpq_class p;                                          ///< of the orbit that shows V
    mpz_class end;                                        ///< J is less
    std::vector<std::pair<mpz_class, mpq_class>> orbits;  ///< that show U: x, p
};

template <class N>
class CellRule : Valley<N> {
    using Base = Valley<N>;
    using Base::fact, Base::one, Base::outward_from_above, Base::outward_from_below, Base::over_bridge,
        Base::zero;
    using typename Base::I, typename Base::Ray;

  public:
    CellRule(const Cell& cell, Log* log) : Base(log), cell_(cell) {}

    const char* verdict() {
        if (!(r_top > zero && rho0.lo > zero)) return "r or rho is out of the range of this precision";
        return at_most_upper() && at_least_lower() ? nullptr : Base::failed();
    }

  private:
    static bool may_have(const mpz_class& n, const mpq_class& rho, const mpq_class& q) {
        return n > most_in_corner || corner_has(n, rho, q);
    }

    /// At Q = B.
    bool at_most_upper() {
        const mpq_class &R0 = cell_.box.lo[3], &R1 = cell_.box.hi[3], &B = cell_.box.hi[2];
        const auto& orbits = cell_.orbits;
        const mpz_class half = (cell_.upper - 1) / 2, &end = cell_.end;
        mpz_class x = 0;
        for (std::size_t i = 0; i <= orbits.size(); ++i) {
            const mpz_class &next = i < orbits.size() ? orbits[i].first : end, most = half + 1 - next;  // a_i
            if (!fact("x grows", x < next) || !fact("0 <= a", most >= 0)) return false;
            if (!(i == 0 ? R0 == 1 || Base::at_most("k0 <= a", {rho0.lo, zero, r_top}, most)
                         : orbit_at_most(x, orbits[i - 1].second, most)))
                return false;
            x = next;
        }
        return fact("J < x at (R1, B)",
                    !may_have(2 * end + 1, R1, B) || Base::corner_hits_at_most(end - 1, rho1, r_top)) &&
               (mpz_even_p(cell_.upper.get_mpz_t()) != 0 || !may_have(2 * end, R1, B) ||
                Base::even_at_most(end - 1, rho1, r_top, half - end));
    }
    bool orbit_at_most(const mpz_class& j, const mpq_class& p, const mpz_class& most) {
        Ray ray;
        return fact("Y is followed at (R1, B)",
                    outward_from_below(j, bound(down, p, zero), rho1, r_top, ray)) &&
               Base::at_most("G(Y) <= a", over_bridge(down, ray), most) &&
               (p == 0 || fact("Y hits the bridge at (R0, B)",
                               outward_from_above(j, bound(up, p, zero), rho0,
                                                  bound(up, 1 / cell_.box.hi[2], zero), ray) &&
                                   Base::hits_bridge(ray, rho0)));
    }

    /// At Q = A.
    bool at_least_lower() {
        const mpq_class &R0 = cell_.box.lo[3], &A = cell_.box.lo[2];
        const mpz_class &j = cell_.j, &V = cell_.lower, rest = V / 2 - j;
        if (j == 0)
            return V <= most_in_corner && corner_has(V, R0, A)
                       ? fact("V <= ceil(pi/corner) at (R0, A)", true)
                       : (mpz_odd_p(V.get_mpz_t()) != 0
                              ? Base::at_least("k0 >= (V - 1)/2", {rho1.hi, zero, r_bottom}, rest)
                              : through_corner(rest - 1));
        Ray ray;
        return fact("2 j + 1 <= ceil(pi/corner) at (R0, A)",
                    2 * j < most_in_corner && corner_has(2 * j + 1, R0, A)) &&
               fact("0 < p", cell_.p > 0) &&
               fact("Y exists at (R0, A)",
                    outward_from_above(j, bound(up, cell_.p, zero), rho0, r_bottom, ray)) &&
               Base::at_least("G(Y) >= V/2 - j", over_bridge(up, ray), rest) &&
               fact("Y passes the bridge at (R1, A)",
                    outward_from_below(j, bound(down, cell_.p, zero), rho1, bound(down, 1 / A, zero), ray) &&
                        Base::passes_bridge(ray, rho1));
    }
    /// The even motion of J = 0: one reflection of the wedge's ray.
    bool through_corner(const mpz_class& least) {
        const I kappa = -rho0.lo, r = r_bottom, D = I(1) - I(2) * kappa - r,
                top = kappa + I(2) * r - r * kappa;
        if (!fact("the wedge's ray goes to the left", D.lo > zero)) return false;
        return Base::at_least("k1 >= V/2 - 1", over_bridge(up, {zero, rho1.hi, r_bottom}), least) &&
               Base::at_least("T >= V/2 - 1", over_bridge(up, {zero, div(up, top.hi, D.lo), r_bottom}),
                              least);
    }

    const Cell& cell_;
    const I rho0{bound(down, cell_.box.lo[3], zero), bound(up, cell_.box.lo[3], zero)},
        rho1{bound(down, cell_.box.hi[3], zero), bound(up, cell_.box.hi[3], zero)};
    const N r_top = bound(down, 1 / cell_.box.hi[2], zero), r_bottom = bound(up, 1 / cell_.box.lo[2], zero);
};

}  // namespace dumbbell_verify
