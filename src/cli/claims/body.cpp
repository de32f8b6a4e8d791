#include "cli/claims/body.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::cli {

namespace {

collisions::Claim rod_of(const Given& given) {
    if (!given.has("RATIO")) {
        throw InputError("--rod-mass needs RATIO, the mass ratio of the two ends");
    }
    const RatioArgument ratio = parse_ratio_argument(given.text("RATIO"));
    if (ratio.lo != ratio.hi) {
        throw InputError("--rod-mass is for a single mass ratio, not for a range");
    }
    return claim_of(collisions::Rod{ratio.lo, parse_number("--rod-mass", given.text("--rod-mass"))});
}

/// As it is written: no number of a body changes into its inverse.
collisions::Range parse_ends(const char* option, const std::string& text) {
    const std::size_t colon = text.find(':');
    const Rational lo = parse_number(option, text.substr(0, colon));
    const Rational hi = colon == std::string::npos ? lo : parse_number(option, text.substr(colon + 1));
    if (lo == 0 || lo > hi) {
        throw InputError(
            fmt::format("{} is a number greater than 0, or a range LO:HI, the smaller one first", option));
    }
    return {lo, hi};
}

collisions::Claim given_numbers(const Given& given) {
    if (!given.has("--rho") || !given.has("--inertia")) {
        throw InputError("--scene body needs --rho and --inertia, or --coin, or --rod-mass with RATIO");
    }
    const auto rho = parse_ends("--rho", given.text("--rho"));
    const auto inertia = parse_ends("--inertia", given.text("--inertia"));
    if (rho.hi > 1) {
        throw InputError("--rho is d2/d1 with d1 >= d2, so at most 1: swap the ends");
    }
    if (inertia.lo * rho.lo < 1) {
        throw InputError(
            "no body with its mass between its contacts has these numbers: inertia times rho is "
            "at least 1 (proofs/body.md, L70)");
    }
    return {.range = inertia, .system = {collisions::Section::body, rho}};
}

}  // namespace

bool is_about_body(const Given& given) {
    return given.has("--coin") || given.has("--rod-mass") || given.has("--rho") ||
           given.text("--scene") == "body";
}

collisions::Claim body_claim(const Given& given) {
    const auto scene = given.has("--scene") ? given.text("--scene") : "body";
    if (scene != "body") {
        throw InputError("bodies are of --scene body");
    }
    if (!given.has("--rod-mass") && given.has("RATIO")) {
        throw InputError("a body has a RATIO only with --rod-mass; else give --rho and --inertia, or --coin");
    }
    return given.has("--coin")
               ? collisions::Claim{.range = {4, 4},
                                   .system = {collisions::Section::body, collisions::Range{1, 1}}}
           : given.has("--rod-mass") ? rod_of(given)
                                     : given_numbers(given);
}

}  // namespace dumbbell::cli
