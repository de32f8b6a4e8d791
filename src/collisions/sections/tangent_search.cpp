#include <cmath>
#include <vector>

#include "collisions/perpendicular.hpp"
#include "collisions/sections/tangents.hpp"
#include "collisions/witness.hpp"
#include "flight/certain_count.hpp"

namespace dumbbell::collisions {
namespace {

/// Just below pi/2.
Rational quarter() { return exact_lo(half_pi<BigInterval>()); }

/// Where f + b seems to be as great as anywhere, or at least `enough`.
struct Best {
    long total = 0, hits = 0;
    Rational e = 0;
};

/// In between, by magnitude where that differs.
Rational middle_place(const Rational& lo, const Rational& hi) {
    return lo == 0       ? hi / 1024
           : hi > 4 * lo ? exact(std::sqrt(Rational(lo * hi).convert_to<double>()))
                         : (lo + hi) / 2;
}

/// f does not decrease and b does not increase, so f at the end and b at the beginning bound the sum.
template <class I>
Best best_tangent(const Tangents<I>& of, long corner, long cap, long enough, const Interrupted& interrupted) {
    const Rational least = power_of_half(bits_of<I>() - 10), narrow = power_of_half(bits_of<I>() - 4);
    struct Part {
        Rational lo, hi;
        long up_lo, down_lo, up_hi, down_hi;
    };
    const long top_up = of.upward(I(2), cap), corner_up = of.upward(I(0), cap);
    Best best =
        corner + corner_up > top_up ? Best{corner + corner_up, corner, least} : Best{top_up, 0, quarter()};
    std::vector<Part> todo{{0, quarter(), corner_up, corner, top_up, 0}};
    while (!todo.empty() && best.total < enough && !interrupted()) {
        const Part part = std::move(todo.back());
        todo.pop_back();
        const Rational middle = middle_place(part.lo, part.hi);
        if (part.up_hi + part.down_lo <= best.total || middle < least ||
            part.hi - part.lo < narrow * part.hi) {
            continue;
        }
        const I e = enclose<I>(middle);
        const long up = of.upward(e, cap), down = of.into_valley(e, cap);
        if (up + down > best.total) {
            best = {up + down, down, middle};
        }
        todo.push_back({part.lo, middle, part.up_lo, part.down_lo, up, down});
        todo.push_back({middle, part.hi, up, down, part.up_hi, part.down_hi});
    }
    return best;
}

/// More than any motion has: L84 (a), about.
long more_than_all(const Rational& q) {
    return static_cast<long>(2 * std::sqrt(q.convert_to<double>())) + 10;
}

/// The greatest dyadic of so many places at which the tangent seems to have `hits` in the valley.
template <class I>
Rational last_place(const Tangents<I>& of, Rational lo, long hits) {
    Rational step = 1;
    for (int place = 0; place < bits_of<I>(); ++place, step /= 2) {
        const Rational next = lo + step;
        if (next < quarter() && of.into_valley(enclose<I>(next), hits) >= hits) {
            lo = next;
        }
    }
    return lo;
}

template <class I>
std::optional<Witness> contact(const Rational& e, const Rational& eta, const flight::Body<I>& body,
                               long target) {
    const auto rays = contact_rays(enclose<I>(e), enclose<I>(eta), body);
    const long forward = certain_count(rays.outgoing, body, target - 1),
               backward = certain_count(rays.reversed, body, target - 1 - forward);
    return 1 + forward + backward >= target ? std::optional(Witness{e, eta, forward, backward})
                                            : std::nullopt;
}

}  // namespace

template <class I>
std::optional<Count> body_maximum(const Rational& q, const System& system, const Interrupted& interrupted) {
    const Rational& rho = *system.rho;
    const Tangents<I> of(rho, q, interrupted);
    const long cap = more_than_all(q), corner = corner_hits(of, rho, q, cap), least = of.upward(I(0), cap),
               even = 2 * corner + 2 + 2 * least,
               most = 1 + 2 * best_tangent(of, corner, cap, cap, interrupted).total;
    const bool is_even =
        even > most && of.even(corner, cap) >= least && may_have_in_corner(2 * corner + 2, rho, q);
    return interrupted() ? std::nullopt : std::optional(Count(is_even ? even : most));
}

/// Just before a place where the tangent touches the bridge again, or close to the corner. It is of the least
/// Q; greater ones have as many (L83), which plain covers do not know.
template <class I>
std::optional<Witness> contact_of_body(const Range& range, long target, const System& system,
                                       const Interrupted& interrupted) {
    const Rational &q = range.lo, &rho = *system.rho;
    const Rational& greatest = system.section == Section::body ? q : range.hi;
    const Tangents<I> of(rho, q, interrupted);
    const auto body =
        flight::Body<I>::with_mass(enclose<I>(rho), hull(enclose<I>(1 / greatest), enclose<I>(1 / q)));
    const long cap = more_than_all(q);
    const Best best = best_tangent(of, corner_hits(of, rho, q, cap), cap, target / 2, interrupted);
    const Rational last = best.hits > 0 ? last_place(of, best.e, best.hits) : quarter();
    const int depth = -std::ilogb(last.convert_to<double>());
    for (int places = 8; places < bits_of<I>() && !interrupted(); places += 4) {
        const Rational step = power_of_half(places + depth), steps = last / step,
                       e = step * (numerator(steps) / denominator(steps) - 1);
        auto found = contact(e, step * power_of_half(depth + 6), body, target);
        found = found ? found : contact(power_of_half(2 * places), power_of_half(places), body, target);
        if (found) {
            return found;
        }
    }
    return std::nullopt;
}

template <class I>
std::optional<Witness> body_witness(const Range& range, const Count& wanted, const System& system,
                                    const Interrupted& interrupted) {
    const long target = as_long(wanted);
    if (target <= most_in_corner && flight::corner_count(*system.rho, range.lo, target) >= target) {
        return Witness{0, 0, target - 1, 0, Place::corner};
    }
    return contact_of_body<I>(range, target, system, interrupted);
}

template std::optional<Witness> contact_of_body<Interval>(const Range&, long, const System&,
                                                          const Interrupted&);
template std::optional<Count> body_maximum<Interval>(const Rational&, const System&, const Interrupted&);
template std::optional<Witness> body_witness<Interval>(const Range&, const Count&, const System&,
                                                       const Interrupted&);
template std::optional<Count> body_maximum<BigInterval>(const Rational&, const System&, const Interrupted&);
template std::optional<Witness> body_witness<BigInterval>(const Range&, const Count&, const System&,
                                                          const Interrupted&);

}  // namespace dumbbell::collisions
