#include "commands/statements.hpp"

#include <fmt/core.h>

#include "adiabatic/prove.hpp"
#include "base/error.hpp"
#include "base/fields.hpp"
#include "number/decimal.hpp"
#include "number/ratio_argument.hpp"
#include "starts/given/argument.hpp"

namespace dumbbell::cli {

namespace {

constexpr std::size_t most_statements = 100'000;

std::vector<Rational> parse_list(const char* option, const std::string& text) {
    std::vector<Rational> numbers;
    for (const std::string_view part : split(text, ',')) {
        numbers.push_back(parse_number(option, std::string(part)));
    }
    return numbers;
}

/// Radians. A multiple of pi is irrational, and cut down to 12 digits: what is proved from there on holds.
std::vector<Rational> parse_margins(const std::string& text) {
    constexpr int bits = 128, digits = 12;
    std::vector<Rational> margins;
    for (const std::string_view part : split(text, ',')) {
        const auto [margin, end] = starts::parse_angles("--phi-margin", std::string(part));
        if (!(margin == end)) {
            throw InputError(fmt::format("--phi-margin takes distances, no range: '{}'", shortened(part)));
        }
        const Rational least = starts::bounds(margin, bits).first;
        margins.push_back(
            margin.is_rational() || least <= 0 ? least : parse_rational(to_text(cut_down(least, digits))));
    }
    return margins;
}

int parse_exponent(const Rational& k) {
    const Rational sixteenths = k * 16;
    if (k < 0 || k > 1 || denominator(sixteenths) != 1) {
        throw InputError("--k must be a multiple of 1/16 from 0 to 1, for example 1/2 or 0.25");
    }
    return sixteenths.convert_to<int>();
}

adiabatic::Claim claim_of(std::string_view theorem) {
    return theorem == "thm3.3"   ? adiabatic::Claim::run
           : theorem == "thm3.5" ? adiabatic::Claim::scattering
                                 : adiabatic::Claim::bounce;
}

const char* default_margin(adiabatic::Claim claim) {
    return claim == adiabatic::Claim::bounce ? "1" : claim == adiabatic::Claim::run ? "3/10" : "1/2";
}

std::string text_or(const Given& given, std::string_view option, const char* otherwise) {
    return given.has(option) ? given.text(option) : otherwise;
}

void require_applicable(const Given& given, adiabatic::Claim claim) {
    if (given.has("--k") && given.text("--theorem") != "cor3.2") {
        throw InputError("--k is for --theorem cor3.2 only");
    }
    if (given.has("--y") && claim == adiabatic::Claim::scattering) {
        throw InputError("--y is for lemma3.1, cor3.2 and thm3.3 only");
    }
}

}  // namespace

std::vector<adiabatic::Hypotheses> statements_of(const Given& given) {
    adiabatic::Hypotheses of;
    of.claim = claim_of(given.text("--theorem"));
    require_applicable(given, of.claim);
    of.delta = starts::parse_quantity("--delta", given.text("--delta"));
    const auto exponents = parse_list("--k", text_or(given, "--k", "1/2"));
    const auto margins = parse_margins(text_or(given, "--phi-margin", default_margin(of.claim)));
    // Each list fits on a command line, so the product fits a number.
    if (exponents.size() * margins.size() > most_statements) {
        throw InputError(
            fmt::format("the lists make more than {} statements: take them in parts", most_statements));
    }
    of.heights = starts::parse_quantity(
        "--y", text_or(given, "--y", of.claim == adiabatic::Claim::run ? "0:0.9" : "0:1"));
    std::vector<adiabatic::Hypotheses> result;
    for (const Rational& k : exponents) {
        of.exponent = parse_exponent(k);
        for (const Rational& margin : margins) {
            of.margin = margin;
            require_sensible(of);
            result.push_back(of);
        }
    }
    return result;
}

Rational accuracy_of(const Given& given) {
    const Rational accuracy = parse_number("--accuracy", given.text("--accuracy"));
    if (accuracy <= 0 || accuracy > 1) {
        throw InputError("--accuracy must be greater than 0 and at most 1, for example 0.1 for 10 %");
    }
    return accuracy;
}

}  // namespace dumbbell::cli
