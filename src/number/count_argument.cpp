#include "number/count_argument.hpp"

#include <fmt/core.h>

#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "number/rational.hpp"

namespace dumbbell {
namespace {

constexpr long most_ratios = 1'000'000;

long parse_count(const std::string& text) {
    const auto number = [&]() -> std::optional<Rational> {
        try {
            return parse_rational(text, text.size());
        } catch (const InputError&) {
            return std::nullopt;
        }
    }();
    if (!number || denominator(*number) != 1 || *number < 0) {
        throw InputError(
            fmt::format("'{}' is not a number of collisions: write N or N1:N2, for example 4 or 3:20",
                        printable(text, 40)));
    }
    if (*number > greatest_count) {
        throw InputError(
            fmt::format("{0} collisions are too many: at most 10^{1}; the law for every mass ratio encloses "
                        "one critical ratio at a time, up to N = 10^100: dumbbell law --count {0}",
                        printable(text, 40), static_cast<int>(std::log10(greatest_count))));
    }
    if (*number < 3) {
        throw InputError(fmt::format(
            "there is no critical ratio for N = {}: the maximum is never below 2; the first is for N = 3",
            numerator(*number).str()));
    }
    return number->convert_to<long>();
}

}  // namespace

std::pair<long, long> parse_counts(const std::string& text) {
    const auto colon = text.find(':');
    const long first = parse_count(text.substr(0, colon));
    const long last = colon == std::string::npos ? first : parse_count(text.substr(colon + 1));
    if (first > last) {
        throw InputError(fmt::format("the range '{}' is reversed: write the smaller N first", text));
    }
    if (last - first >= most_ratios) {
        throw InputError(fmt::format("more than {} critical ratios: take a shorter range", most_ratios));
    }
    return {first, last};
}

}  // namespace dumbbell
