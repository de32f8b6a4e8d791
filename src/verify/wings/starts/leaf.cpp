// What a leaf of a box of initial conditions says, certified (format-initial.md, sections 2 to 6).
#include "verify/core/big.hpp"
#include "verify/wings/starts/reflection.hpp"

namespace dumbbell_verify::starts {
namespace {

template <class N>
class Check : FirstReflection<N> {
    using Base = FirstReflection<N>;
    using Base::fact, Base::flight_, Base::log_, Base::zero;
    using typename Base::I;

  public:
    Check(const Leaf& leaf, Log* log) : Base(Flight<N>(leaf.box, leaf.any_spin), log), leaf_(leaf) {
        if (log) describe();
    }

    /// nullptr if all is certified, else what is not.
    const char* verdict() {
        if (!(flight_.r.lo > zero)) return "r is out of the range of this precision";
        return (leaf_.first       ? behind_contact()
                : leaf_.most == 0 ? leaves()
                                  : bounded())
                   ? nullptr
                   : Base::failed();
    }

  private:
    void describe() {
        log_->text += "  " + std::to_string(leaf_.bits) + " bits\n";
        for (std::size_t i = 0; i < axis_names.size(); ++i)
            log_->text += "  " + std::string(axis_names[i]) + " in [" + leaf_.box.lo[i].get_str() + ", " +
                          leaf_.box.hi[i].get_str() + "]\n";
    }

    bool leaves() { return fact("no collision at all", flight_.never_collides()); }
    /// Certified: no trajectory has more collisions than the leaf says (Theorem 1, L7).
    bool all_in_all() { return fact("M <= most", Base::trajectories_at_most(leaf_.most)); }
    bool bounded() {
        return fact("0 collisions, or 1 for falling states",
                    leaf_.least == 0 || (leaf_.least == 1 && flight_.v.hi < zero)) &&
               all_in_all();
    }
    bool behind_contact() {
        if (!contact_is_first()) return false;
        if (leaf_.least == 1 && leaf_.least < leaf_.most && all_in_all()) return true;
        const auto angle = flight_.contact_angle(leaf_.first->heavy, times_);
        if (!fact("an angle of the first contact", angle.has_value())) return false;
        bool none = false;
        const auto ray = Base::behind_first(leaf_.first->heavy, *angle, none);
        if (none) return fact("no later collision, as said", leaf_.least <= 1);
        return ray &&
               (Base::certify(*ray, leaf_.least - 1, leaf_.most - 1) || (Base::has_enough() && all_in_all()));
    }

    bool contact_is_first() {
        const bool heavy = leaf_.first->heavy;
        const auto number = [&](const mpq_class& t) { return I(bound(down, t, zero), bound(up, t, zero)); };
        const I from = number(leaf_.first->from), until = number(leaf_.first->until);
        times_ = {from.lo, until.hi};
        return fact("above the floor at t0", flight_.clearance(heavy, from).lo > zero) &&
               fact("below the floor at t1", flight_.clearance(heavy, until).hi < zero) &&
               fact("falling in [t0, t1]", flight_.rate_over(heavy, times_).hi < zero) &&
               fact("nothing touches before", flight_.is_closed(heavy, until.hi));
    }

    const Leaf& leaf_;
    I times_;
};

}  // namespace

const char* check_leaf(const Leaf& leaf, Log* log) { return judged<Check>(leaf, log); }

bool starts_in_the_air(const Box& box, unsigned bits) {
    constexpr unsigned least_bits = 640;
    Big::precision = std::max(bits, least_bits);
    using I = Interval<Big>;
    const Flight<Big> flight(box);
    const I sine = sin_cos_on(flight.phi, flight.quarter).sin, y = bound(down, box.lo[2], Big(0)),
            r_lo = flight.r.lo, r_hi = flight.r.hi;
    return (y * (I(1) + r_lo) + I(sine.lo)).lo > Big(0) &&
           (y * (I(1) + r_hi) - r_hi * I(sine.hi)).lo > Big(0);
}

}  // namespace dumbbell_verify::starts
