#include "collisions/body/given.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::collisions {
namespace {

using Ends = Heights;  // of any number

Ends parse_ends(const char* option, const std::string& text) {
    const std::size_t colon = text.find(':');
    const Rational lo = parse_number(option, text.substr(0, colon));
    const Rational hi = colon == std::string::npos ? lo : parse_number(option, text.substr(colon + 1));
    if (lo == 0 || lo > hi) {
        throw InputError(
            fmt::format("{} is a number greater than 0, or a range LO:HI, the smaller one first", option));
    }
    return {lo, hi};
}

CertifyRequest about(const Ends& inertia, const Ends& heights) {
    CertifyRequest request;
    request.q_lo = inertia.lo;
    request.q_hi = inertia.hi;
    request.scene = Scene::body;
    request.section = Section::plain;
    request.heights = heights;
    return request;
}

}  // namespace

CertifyRequest body_of(const std::string& rho, const std::string& inertia) {
    const Ends heights = parse_ends("--rho", rho), q = parse_ends("--inertia", inertia);
    if (heights.hi > 1) {
        throw InputError("--rho is d2/d1 with d1 >= d2, so at most 1: swap the ends");
    }
    if (q.lo * heights.lo < 1) {
        throw InputError(
            "no body with its mass between its contacts has these numbers: inertia times rho is "
            "at least 1 (proofs/body.md, L70)");
    }
    return about(q, heights);
}

CertifyRequest body_of_rod(const Rational& q, const Rational& mu) {
    const Rational d1 = (2 * q / (1 + q) + mu) / (2 * (1 + mu));
    const Rational rho = (2 + mu * (1 + q)) / (2 * q + mu * (1 + q));
    const Rational inertia = d1 * d1 / (d1 * d1 * rho - mu / (6 * (1 + mu)));
    return about({inertia, inertia}, {rho, rho});
}

}  // namespace dumbbell::collisions
