#include "collisions/claim.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "collisions/section.hpp"
#include "number/decimal.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::collisions {
namespace {

/// How a body is given; nothing of what is none.
std::string body_text(const Claim& claim) {
    if (claim.rod) {
        return fmt::format("{} --rod-mass {}", exact_text(claim.rod->ratio), spelled(claim.rod->mass));
    }
    const auto& rho = claim.system.rho;
    return !rho ? ""
           : *rho == 1 && claim.range == Range{4, 4}
               ? "--coin"
               : fmt::format("--rho {} --inertia {}", spelled(*rho), spelled(claim.range.lo, claim.range.hi));
}

std::string system_text(const Claim& claim) {
    if (claim.system.rho) {
        return (claim.rod ? "--ratio " : "") + body_text(claim);
    }
    return "--ratio " + spelled(claim.range.lo, claim.range.hi);
}

bool has_upper(const Piece* piece) { return piece->upper.has_value(); }

/// Stretches [a, b] of touching pieces that leave more than one value: how many, and their greatest relative
/// width (b - a)/a. What is known at a single ratio divides none.
struct Gaps {
    Rational widest;
    long number = 0;
};
Gaps gaps_of(const std::vector<const Piece*>& pieces) {
    Gaps gaps;
    const Rational* begin = nullptr;  // of the stretch
    for (const Piece* piece : pieces) {
        if (piece->status() != Status::exact) {
            gaps.number += begin == nullptr;
            begin = begin == nullptr ? &piece->q_lo : begin;
            gaps.widest = std::max(gaps.widest, Rational((piece->q_hi - *begin) / *begin));
        } else if (piece->q_lo < piece->q_hi) {
            begin = nullptr;
        }
    }
    return gaps;
}

/// An upper bound of a relative width as --gap takes it, `9.01e-7`; empty if that is 1 or more, which it does
/// not.
std::string gap_text(const Rational& width) {
    constexpr int digits = 3;
    const Decimal bound = without_zeros(cut_up(width, digits));
    return exact(bound) < 1 ? to_text(bound) : "";
}

}  // namespace

Range parse_range(const char* option, const std::string& text) {
    const std::size_t colon = text.find(':');
    const Rational lo = parse_number(option, text.substr(0, colon));
    const Rational hi = colon == std::string::npos ? lo : parse_number(option, text.substr(colon + 1));
    if (lo == 0 || lo > hi) {
        throw InputError(
            fmt::format("{} is a number greater than 0, or a range LO:HI, the smaller one first", option));
    }
    return {lo, hi};
}

void require_rho(const Rational& rho) {
    if (rho == 0 || rho > 1) {
        throw InputError("--rho is d2/d1 with d1 >= d2, so above 0 and at most 1: swap the ends");
    }
}

Claim claim_of_body(const std::string& rho, const std::string& inertia) {
    if (rho.find(':') != std::string::npos) {
        throw InputError("--rho is one number, not a range LO:HI");
    }
    const Rational height = parse_number("--rho", rho);
    require_rho(height);
    return {.range = parse_range("--inertia", inertia), .system = {Section::body, height}};
}

Claim by_plain_covers(Claim claim) {
    if (claim.range.lo * *claim.system.rho < 1) {
        throw InputError(
            "plain covers are of bodies with their mass between the contacts: inertia times rho is at least "
            "1 (proofs/body.md, L70)");
    }
    claim.system.section = Section::plain_body;
    return claim;
}

Claim claim_of(const Rod& rod) {
    const auto& [q, mu] = rod;
    const Rational d1 = (2 * q / (1 + q) + mu) / (2 * (1 + mu));
    const Rational rho = (2 + mu * (1 + q)) / (2 * q + mu * (1 + q));
    const Rational inertia = d1 * d1 / (d1 * d1 * rho - mu / (6 * (1 + mu)));
    return {.range = {inertia, inertia}, .system = {Section::body, rho}, .rod = rod};
}

Claim claim_of(const Certificate& certificate) {
    const Rational widest = gaps_of(pieces_of(certificate)).widest;
    const bool can_be_asked_for = widest > 0 && widest <= Rational(1, 100);
    return {.range = certificate.range(),
            .system = certificate.system,
            .gap = can_be_asked_for ? exact(cut_up(widest, 1)) : Rational(0)};
}

