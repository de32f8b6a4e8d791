#include "cli/claims/body.hpp"

#include <fmt/core.h>

#include <utility>

#include "base/error.hpp"
#include "number/decimal.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::cli {
namespace {

using collisions::CertifyRequest;

CertifyRequest about(const Rational& q_lo, const Rational& q_hi, const collisions::Heights& heights) {
    CertifyRequest request;
    request.q_lo = q_lo;
    request.q_hi = q_hi;
    request.heights = heights;
    return request;
}

/// L70 (d).
CertifyRequest rod(const Rational& q, const Rational& mu) {
    const Rational d1 = (2 * q / (1 + q) + mu) / (2 * (1 + mu));
    const Rational rho = (2 + mu * (1 + q)) / (2 * q + mu * (1 + q));
    const Rational inertia = d1 * d1 / (d1 * d1 * rho - mu / (6 * (1 + mu)));
    return about(inertia, inertia, {rho, rho});
}

CertifyRequest rod_of(const Given& given) {
    if (!given.has("RATIO")) {
        throw InputError("--rod-mass needs RATIO, the mass ratio of the two ends");
    }
    const RatioArgument ratio = parse_ratio_argument(given.text("RATIO"));
    if (ratio.lo != ratio.hi) {
        throw InputError("--rod-mass is for a single mass ratio, not for a range");
    }
    return rod(ratio.lo, parse_number("--rod-mass", given.text("--rod-mass")));
}

/// As it is written: no number of a body changes into its inverse.
std::pair<Rational, Rational> parse_ends(const char* option, const std::string& text) {
    const std::size_t colon = text.find(':');
    const Rational lo = parse_number(option, text.substr(0, colon));
    const Rational hi = colon == std::string::npos ? lo : parse_number(option, text.substr(colon + 1));
    if (lo == 0 || lo > hi) {
        throw InputError(
            fmt::format("{} is a number greater than 0, or a range LO:HI, the smaller one first", option));
    }
    return {lo, hi};
}

CertifyRequest given_numbers(const Given& given) {
    if (!given.has("--rho") || !given.has("--inertia")) {
        throw InputError("--scene body needs --rho and --inertia, or --coin, or --rod-mass with RATIO");
    }
    const auto rho = parse_ends("--rho", given.text("--rho"));
    const auto inertia = parse_ends("--inertia", given.text("--inertia"));
    if (rho.second > 1) {
        throw InputError("--rho is d2/d1 with d1 >= d2, so at most 1: swap the ends");
    }
    if (inertia.first * rho.first < 1) {
        throw InputError(
            "no body with its mass between its contacts has these numbers: inertia times rho is "
            "at least 1 (proofs/body.md, L70)");
    }
    return about(inertia.first, inertia.second, {rho.first, rho.second});
}

}  // namespace

bool is_about_body(const Given& given) {
    return given.has("--coin") || given.has("--rod-mass") || given.has("--rho") ||
           given.text("--scene") == "body";
}

std::string rod_words(const Given& given) {
    if (!given.has("--rod-mass")) {
        return "";
    }
    const Rational mass = parse_number("--rod-mass", given.text("--rod-mass"));
    return fmt::format("--ratio {} --rod-mass {}", exact_text(parse_ratio_argument(given.text("RATIO")).lo),
                       denominator(mass) == 1 ? numerator(mass).str() : to_fraction(mass));
}

CertifyRequest body_request(const Given& given) {
    const auto scene = given.has("--scene") ? given.text("--scene") : "body";
    if (scene != "body") {
        throw InputError("bodies are of --scene body");
    }
    if (!given.has("--rod-mass") && given.has("RATIO")) {
        throw InputError("a body has a RATIO only with --rod-mass; else give --rho and --inertia, or --coin");
    }
    CertifyRequest request = given.has("--coin")       ? about(4, 4, {1, 1})
                             : given.has("--rod-mass") ? rod_of(given)
                                                       : given_numbers(given);
    request.scene = collisions::Scene::body;
    request.section = collisions::Section::plain;
    return request;
}

}  // namespace dumbbell::cli
