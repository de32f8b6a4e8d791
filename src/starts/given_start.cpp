#include "starts/given_start.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.hpp"
#include "number/decimal.hpp"
#include "starts/argument.hpp"
#include "starts/initial_state.hpp"
#include "starts/trace.hpp"

namespace dumbbell::starts {
namespace {

using Range = std::pair<Rational, Rational>;

void set(InitialBox& box, InitialAxis axis, const Range& ends) {
    box.lo[static_cast<std::size_t>(axis)] = ends.first;
    box.hi[static_cast<std::size_t>(axis)] = ends.second;
}

/// The two numbers as they are, then what is wrong with them.
[[noreturn]] void refuse(const std::string& text, const std::string& fault) {
    throw InputError(fmt::format("--heights {}: {}", shortened(text), fault));
}

void require_apart(const std::string& text, const Range& heights, int bits) {
    const auto& [light, heavy] = heights;
    const Rational lowest = std::min(light, heavy);
    const char* mass = light < heavy ? "light" : "heavy";
    if (lowest < 0) {
        refuse(text, fmt::format("the {} mass is below the floor: both heights must be above 0", mass));
    }
    if (lowest == 0) {
        refuse(text, fmt::format("the {} mass touches the floor: both heights must be above 0", mass));
    }
    if (abs(light - heavy) > 1) {
        refuse(text, "they are further apart than the rod is long (1): no angle has them");
    }
    if (lowest < Rational(1, Integer(1) << static_cast<unsigned>(bits - 8))) {
        refuse(text, fmt::format("the {} mass is too near the floor for this precision: try --digits", mass));
    }
}

/// asin x, |x| <= 1, exactly where that is a multiple of pi/2.
std::optional<Angle> exact_asin(const Rational& x) {
    return x == 0 ? std::optional(Angle{}) : abs(x) == 1 ? std::optional(Angle{0, x / 2}) : std::nullopt;
}

/// Its bounds. In twice the precision, as its derivative grows next to 1 like the root of that; then rounded
/// outward.
Range asin_bounds(const Rational& x, int bits) {
    const auto [lo, hi] = [&] {
        const PrecisionScope scope(2 * bits);
        const BigInterval fine = asin(enclose<BigInterval>(x));
        return Range(exact_lo(fine), exact_hi(fine));
    }();
    const PrecisionScope scope(bits);
    return {exact_lo(enclose<BigInterval>(lo)), exact_hi(enclose<BigInterval>(hi))};
}

/// phi and y of the box, from sin phi = light - heavy and y = beta1 light + beta2 heavy, which is monotone in
/// q.
void place_by_heights(GivenStart& start, const std::string& text, int bits) {
    const Range heights = parse_pair("--heights", text);
    require_apart(text, heights, bits);
    const Rational& light = heights.first;
    const Rational& heavy = heights.second;
    const Rational sine = light - heavy;
    start.meaning.phi = exact_asin(sine);
    set(start.box, InitialAxis::phi,
        start.meaning.phi ? bounds(*start.meaning.phi, bits) : asin_bounds(sine, bits));
    if (!start.meaning.phi || !start.meaning.phi->is_rational()) {
        start.meaning.rounded_phi = fmt::format("asin({}{})", sine < 0 ? "-" : "", exact_text(abs(sine)));
    }
    const auto centre = [&](const Rational& q) { return Rational((light + q * heavy) / (1 + q)); };
    const Rational one = centre(start.box.lower(InitialAxis::ratio));
    const Rational other = centre(start.box.upper(InitialAxis::ratio));
    set(start.box, InitialAxis::y, {std::min(one, other), std::max(one, other)});
    start.meaning.heights = heights;
}

void place_by_angle(GivenStart& start, const StartText& text, const std::string& dashes, int bits) {
    const auto [lo, hi] = parse_angles(dashes + "phi", text.phi);
    set(start.box, InitialAxis::phi, {bounds(lo, bits).first, bounds(hi, bits).second});
    if (lo == hi) {
        start.meaning.phi = lo;
    }
    if (!lo.is_rational() || !hi.is_rational()) {
        start.meaning.rounded_phi = shortened(text.phi);
    }
    set(start.box, InitialAxis::y, parse_quantity(dashes + "y", text.y));
}

}  // namespace

int bits_of_bounds(int digits) {
    constexpr int least = 128, beyond = 64;
    return std::max(least, working_bits(digits) + beyond);
}

GivenStart read_start(const StartText& text, const Rational& q_lo, const Rational& q_hi,
                      const std::string& dashes, int bits) {
    GivenStart start;
    set(start.box, InitialAxis::ratio, {q_lo, q_hi});
    if (text.heights) {
        place_by_heights(start, *text.heights, bits);
    } else {
        place_by_angle(start, text, dashes, bits);
    }
    set(start.box, InitialAxis::phidot, parse_quantity(dashes + "phidot", text.phidot));
    set(start.box, InitialAxis::ydot, parse_quantity(dashes + "ydot", text.ydot));
    InitialBox rest = start.box;
    const auto phi = static_cast<std::size_t>(InitialAxis::phi);
    if (start.meaning.phi || start.meaning.heights) {
        rest.lo[phi] = rest.hi[phi];
    }
    start.meaning.is_single = rest.is_point();
    require_in_play(start.box);
    return start;
}

}  // namespace dumbbell::starts
