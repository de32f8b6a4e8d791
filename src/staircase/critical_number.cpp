#include "staircase/critical_number.hpp"

#include "base/error.hpp"
#include "flight/extremal_orbit.hpp"
#include "number/decimal.hpp"

namespace dumbbell::staircase {

CriticalNumber critical_number(const collisions::CriticalRatio& ratio, int digits) {
    constexpr int radius_digits = 2;
    const auto shared = shared_digits(ratio.q_lo, ratio.q_hi, digits);
    require(shared.has_value(), "a critical ratio without the digits that were asked for");
    const Rational value = exact(*shared);  // at most q_lo
    const bool is_exact = value == ratio.q_hi;
    return {to_text(is_exact ? without_zeros(*shared) : *shared),
            to_text(cut_up(ratio.q_hi - value, radius_digits)), is_exact};
}

const char* orbit_name(long n) {
    return flight::tangent_flight(n).orbit == flight::ExtremalOrbit::top ? "top" : "corner";
}

}  // namespace dumbbell::staircase
