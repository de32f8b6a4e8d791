#include "cli/initial_argument.hpp"

#include <fmt/format.h>

#include "arith/error.hpp"

namespace dumbbell {
namespace {

Rational parse_signed(const std::string& text) {
    const bool negative = !text.empty() && text[0] == '-';
    const Rational size = parse_rational(std::string_view(text).substr(negative ? 1 : 0));
    return negative ? Rational(-size) : size;
}

}  // namespace

std::pair<Rational, Rational> parse_quantity(const std::string& option, const std::string& text) {
    try {
        const auto colon = text.find(':');
        const Rational lo = parse_signed(text.substr(0, colon));
        const Rational hi = colon == std::string::npos ? lo : parse_signed(text.substr(colon + 1));
        if (lo > hi) {
            throw InputError(fmt::format("the interval '{}' is reversed: write the smaller number first",
                                         text.substr(0, 80)));
        }
        return {lo, hi};
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", option, error.what()));
    }
}

}  // namespace dumbbell
