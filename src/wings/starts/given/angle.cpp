#include "starts/given/angle.hpp"

#include <fmt/core.h>

#include "base/error.hpp"

namespace dumbbell::starts {
namespace {

/// A factor before pi or a divisor after it: no fraction, as `1/3pi` can be read in two ways.
Rational plain_number(std::string_view text) {
    if (text.find('/') != std::string_view::npos) {
        throw InputError(fmt::format(
            "the fraction '{}' beside pi can be read in two ways: write pi/3 or 2pi/3", shortened(text)));
    }
    return parse_signed_rational(text);
}

/// `text` holds pi at `at`.
Rational multiple_of_pi(std::string_view text, std::size_t at) {
    const std::string_view before = text.substr(0, at);
    const std::string_view after = text.substr(at + 2);
    Rational factor = before.empty() ? 1 : before == "-" ? -1 : plain_number(before);
    if (after.empty()) {
        return factor;
    }
    if (after[0] != '/') {
        throw InputError(fmt::format("'{}' is not a multiple of pi", shortened(text)));
    }
    const Rational divisor = plain_number(after.substr(1));
    if (divisor < 0) {
        throw InputError(
            fmt::format("'{}' is not a multiple of pi: write the minus before it", shortened(text)));
    }
    if (divisor == 0) {
        throw InputError(fmt::format("'{}' divides by zero", shortened(text)));
    }
    return factor / divisor;
}

}  // namespace

Angle parse_angle(std::string_view text) {
    if (const std::string typed = as_typed(text); typed != text) {
        throw InputError(fmt::format("'{}' is not an angle: write {}", shortened(text), shortened(typed)));
    }
    if (text.ends_with("deg")) {
        return {0, parse_signed_rational(text.substr(0, text.size() - 3)) / 180};
    }
    const auto at = text.find("pi");
    return at == std::string_view::npos ? Angle{parse_signed_rational(text), 0}
                                        : Angle{0, multiple_of_pi(text, at)};
}

std::pair<Rational, Rational> bounds(const Angle& angle, int bits) {
    if (angle.is_rational()) {
        return {angle.radians, angle.radians};
    }
    const PrecisionScope scope(bits);
    const BigInterval enclosure = enclose<BigInterval>(angle.pis) * pi<BigInterval>();
    return {exact_lo(enclosure), exact_hi(enclosure)};
}

}  // namespace dumbbell::starts
