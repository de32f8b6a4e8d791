#include "critical/bodies.hpp"

#include <cmath>

#include "collisions/certify.hpp"
#include "collisions/section.hpp"
#include "number/decimal.hpp"

namespace dumbbell::critical {

using collisions::Claim;

namespace {

/// What seems to be N; nothing if interrupted.
template <class I = Interval>
std::optional<Count> guess_at(const Bodies& bodies, const Rational& t, const Options& options) {
    const Claim body = bodies.at(t);
    const auto& bounds = std::get<collisions::BoundSearch<I>>(row_of(body.system.section).bounds);
    return bounds.maximum(body.range.lo, body.system, options.interrupted);
}

/// Of a bracket: where there seem to be less than n collisions, and where as many.
struct Ends {
    Rational less, more;
};

/// To so many bits; nothing if interrupted.
template <class I>
std::optional<Ends> narrowed(const Bodies& bodies, long n, Ends ends, int bits, const Options& options) {
    while (abs(ends.more - ends.less) > ends.more * power_of_half(bits)) {
        const bool is_far = ends.more > 2 * ends.less || ends.less > 2 * ends.more;
        const Rational middle = is_far
                                    ? exact(std::sqrt(Rational(ends.less * ends.more).convert_to<double>()))
                                    : (ends.less + ends.more) / 2;
        const auto most = guess_at<I>(bodies, middle, options);
        if (!most) {
            return std::nullopt;
        }
        (*most < n ? ends.less : ends.more) = middle;
    }
    return ends;
}

/// N, if dumbbell certify decides it.
std::optional<collisions::Piece> certified_at(const Bodies& bodies, const Rational& t) {
    const auto pieces = collisions::certify({.claim = bodies.at(t), .describes = false});
    const collisions::Piece& piece = pieces.front().piece;
    return piece.status() == collisions::Status::exact ? std::optional(piece) : std::nullopt;
}

/// Between decimals of so many digits that are next to the bracket.
std::optional<Ratio> proved_near(const Ends& ends, long n, int digits, const Bodies& bodies,
                                 const Options& options) {
    const Rational lo = exact(cut_down(std::min(ends.less, ends.more), digits)),
                   hi = exact(cut_up(std::max(ends.less, ends.more), digits));
    if (!shared_digits(lo, hi, options.digits) || options.interrupted()) {
        return std::nullopt;
    }
    const auto first = certified_at(bodies, lo), second = certified_at(bodies, hi);
    if (!first || !second) {
        return std::nullopt;
    }
    const auto& [less, more] = bodies.have_rods ? std::pair(second, first) : std::pair(first, second);
    return less->lower < n && n <= more->lower
               ? std::optional(Ratio{.n = as_long(more->lower),
                                     .q_lo = lo,
                                     .q_hi = hi,
                                     .bits = std::max(first->bits, second->bits),
                                     .below = as_long(less->lower)})
               : std::nullopt;
}

/// The step to n between these ends, or where N leaps over it.
std::optional<Ratio> enclose_between(const Bodies& bodies, long n, const Ends& far, const Options& options) {
    constexpr int few = 26;
    auto ends = narrowed<Interval>(bodies, n, far, few, options);
    for (int digits = options.digits + 2; ends && digits < options.digits + 20; digits += 6) {
        const int bits = static_cast<int>(std::ceil(digits * std::log2(10.0))) + 4;
        const PrecisionScope scope(2 * bits + 64);
        ends = narrowed<BigInterval>(bodies, n, *ends, bits, options);
        if (auto ratio = ends ? proved_near(*ends, n, digits, bodies, options) : std::nullopt) {
            return ratio;
        }
    }
    return std::nullopt;
}

}  // namespace

Claim Bodies::at(const Rational& t) const {
    return have_rods ? claim_of(collisions::Rod{number, t})
                     : Claim{.range = {t, t}, .system = {collisions::Section::body, number}};
}

std::optional<Ratio> enclose_inertia(const Bodies& bodies, long n, const Options& options) {
    Ends far{1, 1};
    auto most = guess_at(bodies, 1, options);
    for (; most && *most < n; most = guess_at(bodies, far.more, options)) {
        far.more *= 4;
    }
    for (most = guess_at(bodies, 1, options); most && *most >= n;
         most = guess_at(bodies, far.less, options)) {
        far.less /= 4;
    }
    return most ? enclose_between(bodies, n, far, options) : std::nullopt;
}

std::vector<Row> enclose_falls(const Bodies& bodies, const Options& options) {
    const Rational greatest = 2048;
    std::vector<Row> falls;
    Rational mass = power_of_half(60);
    for (auto most = guess_at(bodies, mass, options); mass < greatest; mass *= 2) {
        const auto next = guess_at(bodies, 2 * mass, options);
        while (most && next && *most > *next) {
            falls.push_back(
                {as_long(*most), enclose_between(bodies, as_long(*most), {2 * mass, mass}, options)});
            const auto& fall = falls.back().ratio;
            most = fall ? std::optional(Count(fall->below)) : std::nullopt;
        }
        if (!most || !next) {
            falls.push_back({});
            break;
        }
        most = next;
    }
    return falls;
}

}  // namespace dumbbell::critical
