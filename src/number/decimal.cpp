#include "number/decimal.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.hpp"

namespace dumbbell {
namespace {

Rational power_of_ten(int n) {
    const Integer power = pow(Integer(10), static_cast<unsigned>(n < 0 ? -n : n));
    return n < 0 ? Rational(Integer(1), power) : Rational(power);
}

/// e with 10^e <= x < 10^(e + 1), x > 0.
int decade(const Rational& x) {
    const auto length = [](const Integer& i) { return static_cast<int>(i.str().size()); };
    // 10^(a-1) <= numerator < 10^a and 10^(b-1) <= denominator < 10^b: e is a - b or a - b - 1.
    const int e = length(numerator(x)) - length(denominator(x));
    return x < power_of_ten(e) ? e - 1 : e;
}

/// Divides n > 0 by p as often as it can; how often that was.
int take_factors(Integer& n, int p) {
    int count = 0;
    for (; n % p == 0; n /= p) {
        ++count;
    }
    return count;
}

/// The decimal without zeros at its end that is x > 0, if there is one: if the denominator has no prime
/// factors but 2 and 5.
std::optional<Decimal> finite_decimal(const Rational& x) {
    Integer rest = denominator(x);
    const int twos = take_factors(rest, 2);
    const int fives = take_factors(rest, 5);
    if (rest != 1) {
        return std::nullopt;
    }
    const int places = std::max(twos, fives);
    Decimal result{numerator(Rational(x * power_of_ten(places))), -places};
    result.exponent += take_factors(result.mantissa, 10);
    return result;
}

}  // namespace

Decimal cut_down(const Rational& x, int digits) {
    require(x > 0 && digits >= 1, "digits of a number that is not positive");
    const int exponent = decade(x) - digits + 1;
    const Rational scaled = x * power_of_ten(-exponent);
    return {Integer(numerator(scaled) / denominator(scaled)), exponent};
}

Decimal cut_up(const Rational& x, int digits) {
    if (x == 0) {
        return {};
    }
    Decimal result = cut_down(x, digits);
    if (exact(result) < x && ++result.mantissa == pow(Integer(10), static_cast<unsigned>(digits))) {
        result.mantissa /= 10;
        ++result.exponent;
    }
    return result;
}

std::optional<Decimal> shared_digits(const Rational& lo, const Rational& hi, int digits) {
    // Cutting is monotone, so what the two ends share, all numbers between them share.
    const Decimal first = cut_down(lo, digits);
    return first == cut_down(hi, digits) ? std::optional(first) : std::nullopt;
}

Rational exact(const Decimal& x) { return Rational(x.mantissa) * power_of_ten(x.exponent); }

std::string to_text(const Decimal& x) {
    std::string digits = x.mantissa.str();
    const int length = static_cast<int>(digits.size());
    if (x.exponent == 0) {
        return digits;
    }
    if (x.exponent < 0 && -x.exponent < length) {
        const int point = length + x.exponent;
        return digits.insert(static_cast<std::size_t>(point), ".");
    }
    const int exponent = x.exponent + length - 1;
    if (exponent < 0 && exponent >= -4) {
        return "0." + std::string(static_cast<std::size_t>(-1 - exponent), '0') + digits;
    }
    return fmt::format("{}e{}", length > 1 ? digits.insert(1, ".") : digits, exponent);
}

Decimal without_zeros(Decimal x) {
    while (x.mantissa > 0 && x.exponent < 0 && x.mantissa % 10 == 0) {
        x.mantissa /= 10;
        ++x.exponent;
    }
    return x;
}

std::string exact_text(const Rational& x) {
    constexpr std::size_t short_enough = 17;
    require(x > 0, "the text of a number that is not positive");
    const bool is_integer = denominator(x) == 1;
    std::string whole = is_integer ? numerator(x).str() : to_fraction(x);
    if (is_integer && whole.size() <= short_enough) {
        return whole;
    }
    const std::optional<Decimal> decimal = finite_decimal(x);
    if (!decimal) {
        return whole;
    }
    const std::string text = to_text(*decimal);
    const bool is_short = decimal->mantissa.str().size() <= short_enough;
    return is_short || text.size() <= whole.size() ? text : whole;
}

std::string spelled(const Rational& x) { return x == 0 ? "0" : x < 0 ? "-" + exact_text(-x) : exact_text(x); }

std::string spelled(const Rational& lo, const Rational& hi) {
    return spelled(lo) + (lo == hi ? "" : ":" + spelled(hi));
}

}  // namespace dumbbell
