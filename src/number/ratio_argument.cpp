#include "number/ratio_argument.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "number/decimal.hpp"

namespace dumbbell {
namespace {

Rational positive(const std::string& text) {
    Rational value = parse_rational(text);
    if (value == 0) {
        throw InputError("a ratio must be greater than 0");
    }
    return value;
}

}  // namespace

RatioArgument parse_ratio_argument(const std::string& text) {
    const auto colon = text.find(':');
    if (colon != std::string::npos && (colon == 0 || colon + 1 == text.size())) {
        throw InputError(
            fmt::format("the range '{}' lacks an end: write LO:HI, for example 1:100", shortened(text)));
    }
    RatioArgument result;
    result.lo = positive(text.substr(0, colon));
    result.hi = colon == std::string::npos ? result.lo : positive(text.substr(colon + 1));
    if (result.lo > result.hi) {
        throw InputError(
            fmt::format("the range '{}' is reversed: write the smaller ratio first", shortened(text)));
    }
    if (result.lo < 1 && result.hi > 1) {
        throw InputError(
            fmt::format("the range '{}' crosses 1: write 1:{} (below 1 the masses are swapped, so that "
                        "says the same)",
                        text, exact_text(std::max(result.hi, Rational(1) / result.lo))));
    }
    if (result.lo < 1) {
        result = {Rational(1) / result.hi, Rational(1) / result.lo, true};
    }
    return result;
}

Rational parse_number(std::string_view option, const std::string& text) {
    try {
        return parse_rational(text);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", option, error.what()));
    }
}

Rational parse_gap(const std::string& text) {
    const Rational gap = parse_number("--gap", text);
    if (gap < parse_rational("1e-300") || gap > Rational(1, 100)) {
        throw InputError(
            fmt::format("--gap {} is out of range: a relative width from 1e-300 to 0.01", shortened(text)));
    }
    return gap;
}

std::chrono::duration<double> parse_duration(const std::string& text, std::string_view option) {
    const auto malformed = [&] {
        return InputError(
            fmt::format("{} '{}' is not a time: write it like 30s, 10m or 2h", option, shortened(text)));
    };
    if (text.empty()) {
        throw malformed();
    }
    const char unit = text.back();
    const double factor = unit == 's' ? 1 : unit == 'm' ? 60 : unit == 'h' ? 3600 : 0;
    if (factor == 0) {
        throw malformed();
    }
    try {
        const Rational number = parse_rational(text.substr(0, text.size() - 1));
        return std::chrono::duration<double>(number.convert_to<double>() * factor);
    } catch (const InputError&) {
        throw malformed();
    }
}

}  // namespace dumbbell
