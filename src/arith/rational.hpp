#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <string>
#include <string_view>

#include "arith/big_interval.hpp"
#include "arith/interval.hpp"

namespace dumbbell {

/// Exact rationals (GMP): mass ratios and box coordinates. Without expression templates, so that every
/// expression is a value.
using Rational =
    boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// A decimal, [0-9]+(.[0-9]+)?([eE][+-]?[0-9]+)?, or a fraction, INT/INT, exactly. Throws InputError (naming
/// the text) for anything else, more than 1,000 characters, |exponent| > 1000, or a zero denominator.
[[nodiscard]] Rational parse_rational(std::string_view text, std::size_t max_length = 1000);

/// A user's text as it may stand in a message: printable, and its first 40 characters only.
[[nodiscard]] std::string shortened(std::string_view text);

/// `p/q` in lowest terms, with `/1` for integers.
[[nodiscard]] std::string to_fraction(const Rational& x);

/// A decimal of at most `digits` significant digits for people, e.g. `4.60334`; rounded to nearest.
[[nodiscard]] std::string to_decimal(const Rational& x, int digits);

/// The tightest enclosure of x in I.
template <class I>
[[nodiscard]] I enclose(const Rational& x);
template <>
[[nodiscard]] Interval enclose<Interval>(const Rational& x);
template <>
[[nodiscard]] BigInterval enclose<BigInterval>(const Rational& x);

/// The exact value of a finite double.
[[nodiscard]] Rational exact(double x);

/// The exact ends of X. Throws BrokenInvariant if they are not finite.
[[nodiscard]] Rational exact_lo(const BigInterval& x);
[[nodiscard]] Rational exact_hi(const BigInterval& x);

}  // namespace dumbbell
