#include "collisions/piece.hpp"

#include <algorithm>
#include <atomic>

#include "collisions/section.hpp"
#include "flight/count.hpp"
#include "flight/macro/when.hpp"
#include "flight/orbit.hpp"

namespace dumbbell::collisions {
namespace {

/// Calls attempt with a null value of the arithmetic for each precision in turn until it meets no obstacle.
template <class Attempt>
Obstacle escalate(const PieceOptions& options, Attempt attempt) {
    const PrecisionScope scope(double_bits);
    Obstacle obstacle = attempt(Interval(), double_bits);
    for (int bits = double_bits; obstacle != Obstacle::none && bits < options.max_bits;) {
        if (options.interrupted()) {
            return Obstacle::time;
        }
        bits = bits == double_bits ? 128 : std::min(2 * bits, options.max_bits);
        const PrecisionScope wider(bits);
        obstacle = attempt(BigInterval(), bits);
    }
    return obstacle != Obstacle::none && options.interrupted() ? Obstacle::time : obstacle;
}

template <class I>
std::optional<Cover> prove_upper(const Rational& q_lo, const Rational& q_hi, const Count& upper,
                                 const PieceOptions& options) {
    const SectionRow& row = row_of(options.system.section);
    const auto& by_lemma = std::get<BoundSearch<I>>(row.bounds).by_lemma;
    auto known = by_lemma ? by_lemma({q_lo, q_hi}, upper, options.system, options.interrupted) : std::nullopt;
    if (known || row.charts.empty()) {
        return known;
    }
    const CoverOptions limits{.max_nodes = options.max_nodes,
                              .parallel = options.parallel,
                              .interrupted = options.interrupted,
                              .observer = options.observer,
                              .system = options.system};
    const std::span<const Chart> charts = row.charts;
    std::vector<std::optional<Tree>> trees(charts.size());
    std::atomic<bool> all = true;
    flight::each_count<I>(charts.size(), [&](std::size_t i) {
        if (!all) {
            return;
        }
        trees[i] = cover<I>(charts[i], q_lo, q_hi, upper, limits);
        if (!trees[i]) {
            all = false;
        }
    });
    if (!all) {
        return std::nullopt;
    }
    Cover whole;
    for (std::size_t i = 0; i < charts.size(); ++i) {
        whole.charts.push_back({charts[i], std::move(*trees[i])});
    }
    return whole;
}

template <class I>
void describe(ProvedPiece& proved) {
    const Piece& piece = proved.piece;
    const Witness& w = *piece.witness;
    const flight::RatioRange<I> range{enclose<I>(Rational(1) / piece.q_hi),
                                      enclose<I>(Rational(1) / piece.q_lo)};
    double least = 1;
    double greatest_width = 0;
    const auto see = [&](const flight::Collision<I>& collision) {
        least = std::min(least, low_end(collision.grazing_sine).lo());
        greatest_width = std::max(greatest_width, width(collision.y));
    };
    if (visit_orbit<I>({enclose<I>(w.e), enclose<I>(w.eta), as_long(w.forward), as_long(w.backward)}, range,
                       see)) {
        proved.width = greatest_width;
        proved.margin = std::max(0.0, asin(Interval(std::max(0.0, least))).lo());
    }
}

/// The bounds that a piece is to prove, and the ratios at which they are to hold: all of its own, or for a
/// step its ends.
struct Goal {
    Count upper;
    Count lower;
    const Rational& greatest_of_upper;
    const Rational& least_of_lower;
    bool is_suspected = false;  ///< the maximum that the search gives at the same precision
};

/// One precision's attempt at a piece with given bounds.
template <class I>
Obstacle attempt_piece(ProvedPiece& proved, int bits, const Goal& goal, const PieceOptions& options) {
    Piece& piece = proved.piece;
    const auto& [upper, lower, greatest, least, is_suspected] = goal;
    const SectionRow& row = row_of(options.system.section);
    const auto& bounds = std::get<BoundSearch<I>>(row.bounds);
    if (!is_suspected && bounds.may_reach && !bounds.may_reach(lower, least, options.interrupted)) {
        return Obstacle::witness;
    }
    auto witness = bounds.witness({least, piece.q_hi}, lower, options.system, options.interrupted);
    if (!witness) {
        return Obstacle::witness;
    }
    // The verifier evaluates in another way, and loses some bits more: of the section turning about eight
    // next to critical ratios, of others up to a third of its own. With few bits the macro steps of long
    // orbits (L42) end too early, and collisions one after the other are too many.
    const bool is_close = row.bits_to_verify > 0 && upper < flight::macro::least_with_few_bits;
    const bool is_double = bits == double_bits && !options.system.rho;
    const int bits_of_file = is_double ? double_bits : is_close ? bits + row.bits_to_verify : 2 * bits;
    if (bits_of_file > most_file_bits) {
        return Obstacle::maximum;
    }
    piece.bits = bits_of_file;
    piece.lower = lower;
    piece.witness = std::move(*witness);
    // At 1 equal masses need no cover.
    if (!is_suspected && greatest > 1 && bounds.may_stay &&
        !bounds.may_stay(upper, greatest, options.interrupted)) {
        return Obstacle::boxes;
    }
    auto cover = prove_upper<I>(piece.q_lo, greatest, upper, options);
    if (!cover) {
        return Obstacle::boxes;
    }
    piece.upper = upper;
    piece.cover = std::move(*cover);
    return Obstacle::none;
}

void describe_in_time(ProvedPiece& proved, const PieceOptions& options) {
    if (options.describes && !options.interrupted()) {
        describe_witness(proved);
    }
}

ProvedPiece proved_between(const Rational& q_lo, const Rational& q_hi, const Goal& goal,
                           const PieceOptions& options) {
    ProvedPiece proved;
    proved.piece.q_lo = q_lo;
    proved.piece.q_hi = q_hi;
    proved.obstacle = escalate(
        options, [&]<class I>(const I&, int bits) { return attempt_piece<I>(proved, bits, goal, options); });
    describe_in_time(proved, options);
    return proved;
}

}  // namespace

PieceOptions piece_options(const System& system) {
    const SectionRow& row = row_of(system.section);
    return {.system = system, .max_bits = row.max_bits, .max_nodes = row.max_nodes};
}

void describe_witness(ProvedPiece& proved) {
    const Piece& piece = proved.piece;
    constexpr long most = 100'000;  // collisions: they are looked at one by one
    if (!piece.witness || piece.witness->place != Place::bridge || piece.witness->total() > most) {
        return;
    }
    const PrecisionScope scope(piece.bits);
    if (piece.bits == double_bits) {
        describe<Interval>(proved);
    } else {
        describe<BigInterval>(proved);
    }
}

ProvedPiece prove_single(const Rational& q, const PieceOptions& options) {
    ProvedPiece proved;
    proved.piece.q_lo = proved.piece.q_hi = q;
    proved.obstacle = escalate(options, [&]<class I>(const I&, int bits) {
        const auto n = std::get<BoundSearch<I>>(row_of(options.system.section).bounds)
                           .maximum(q, options.system, options.interrupted);
        return n ? attempt_piece<I>(proved, bits, {*n, *n, q, q, true}, options) : Obstacle::maximum;
    });
    describe_in_time(proved, options);
    return proved;
}

ProvedPiece prove_piece(const Rational& q_lo, const Rational& q_hi, long upper, long lower,
                        const PieceOptions& options) {
    return proved_between(q_lo, q_hi, {upper, lower, q_hi, q_lo}, options);
}

ProvedPiece prove_step(const Rational& q_lo, const Rational& q_hi, long n, const PieceOptions& options) {
    return proved_between(q_lo, q_hi, {n - 1, n, q_lo, q_hi}, options);
}

}  // namespace dumbbell::collisions
