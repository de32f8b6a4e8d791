#include <cmath>

#include "collisions/perpendicular.hpp"
#include "collisions/witness.hpp"
#include "flight/certain_count.hpp"

namespace dumbbell::collisions {
namespace {

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

/// Just before the place where the orbit with the most collisions touches the bridge, or close to the corner.
/// It is of the least Q; greater ones have as many (L83), which plain covers do not know.
template <class I>
std::optional<Witness> contact_of_body(const Range& range, long target, const System& system,
                                       const Interrupted& interrupted) {
    const Rational &q = range.lo, &rho = *system.rho;
    const Rational& greatest = system.section == Section::body ? q : range.hi;
    const auto body =
        flight::Body<I>::with_mass(enclose<I>(rho), hull(enclose<I>(1 / greatest), enclose<I>(1 / q)));
    const LowerBound best = least_collisions<I>({{rho, rho}, {q, q}}, interrupted);
    const Rational last = touching_place<I>(best.j, rho, q);
    const int depth = -std::ilogb(last.convert_to<double>());
    for (int places = 8; best.bound >= target && places < bits_of<I>() && !interrupted(); places += 4) {
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

template std::optional<Witness> contact_of_body<Interval>(const Range&, long, const System&,
                                                          const Interrupted&);
template std::optional<Witness> contact_of_body<BigInterval>(const Range&, long, const System&,
                                                             const Interrupted&);

}  // namespace dumbbell::collisions
