#include "adiabatic/case.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "adiabatic/prove.hpp"
#include "adiabatic/writer.hpp"
#include "base/error.hpp"
#include "base/fields.hpp"
#include "file/sealed_lines.hpp"
#include "number/decimal.hpp"

namespace dumbbell::adiabatic {
namespace {

bool has_heights(AdiabaticClaim claim) {
    return claim == AdiabaticClaim::bounce || claim == AdiabaticClaim::run;
}

bool has_exponent(AdiabaticClaim claim) { return claim == AdiabaticClaim::bounce; }

/// D1, D2, Y1, Y2, M, K, each as `number` spells it.
template <class Number>
std::vector<std::string> numbers_of(const AdiabaticHypotheses& of, const Number& number) {
    const auto part = [&](bool has, const Rational& x) { return has ? number(x) : std::string("-"); };
    const bool heights = has_heights(of.claim);
    return {number(of.delta.first),
            number(of.delta.second),
            part(heights, of.heights.first),
            part(heights, of.heights.second),
            number(of.margin),
            part(has_exponent(of.claim), Rational(of.exponent, 16))};
}

/// What parse_rational reads as exactly x >= 0.
std::string decimal(const Rational& x) { return x == 0 ? "0" : exact_text(x); }

std::string range(const std::pair<Rational, Rational>& ends) {
    return ends.first == ends.second ? decimal(ends.first)
                                     : fmt::format("{}:{}", decimal(ends.first), decimal(ends.second));
}

std::string theorem(const AdiabaticHypotheses& of) {
    switch (of.claim) {
        case AdiabaticClaim::bounce:
            return of.exponent == 8 ? "lemma3.1" : "cor3.2";
        case AdiabaticClaim::run:
            return "thm3.3";
        case AdiabaticClaim::scattering:
            return "thm3.5";
        default:
            return "printed";
    }
}

/// The different ones, in the order of their first.
template <class Text>
std::string list_of(const std::vector<AdiabaticHypotheses>& grid, const Text& text) {
    std::vector<std::string> list;
    for (const AdiabaticHypotheses& of : grid) {
        const std::string one = text(of);
        if (std::find(list.begin(), list.end(), one) == list.end()) {
            list.push_back(one);
        }
    }
    return fmt::format("{}", fmt::join(list, ","));
}

AdiabaticHypotheses read_case(const std::string& unit) {
    constexpr std::size_t longest = 10'000;
    const auto fields = split(unit, ' ');
    if (fields.size() != 8 || fields[0] != "case") {
        throw InputError("it has other fields");
    }
    const auto number = [&](std::size_t i) { return parse_rational(fields[i], longest); };
    const auto claim = claim_named(fields[1]);
    if (!claim) {
        throw InputError("it has a claim that this program does not know");
    }
    AdiabaticHypotheses of;
    of.claim = *claim;
    of.delta = {number(2), number(3)};
    of.heights = {0, 1};
    if (has_heights(of.claim)) {
        of.heights = {number(4), number(5)};
    }
    of.margin = number(6);
    if (has_exponent(of.claim)) {
        const Rational sixteenths = number(7) * 16;
        if (sixteenths > 16 || denominator(sixteenths) != 1) {
            throw InputError("its exponent is not a multiple of 1/16 up to 1");
        }
        of.exponent = sixteenths.convert_to<int>();
    }
    if (of.delta.first > of.delta.second || case_of(of) != unit) {
        throw InputError("it is not spelt as this program does");
    }
    require_sensible(of);
    return of;
}

}  // namespace

std::string case_of(const AdiabaticHypotheses& of) {
    return fmt::format("case {} {}", name(of.claim), fmt::join(numbers_of(of, to_fraction), " "));
}

AdiabaticHypotheses parse_case(const std::string& unit) {
    try {
        return read_case(unit);
    } catch (const InputError& error) {
        throw InputError(fmt::format("the order has a statement that is none: {}", error.what()));
    }
}

std::vector<std::string> columns_of(const AdiabaticHypotheses& of) {
    std::vector<std::string> columns = numbers_of(of, decimal);
    columns.insert(columns.begin(), theorem(of));
    return columns;
}

std::string options_of(const std::vector<AdiabaticHypotheses>& grid) {
    const AdiabaticHypotheses& first = grid.front();
    const bool is_corollary =
        std::any_of(grid.begin(), grid.end(), [](const auto& of) { return theorem(of) == "cor3.2"; });
    const auto exponent = [](const AdiabaticHypotheses& of) { return decimal(Rational(of.exponent, 16)); };
    std::string text = fmt::format("--theorem {} --delta {}", is_corollary ? "cor3.2" : theorem(first),
                                   list_of(grid, [](const auto& of) { return range(of.delta); }));
    if (has_heights(first.claim)) {
        text += fmt::format(" --y {}", range(first.heights));
    }
    text += fmt::format(" --phi-margin {}", list_of(grid, [](const auto& of) { return decimal(of.margin); }));
    if (is_corollary) {
        text += fmt::format(" --k {}", list_of(grid, exponent));
    }
    return text;
}

}  // namespace dumbbell::adiabatic
