#include "cli/claims/body.hpp"

#include "base/error.hpp"
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

CertifyRequest given_numbers(const Given& given) {
    if (!given.has("--rho") || !given.has("--inertia")) {
        throw InputError("--scene body needs --rho and --inertia, or --coin, or --rod-mass with RATIO");
    }
    const RatioArgument rho = parse_ratio_argument(given.text("--rho"));
    const RatioArgument inertia = parse_ratio_argument(given.text("--inertia"));
    if (!rho.swapped && rho.hi > 1) {
        throw InputError("--rho is d2/d1 with d1 >= d2, so at most 1: swap the ends");
    }
    if (inertia.swapped || inertia.lo < rho.hi) {
        throw InputError(
            "no body with its mass between its contacts has these numbers: inertia times rho is "
            "at least 1 (proofs/body.md, L70)");
    }
    return about(inertia.lo, inertia.hi, {1 / rho.hi, 1 / rho.lo});
}

}  // namespace

bool is_about_body(const Given& given) {
    return given.has("--coin") || given.has("--rod-mass") || given.has("--rho") ||
           given.text("--scene") == "body";
}

CertifyRequest body_request(const Given& given) {
    const auto scene = given.has("--scene") ? given.text("--scene") : "body";
    if (scene != "body") {
        throw InputError("bodies are of --scene body");
    }
    if (!given.has("--rod-mass") && given.has("RATIO")) {
        throw InputError(
            "--scene body has no RATIO but with --rod-mass: its numbers are --rho and --inertia");
    }
    CertifyRequest request = given.has("--coin")       ? about(4, 4, {1, 1})
                             : given.has("--rod-mass") ? rod_of(given)
                                                       : given_numbers(given);
    request.scene = collisions::Scene::body;
    request.section = collisions::Section::plain;
    return request;
}

}  // namespace dumbbell::cli
