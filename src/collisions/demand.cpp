#include "collisions/demand.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "collisions/scene.hpp"
#include "number/decimal.hpp"

namespace dumbbell::collisions {
namespace {

std::string ends_text(const Rational& lo, const Rational& hi) {
    return lo == hi ? exact_text(lo) : exact_text(lo) + ":" + exact_text(hi);
}

std::string system_of(const Certificate& frame, const std::string& range, const std::string& rod) {
    if (!frame.heights) {
        return option_of(frame.scene) + "--ratio " + range;
    }
    const std::string rho = ends_text(frame.heights->lo, frame.heights->hi);
    return !rod.empty()                 ? rod
           : rho == "1" && range == "4" ? "--coin"
                                        : fmt::format("--rho {} --inertia {}", rho, range);
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

bool heavy_at_most_once(const Certificate& frame, const std::vector<const Piece*>& pieces) {
    return frame.section != Section::turning && !frame.heights && std::ranges::all_of(pieces, has_upper);
}

std::string whole_demand(const Certificate& frame, const std::vector<const Piece*>& pieces,
                         const std::string& rod) {
    const Rational &lo = pieces.front()->q_lo, &hi = pieces.back()->q_hi;
    std::string text = system_of(frame, ends_text(lo, hi), rod);
    const Count least = (*std::ranges::min_element(pieces, {}, &Piece::lower))->lower;
    if (!std::ranges::all_of(pieces, has_upper)) {
        return text + (least > 0 ? fmt::format(" --min {}", least) : "");
    }
    const Count most = *(*std::ranges::max_element(pieces, {}, &Piece::upper))->upper;
    text += most == least ? fmt::format(" --exactly {}", most) : fmt::format(" --max {}", most);
    if (most != least && least > 0) {
        text += fmt::format(" --min {}", least);
    }
    const bool is_staircase =
        lo < hi && most != least &&
        std::ranges::none_of(pieces, [](const Piece* piece) { return piece->status() == Status::open; });
    const Gaps gaps = gaps_of(pieces);
    if (const std::string widest = is_staircase ? gap_text(gaps.widest) : ""; !widest.empty()) {
        text += fmt::format(" --gap {} --gaps {}", widest, gaps.number);
    }
    return text + (heavy_at_most_once(frame, pieces) ? " --heavy-at-most 1" : "");
}

std::string options_to_check(const Certificate& frame, const std::vector<const Piece*>& pieces,
                             const std::string& rod) {
    constexpr int usual = 2048;
    const int bits = (*std::ranges::max_element(pieces, {}, &Piece::bits))->bits;
    return (bits > usual ? fmt::format("--max-bits {} ", bits) : "") + whole_demand(frame, pieces, rod);
}

}  // namespace dumbbell::collisions
