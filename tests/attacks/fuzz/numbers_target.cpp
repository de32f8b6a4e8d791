// Any text as a number of the command line: it is refused with one line, or it means a number that is the
// same when it is printed and read again, and the same for the verifier, which reads ratios with its own
// code.
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "number/decimal.hpp"
#include "number/ratio_argument.hpp"
#include "number/rational.hpp"
#include "starts/given/argument.hpp"
#include "target.hpp"
#include "verify/program/claim_options.hpp"

namespace {

using namespace dumbbell_fuzz;
using namespace dumbbell;

constexpr std::size_t longest = 2100;  ///< of what parse_rational reads

/// What a parser makes of it; nothing if it refuses.
template <class Parse>
auto read(const Parse& parse) -> std::optional<decltype(parse())> {
    try {
        return parse();
    } catch (const InputError& error) {
        const std::string message = error.what();
        must(!message.empty() && message.size() < 4 * longest, "a message is short");
        must(std::none_of(message.begin(), message.end(), [](char c) { return c >= 0 && c < ' '; }),
             "a message is one line");
        return std::nullopt;
    }
}

void same_when_read_again(const std::string& text, const Rational& x) {
    if (text.size() <= longest)
        must(parse_rational(text) == x, "a printed number is the same when it is read");
}

void check_digits(const Rational& x, int digits) {
    const Decimal below = cut_down(x, digits), above = cut_up(x, digits);
    must(exact(below) <= x && x <= exact(above), "decimals on both sides");
    must(static_cast<int>(below.mantissa.str().size()) == digits, "so many digits");
    must(exact(above) == x || exact(Decimal{below.mantissa + 1, below.exponent}) == exact(above),
         "neighbours");
    must(exact(without_zeros(below)) == exact(below), "zeros at the end mean nothing");
    must(shared_digits(x, x, digits) == below, "a number shares its digits with itself");
    if (std::abs(below.exponent) + digits <= 1000) same_when_read_again(to_text(below), exact(below));
}

void check_enclosures(const Rational& x) {
    const PrecisionScope precision(64);
    const auto big = enclose<BigInterval>(x);
    must(exact_lo(big) <= x && x <= exact_hi(big), "enclosed in 64 bits");
    const auto interval = enclose<Interval>(x);
    must(std::isinf(interval.lo()) || exact(interval.lo()) <= x, "a lower bound in double");
    must(std::isinf(interval.hi()) || x <= exact(interval.hi()), "an upper bound in double");
}

void check_number(const std::string& text) {
    const auto x = read([&] { return parse_rational(text); });
    if (!x) return;
    must(*x >= 0, "no sign");
    same_when_read_again(to_fraction(*x), *x);
    check_enclosures(*x);
    if (*x == 0) return;
    const int digits = 1 + static_cast<int>(text.size() % 60);
    check_digits(*x, digits);
    const auto rounded = read([&] { return parse_rational(to_decimal(*x, digits)); });
    if (rounded) {
        const Rational error = *rounded > *x ? *rounded - *x : *x - *rounded, ten(10);
        must(error * pow(Integer(10), static_cast<unsigned>(digits - 1)) <= *x, "rounded to so many digits");
    }
}

/// The verifier's own reading of --ratio; nothing if it refuses.
std::optional<std::pair<mpq_class, mpq_class>> of_verifier(const std::string& text) {
    dumbbell_verify::Arguments words({"--ratio", text});
    dumbbell_verify::ClaimWords claim;
    dumbbell_verify::Request settings;
    words.next();
    try {
        dumbbell_verify::claim_option(words, claim);
        dumbbell_verify::state_claim(claim, settings);
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
    return settings.demand.ratios;
}

void check_ratio(const std::string& text) {
    const auto ratio = read([&] { return parse_ratio_argument(text); });
    if (ratio) {
        must(1 <= ratio->lo && ratio->lo <= ratio->hi, "ratios from 1 on");
        const std::string printed = to_fraction(ratio->lo) + ":" + to_fraction(ratio->hi);
        const auto again = read([&] { return parse_ratio_argument(printed); });
        must(printed.size() > longest ||
                 (again && again->lo == ratio->lo && again->hi == ratio->hi && !again->swapped),
             "a printed range is the same when it is read");
    }
    const auto verifiers = of_verifier(text);
    must(ratio.has_value() == verifiers.has_value(), "the verifier reads the same ratios");
    if (!ratio) return;
    must(mpq_class(ratio->lo.raw()) == verifiers->first && mpq_class(ratio->hi.raw()) == verifiers->second,
         "a ratio is the same for the verifier");
}

void check_quantity(const std::string& text) {
    const auto quantity = read([&] { return starts::parse_quantity("--y", text); });
    if (!quantity) return;
    must(quantity->first <= quantity->second, "an interval");
    const std::string lo = to_fraction(quantity->first), hi = to_fraction(quantity->second);
    if (std::max(lo.size(), hi.size()) <= longest)
        must(starts::parse_quantity("--y", lo + ":" + hi) == *quantity,
             "a printed interval is the same when it is read");
}

void check_angle(const std::string& text) {
    const auto angles = read([&] { return starts::parse_angles("--phi", text); });
    if (!angles) return;
    const auto [lo, hi] = starts::bounds(angles->first, 128);
    const auto finer = starts::bounds(angles->first, 256);
    must(lo <= finer.first && finer.first <= finer.second && finer.second <= hi, "finer bounds lie within");
    must(angles->first.is_rational() == (lo == hi), "bounds of a rational angle are that angle");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text = dumbbell_fuzz::text_of(data, size);
    check_number(text);
    check_ratio(text);
    check_quantity(text);
    check_angle(text);
    if (const auto gap = read([&] { return parse_gap(text); }))
        must(0 < *gap && *gap <= Rational(1, 100), "a gap");
    if (const auto time = read([&] { return parse_duration(text); })) must(time->count() >= 0, "a time");
    return 0;
}
