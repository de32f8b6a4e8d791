#include "starts/given/given_start.hpp"

#include <algorithm>

#include "starts/air/box_state.hpp"
#include "starts/answer/trace.hpp"
#include "starts/given/argument.hpp"

namespace dumbbell::starts {
namespace {

using Range = std::pair<Rational, Rational>;

void set(Box& box, Axis axis, const Range& ends) {
    box.lo[static_cast<std::size_t>(axis)] = ends.first;
    box.hi[static_cast<std::size_t>(axis)] = ends.second;
}

void place_by_angle(GivenStart& start, const StartText& text, const std::string& dashes, int bits) {
    const auto [lo, hi] = parse_angles(dashes + "phi", text.phi);
    set(start.box, Axis::phi, {bounds(lo, bits).first, bounds(hi, bits).second});
    if (lo == hi) {
        start.meaning.phi = lo;
    }
    if (!lo.is_rational() || !hi.is_rational()) {
        start.meaning.rounded_phi = shortened(text.phi);
    }
    set(start.box, Axis::y, parse_quantity(dashes + "y", text.y));
}

}  // namespace

int bits_of_bounds(int digits) {
    constexpr int least = 128, beyond = 64;
    return std::max(least, working_bits(digits) + beyond);
}

GivenStart read_start(const StartText& text, const Rational& q_lo, const Rational& q_hi,
                      const std::string& dashes, int bits, const std::optional<Rational>& rho) {
    GivenStart start;
    start.box.rho = rho;
    set(start.box, Axis::ratio, {q_lo, q_hi});
    place_by_angle(start, text, dashes, bits);
    set(start.box, Axis::phidot, parse_quantity(dashes + "phidot", text.phidot));
    set(start.box, Axis::ydot, parse_quantity(dashes + "ydot", text.ydot));
    Box rest = start.box;
    const auto phi = static_cast<std::size_t>(Axis::phi);
    if (start.meaning.phi) {
        rest.lo[phi] = rest.hi[phi];
    }
    start.meaning.is_single = rest.is_point();
    require_in_play(start.box);
    return start;
}

}  // namespace dumbbell::starts
