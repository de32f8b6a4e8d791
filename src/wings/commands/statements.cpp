#include "commands/statements.hpp"

#include <fmt/core.h>

#include "adiabatic/prove.hpp"
#include "base/error.hpp"
#include "number/decimal.hpp"
#include "number/ratio_argument.hpp"
#include "starts/given/argument.hpp"

namespace dumbbell::cli {

namespace {

/// Radians. A multiple of pi is irrational, and cut down to 12 digits: what is proved from there on holds.
Rational parse_margin(const std::string& text) {
    constexpr int bits = 128, digits = 12;
    const auto [margin, end] = starts::parse_angles("--phi-margin", text);
    if (!(margin == end)) {
        throw InputError(fmt::format("--phi-margin takes a distance, no range: '{}'", shortened(text)));
    }
    const Rational least = starts::bounds(margin, bits).first;
    return margin.is_rational() || least <= 0 ? least : parse_rational(to_text(cut_down(least, digits)));
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

adiabatic::Hypotheses statement_of(const Given& given) {
    adiabatic::Hypotheses of;
    of.claim = claim_of(given.text("--theorem"));
    require_applicable(given, of.claim);
    of.delta = starts::parse_quantity("--delta", given.text("--delta"));
    of.exponent = parse_exponent(parse_number("--k", text_or(given, "--k", "1/2")));
    of.margin = parse_margin(text_or(given, "--phi-margin", default_margin(of.claim)));
    of.heights = starts::parse_quantity(
        "--y", text_or(given, "--y", of.claim == adiabatic::Claim::run ? "0:0.9" : "0:1"));
    require_sensible(of);
    return of;
}

Rational accuracy_of(const Given& given) {
    const Rational accuracy = parse_number("--accuracy", given.text("--accuracy"));
    if (accuracy <= 0 || accuracy > 1) {
        throw InputError("--accuracy must be greater than 0 and at most 1, for example 0.1 for 10 %");
    }
    return accuracy;
}

}  // namespace dumbbell::cli
