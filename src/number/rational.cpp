#include "number/rational.hpp"

#include <fmt/core.h>
#include <mpfr.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <ostream>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "number/flint.hpp"
#include "number/rounding.hpp"

namespace dumbbell {
namespace {

constexpr int max_exponent = 1000;

/// Takes the longest run of digits off the front of `text`.
std::string take_digits(std::string_view& text) {
    const std::size_t n = std::min(text.find_first_not_of("0123456789"), text.size());
    std::string digits(text.substr(0, n));
    text.remove_prefix(n);
    return digits;
}

Integer to_integer(const std::string& digits) {
    // mpz would read a leading zero as octal.
    const auto first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
    return Integer(digits.substr(first));
}

/// The exponent after e or E, already cut off; nothing else may follow.
int parse_exponent(std::string_view text, std::string_view whole) {
    const bool negative = !text.empty() && text[0] == '-';
    if (!text.empty() && (text[0] == '+' || text[0] == '-')) {
        text.remove_prefix(1);
    }
    const std::string digits = take_digits(text);
    if (digits.empty() || !text.empty()) {
        throw InputError(
            fmt::format("'{}' is not a number: write it like 10, 4.6, 1e6 or 9/2", shortened(whole)));
    }
    const Integer value = to_integer(digits);
    if (value > max_exponent) {
        throw InputError(fmt::format("the exponent of '{}' is too large: at most {} in absolute value",
                                     shortened(whole), max_exponent));
    }
    return negative ? -value.convert_to<int>() : value.convert_to<int>();
}

Rational exact(arf_srcptr x) {
    require(arf_is_finite(x) != 0, "exact value of a number that is not finite");
    fmpz_t odd, exponent;
    fmpz_init(odd);
    fmpz_init(exponent);
    arf_get_fmpz_2exp(odd, exponent, x);
    Rational result;
    fmpz_get_mpz(mpq_numref(result.raw()), odd);
    const slong places = fmpz_get_si(exponent);  // of a number that is nearly 2^places, so it fits
    places < 0 ? mpq_div_2exp(result.raw(), result.raw(), static_cast<mp_bitcnt_t>(-places))
               : mpq_mul_2exp(result.raw(), result.raw(), static_cast<mp_bitcnt_t>(places));
    fmpz_clear(odd);
    fmpz_clear(exponent);
    return result;
}

/// The nearest number with this many bits.
struct Nearest {
    Nearest(mpq_srcptr x, int bits) {
        mpfr_init2(value, bits);
        mpfr_set_q(value, x, MPFR_RNDN);
    }
    Nearest(const Nearest&) = delete;
    Nearest& operator=(const Nearest&) = delete;
    ~Nearest() { mpfr_clear(value); }

