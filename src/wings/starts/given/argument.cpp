#include "starts/given/argument.hpp"

#include <fmt/core.h>

#include "base/error.hpp"

namespace dumbbell::starts {
namespace {

/// Of the comparison of two angles; closer ones are taken to be in order.
constexpr int comparing_bits = 8192;

/// What `read` makes of it; if it refuses, the name of the option before and the hint behind what it says.
template <class Read>
auto named(const std::string& option, const char* hint, const Read& read) {
    try {
        return read();
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}{}", option, error.what(), hint));
    }
}

template <class End>
std::pair<End, End> ends(std::string_view text, End (*read)(std::string_view)) {
    const auto colon = text.find(':');
    const End lo = read(text.substr(0, colon));
    return {lo, colon == std::string_view::npos ? lo : read(text.substr(colon + 1))};
}

void require_order(const std::string& option, const std::string& text, bool in_order) {
    if (!in_order) {
        throw InputError(fmt::format("{}: the interval '{}' is reversed: write the smaller number first",
                                     option, text.substr(0, 80)));
    }
}

}  // namespace

std::pair<Rational, Rational> parse_quantity(const std::string& option, const std::string& text) {
    auto result = named(option, "", [&] { return ends(text, parse_signed_rational); });
    require_order(option, text, result.first <= result.second);
    return result;
}

std::pair<Angle, Angle> parse_angles(const std::string& option, const std::string& text) {
    auto result = named(option, "; an angle is in radians, or like 30deg, pi/2 or 0.3pi",
                        [&] { return ends(text, parse_angle); });
    require_order(option, text,
                  bounds(result.first, comparing_bits).first <= bounds(result.second, comparing_bits).second);
    return result;
}

}  // namespace dumbbell::starts
