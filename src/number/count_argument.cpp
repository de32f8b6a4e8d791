#include "number/count_argument.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/printable.hpp"

namespace dumbbell {
namespace {

constexpr long greatest_count = 1'000'000'000'000;
constexpr long most_ratios = 1'000'000;

long parse_count(const std::string& text) {
    const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
    if (!digits) {
        throw InputError(fmt::format(
            "'{}' is no number of collisions: write N or N1:N2, for example 4 or 3:20", printable(text, 40)));
    }
    const std::size_t zeros = std::min(text.find_first_not_of('0'), text.size() - 1);
    const long n = text.size() - zeros > 13 ? greatest_count + 1 : std::stol(text);
    if (n > greatest_count) {
        throw InputError(fmt::format("{}... collisions are too many: at most 10^12", text.substr(zeros, 14)));
    }
    if (n < 3) {
        throw InputError(fmt::format(
            "there is no critical ratio for N = {}: the maximum is never below 2; the first is for N = 3",
            n));
    }
    return n;
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
        throw InputError(
            fmt::format("the range holds more than {} critical ratios: take it in parts", most_ratios));
    }
    return {first, last};
}

}  // namespace dumbbell