    mpfr_t value;
};

Integer ten_to(int n) { return pow(Integer(10), static_cast<unsigned>(n)); }

}  // namespace

Rational::Rational(const Integer& numerator, const Integer& denominator) : Rational() {
    require(denominator != 0, "a fraction with denominator zero");
    mpz_set(mpq_numref(q_), numerator.raw());
    mpz_set(mpq_denref(q_), denominator.raw());
    mpq_canonicalize(q_);
}

Rational& Rational::with(void (*operation)(mpq_ptr, mpq_srcptr, mpq_srcptr), const Rational& y) {
    operation(q_, q_, y.q_);
    return *this;
}
Rational& Rational::operator/=(const Rational& y) {
    require(mpq_sgn(y.q_) != 0, "a rational is divided by zero");
    return with(mpq_div, y);
}

std::ostream& operator<<(std::ostream& out, const Rational& x) { return out << to_fraction(x); }

template <>
double Rational::convert_to<double>() const {
    return mpfr_get_d(Nearest(q_, std::numeric_limits<double>::digits).value, MPFR_RNDN);
}
template <>
long double Rational::convert_to<long double>() const {
    return mpfr_get_ld(Nearest(q_, std::numeric_limits<long double>::digits).value, MPFR_RNDN);
}
template <>
int Rational::convert_to<int>() const {
    return (numerator(*this) / denominator(*this)).convert_to<int>();
}
template <>
long Rational::convert_to<long>() const {
    return (numerator(*this) / denominator(*this)).convert_to<long>();
}

Integer numerator(const Rational& x) {
    Integer result;
    mpz_set(result.raw(), mpq_numref(x.raw()));
    return result;
}
Integer denominator(const Rational& x) {
    Integer result;
    mpz_set(result.raw(), mpq_denref(x.raw()));
    return result;
}
Rational abs(Rational x) {
    mpq_abs(x.raw(), x.raw());
    return x;
}

std::string shortened(std::string_view text) {
    constexpr std::size_t most = 40;
    return one_line(text.substr(0, most)) + (text.size() > most ? "..." : "");
}

std::string as_typed(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> signs{
        {{"\u2212", "-"}, {"\u2013", "-"}, {"\u03c0", "pi"}, {"\u00b0", "deg"}}};
    std::string typed(text);
    for (const auto& [sign, letters] : signs) {
        for (std::size_t at = 0; (at = typed.find(sign, at)) != std::string::npos;) {
            typed.replace(at, sign.size(), letters);
        }
    }
    return typed;
}

namespace {

/// Nothing for a text that is no number. Throws InputError for a bad exponent or a zero denominator.
std::optional<Rational> number_in(std::string_view text) {
    std::string_view rest = text;
    std::string digits = take_digits(rest);
    if (digits.empty()) {
        return std::nullopt;
    }
    if (!rest.empty() && rest[0] == '/') {
        rest.remove_prefix(1);
        const std::string below = take_digits(rest);
        if (below.empty() || !rest.empty()) {
            return std::nullopt;
        }
        const Integer denominator = to_integer(below);
        if (denominator == 0) {
            throw InputError(fmt::format("'{}' divides by zero", shortened(text)));
        }
        return Rational(to_integer(digits), denominator);
    }
    int exponent = 0;
    if (digits == "10" && rest.starts_with('^')) {
        digits = "1";
        exponent = parse_exponent(std::exchange(rest, {}).substr(1), text);
    }
    if (!rest.empty() && rest[0] == '.') {
        rest.remove_prefix(1);
        const std::string fraction = take_digits(rest);
        if (fraction.empty()) {
            return std::nullopt;
        }
        digits += fraction;
        exponent -= static_cast<int>(fraction.size());
    }
    if (!rest.empty()) {
        if (rest[0] != 'e' && rest[0] != 'E') {
            return std::nullopt;
        }
        exponent += parse_exponent(rest.substr(1), text);
    }
    const Integer mantissa = to_integer(digits);
    return exponent >= 0 ? Rational(mantissa * ten_to(exponent)) : Rational(mantissa, ten_to(-exponent));
}

bool is_number(std::string_view text) try { return number_in(text).has_value(); } catch (const InputError&) {
    return false;
}

/// What may be meant by a text that is no number: by .5, +10 or 4,61 a number, by LO..HI or LO-HI the range
/// LO:HI; empty: nothing.
std::string likely(const std::string& typed) {
    const std::string sign = typed.starts_with('-') ? "-" : "";
    std::string number = typed.substr(typed.starts_with('+') ? 1 : sign.size());
    const std::size_t comma = number.find(',');
    constexpr std::size_t of_thousands = 4;  // 1,000 may be a thousand
    if (comma != std::string::npos && number.size() - comma != of_thousands) {
        number[comma] = '.';
    }
    if (number.starts_with('.')) {
        number.insert(0, 1, '0');
    } else if (number.ends_with('.')) {
        number.pop_back();
    }
    if (is_number(number)) {
        return sign + number;
    }
    const std::size_t dots = typed.find(".."), end = typed.size();
    const std::size_t between = std::min(dots == std::string::npos ? typed.find('-') : dots, end);
    const std::string lo = typed.substr(0, between);
    const std::string hi = typed.substr(std::min(typed.find_first_not_of(".-", between), end));
    return is_number(lo) && is_number(hi) ? lo + ":" + hi : "";
}

/// The number that `size` spells: all of `text`, or what follows its sign.
Rational parsed(std::string_view size, std::string_view text, bool may_be_negative, std::size_t max_length) {
    if (size.size() > max_length) {
        throw InputError(fmt::format("'{}' is too long: at most {} characters", shortened(size), max_length));
    }
    if (const auto number = number_in(size)) {
        return *number;
    }
    constexpr std::size_t longest = 40;  // of a text with a hint
    const std::string meant = text.size() <= longest ? likely(as_typed(text)) : "";
    if (meant.starts_with('-') && !may_be_negative) {
        throw InputError(fmt::format("'{}' is negative: write a positive number, like 10, 4.6, 1e6 or 9/2",
                                     shortened(text)));
    }
    throw InputError(fmt::format("'{}' is not a number: write {}", shortened(text),
                                 meant.empty() ? "it like 10, 4.6, 1e6 or 9/2" : meant));
}

}  // namespace

Rational parse_rational(std::string_view text, std::size_t max_length) {
    return parsed(text, text, false, max_length);
}

Rational parse_signed_rational(std::string_view text) {
    const bool is_negative = text.starts_with('-');
    const Rational number = parsed(text.substr(is_negative ? 1 : 0), text, true, longest_number);
    return is_negative ? Rational(-number) : number;
}

std::string to_fraction(const Rational& x) { return numerator(x).str() + "/" + denominator(x).str(); }

std::string to_decimal(const Rational& x, int digits) {
    char* text = nullptr;
    mpfr_asprintf(&text, "%.*Rg", digits, Nearest(x.raw(), 256).value);
    std::string result(text);
    mpfr_free_str(text);
    return result;
}

template <>
BigInterval enclose<BigInterval>(const Rational& x) {
    fmpz_t numerator, denominator;
    fmpz_init_set_readonly(numerator, mpq_numref(x.raw()));
    fmpz_init_set_readonly(denominator, mpq_denref(x.raw()));
    BigInterval result;
    arf_fmpz_div_fmpz(result.lower(), numerator, denominator, PrecisionScope::current(), ARF_RND_FLOOR);
    arf_fmpz_div_fmpz(result.upper(), numerator, denominator, PrecisionScope::current(), ARF_RND_CEIL);
    fmpz_clear_readonly(numerator);
    fmpz_clear_readonly(denominator);
    return result;
}

template <>
Interval enclose<Interval>(const Rational& x) {
    constexpr double most = std::numeric_limits<double>::max();
    const double at = std::clamp(mpq_get_d(x.raw()), -most, most);  // x, or the next double towards zero
    const auto beyond = x <=> exact(at);
    return {beyond < 0 ? next_down(at) : at + 0.0, beyond > 0 ? next_up(at) : at + 0.0};
}

Rational exact(double x) {
    require(x - x == 0, "exact value of a number that is not finite");
    Rational result;
    mpq_set_d(result.raw(), x);
    return result;
}

Rational exact_lo(const BigInterval& x) { return exact(x.lower()); }
Rational exact_hi(const BigInterval& x) { return exact(x.upper()); }

}  // namespace dumbbell