std::vector<const Piece*> pieces_of(const Certificate& certificate) {
    std::vector<const Piece*> pieces;
    std::ranges::transform(certificate.pieces, std::back_inserter(pieces),
                           [](const Piece& piece) { return &piece; });
    return pieces;
}

std::string options_of(const Claim& claim) {
    const std::string_view section = row_of(claim.system.section).section,
                           usual = row_of(claim.system.rho ? Section::body : Section()).section;
    return (section == usual ? "" : fmt::format(" --section {}", section)) +
           (claim.gap == 0 ? "" : " --gap " + exact_text(claim.gap));
}

std::string command(const Claim& claim) {
    const auto& [lo, hi] = claim.range;
    return "dumbbell certify " + (claim.system.rho ? body_text(claim) : spelled(lo, hi)) + options_of(claim);
}

bool heavy_at_most_once(const Claim& claim, const std::vector<const Piece*>& pieces) {
    return row_of(claim.system.section).shows_heavy_once && std::ranges::all_of(pieces, has_upper);
}

std::string whole_demand(const Claim& claim, const std::vector<const Piece*>& pieces) {
    std::string text = system_text(claim);
    const Count least = (*std::ranges::min_element(pieces, {}, &Piece::lower))->lower;
    if (!std::ranges::all_of(pieces, has_upper)) {
        return text + (least > 0 ? fmt::format(" --min {}", least) : "");
    }
    const Count most = *(*std::ranges::max_element(pieces, {}, &Piece::upper))->upper;
    text += most == least ? fmt::format(" --exactly {}", most) : fmt::format(" --max {}", most);
    if (most != least && least > 0) {
        text += fmt::format(" --min {}", least);
    }
    // What --gap demands: one of two neighbouring numbers, of bodies of two or three.
    const int leap = claim.system.rho ? 2 : 1;
    const bool is_staircase =
        !claim.range.is_single() && most != least &&
        std::ranges::none_of(pieces, [&](const Piece* piece) { return *piece->upper > piece->lower + leap; });
    const Gaps gaps = gaps_of(pieces);
    if (const std::string widest = is_staircase ? gap_text(gaps.widest) : ""; !widest.empty()) {
        text += fmt::format(" --gap {} --gaps {}", widest, gaps.number);
    }
    return text + (heavy_at_most_once(claim, pieces) ? " --heavy-at-most 1" : "");
}

std::string options_to_check(const Claim& claim, const std::vector<const Piece*>& pieces) {
    constexpr int usual = 2048;
    const int bits = (*std::ranges::max_element(pieces, {}, &Piece::bits))->bits;
    return (bits > usual ? fmt::format("--max-bits {} ", bits) : "") + whole_demand(claim, pieces);
}

bool fits_a_line(const Range& range) {
    constexpr std::size_t most = longest_line_in_file - 12;  // without the line's word
    return to_fraction(range.lo).size() + to_fraction(range.hi).size() <= most;
}

std::optional<std::string> out_of_reach(const Claim& claim) {
    const auto& [q_lo, q_hi] = claim.range;
    constexpr int common = SectionRow{}.most_digits;
    const int most =
        claim.range.is_single() || claim.system.rho ? row_of(claim.system.section).most_digits : common;
    const bool far = most > common;
    if (!fits_a_line(claim.range)) {
        return fmt::format("{} is too long for a line of a certificate: write fewer digits",
                           printable(exact_text(q_lo), 40));
    }
    if (claim.system.rho && !fits_a_line({*claim.system.rho, *claim.system.rho})) {
        return "the rho of the body is too long for a line of a certificate: write fewer digits";
    }
    if (q_hi <= Rational(pow(Integer(10), static_cast<unsigned>(most)))) {
        return std::nullopt;
    }
    const std::string q = exact_text(q_hi);
    if (claim.system.rho) {
        return fmt::format("Q = {} is beyond 10^{}, the greatest that is tried", printable(q, 40), most);
    }
    return fmt::format(
        "the mass ratio {} is beyond 10^{}, the greatest that is tried{}: one orbit has about 10^{} "
        "collisions there{}",
        printable(q, 40), most, far ? "" : " except for a single ratio of the dumbbell (section turning)",
        most / 2,
        far ? "; what the law for every mass ratio says: dumbbell law --ratio " +
                  (q.size() > 40 ? "RATIO" : q)
            : "");
}

}  // namespace dumbbell::collisions
