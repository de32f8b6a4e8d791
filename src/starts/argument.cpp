#include "starts/argument.hpp"

#include <fmt/core.h>

#include "base/error.hpp"

namespace dumbbell::starts {
namespace {

Rational parse_signed(const std::string& text) {
    const bool negative = !text.empty() && text[0] == '-';
    const Rational size = parse_rational(std::string_view(text).substr(negative ? 1 : 0));
    return negative ? Rational(-size) : size;
}

std::pair<Rational, Rational> parse_ends(const std::string& text) {
    const auto colon = text.find(':');
    const Rational lo = parse_signed(text.substr(0, colon));
    return {lo, colon == std::string::npos ? lo : parse_signed(text.substr(colon + 1))};
}

}  // namespace

std::pair<Rational, Rational> parse_quantity(const std::string& option, const std::string& text) {
    std::pair<Rational, Rational> ends;
    try {
        ends = parse_ends(text);
    } catch (const InputError& error) {
        const char* hint =
            option == "--phi" ? "; phi is in radians: 30 degrees are 0.5236, pi/2 is 1.5708" : "";
        throw InputError(fmt::format("{}: {}{}", option, error.what(), hint));
    }
    if (ends.first > ends.second) {
        throw InputError(fmt::format("{}: the interval '{}' is reversed: write the smaller number first",
                                     option, text.substr(0, 80)));
    }
    return ends;
}

}  // namespace dumbbell::starts
