#include "collisions/piece.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <type_traits>

#include "collisions/witness.hpp"
#include "flight/batch/query.hpp"
#include "flight/count.hpp"
#include "flight/extremal_orbit.hpp"
#include "flight/orbit.hpp"
#include "flight/paper_bound.hpp"

namespace dumbbell::collisions {
namespace {

/// Calls attempt with a null value of the arithmetic for each precision in turn until it meets no obstacle.
template <class Attempt>
Obstacle escalate(const PieceOptions& options, Attempt attempt) {
    const PrecisionScope scope(double_bits);
    Obstacle obstacle = attempt(Interval(), double_bits);
    for (int bits = 128; obstacle != Obstacle::none && bits <= options.max_bits; bits *= 2) {
        if (options.interrupted()) {
            return Obstacle::time;
        }
        const PrecisionScope wider(bits);
        obstacle = attempt(BigInterval(), bits);
    }
    return obstacle != Obstacle::none && options.interrupted() ? Obstacle::time : obstacle;
}

template <class I>
std::optional<Cover> prove_upper(const Rational& q_lo, const Rational& q_hi, const Count& upper,
                                 const PieceOptions& options) {
    if (options.scene == Scene::dumbbell && q_lo == 1 && q_hi == 1 && upper >= 2) {
        return Cover{.equal_masses = true, .charts = {}};
    }
    const CoverOptions limits{.max_nodes = options.max_nodes,
                              .parallel = options.parallel,
                              .interrupted = options.interrupted,
                              .observer = options.observer};
    const std::vector<Chart> charts = charts_of(options.scene, options.section);
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
    if (visit_orbit<I>({enclose<I>(w.e), enclose<I>(w.eta), w.forward, w.backward}, range, see)) {
        proved.width = greatest_width;
        proved.margin = std::max(0.0, asin(Interval(std::max(0.0, least))).lo());
    }
}

/// Whether two neighbouring counts at q are not beyond this precision: C sqrt q has half the digits of q.
bool tells_counts_apart(int bits, const Rational& q) {
    if (bits == double_bits) {
        return q <= parse_rational("1e27");
    }
    constexpr int spare = 24;
    return static_cast<int>(msb(Integer(numerator(q) / denominator(q)))) / 2 + spare <= bits;
}

/// Whether this precision tells that there are n >= 2 collisions at q: the flight that decides (Theorem 2
/// (c)) certainly has one. Like orbits_stay_below it only says what to try: it costs as much as one ray of a
/// cover, a search in vain a hundred times that. With both, and the search for witnesses from the last bits
/// on, `certify 4:5 --gap 1e-190` went from 7.9 s to 0.01 s.
template <class I>
bool orbits_reach(long n, const Rational& q, const Interrupted& interrupted) {
    const auto [orbit, flight] = flight::tangent_flight(n);
    return count_at_least(extremal_ray(orbit, enclose<I>(Rational(1) / q)), flight, interrupted) == flight;
}

/// Whether it tells that there are not more than n >= 2.
template <class I>
bool orbits_stay_below(long n, const Rational& q, const Interrupted& interrupted) {
    const auto [orbit, flight] = flight::tangent_flight(n + 1);
    return count_at_most(extremal_ray(orbit, enclose<I>(Rational(1) / q)), flight - 1, interrupted) < flight;
}

/// The bounds that a piece is to prove, and the ratios at which they are to hold: all of its own, or for a
/// step its ends.
struct Goal {
    Count upper;
    Count lower;
    const Rational& greatest_of_upper;
    const Rational& least_of_lower;
    bool is_suspected = false;  ///< by suspected_maximum, at the same precision
};

/// One precision's attempt at a piece with given bounds.
template <class I>
Obstacle attempt_piece(ProvedPiece& proved, int bits, const Goal& goal, const PieceOptions& options) {
    Piece& piece = proved.piece;
    const auto& [upper, lower, greatest, least, is_suspected] = goal;
    const bool asks_orbits = options.scene == Scene::dumbbell && !is_suspected;
    if (asks_orbits && !orbits_reach<I>(lower, least, options.interrupted)) {
        return Obstacle::witness;
    }
    auto witness = options.scene == Scene::dumbbell
                       ? find_witness<I>(least, piece.q_hi, lower, options.interrupted)
                       : find_wedge_witness(least, lower, options.interrupted);
    if (!witness) {
        return Obstacle::witness;
    }
    // The verifier's own evaluation loses a part of the bits that this one does not: leave it room.
    piece.bits = bits == double_bits ? double_bits : 2 * bits;
    piece.lower = lower;
    piece.witness = std::move(*witness);
    // At 1 equal masses need no cover.
    if (asks_orbits && greatest > 1 && !orbits_stay_below<I>(upper, greatest, options.interrupted)) {
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

/// What N* seems to be, from upper bounds on the two extremal orbits and a lower one on that whose last
/// flight decides (Theorem 2 (c)); nothing if this precision cannot tell, or not in time. It only says what
/// to try.
template <class I>
std::optional<Count> suspected_maximum(const Rational& q, const PieceOptions& options) {
    using flight::ExtremalOrbit;
    using N = flight::CountOf<I>;
    N cap = 1L << 60;
    if constexpr (std::is_same_v<I, BigInterval>) {
        cap += Count(numerator(q) / denominator(q));  // more than C sqrt q
    }
    const I r = enclose<I>(Rational(1) / q);
    const std::array rays{extremal_ray(ExtremalOrbit::top, r), extremal_ray(ExtremalOrbit::corner, r)};
    std::array<N, 2> counts;
    flight::each_count<I>(
        2, [&](std::size_t i) { counts[i] = count_at_most(rays[i], cap, options.interrupted); });
    const auto& [top, corner] = counts;
    const N& last = std::max(top, corner);
    if (last > cap) {
        return std::nullopt;
    }
    const bool reached = count_at_least(rays[top > corner ? 0 : 1], last, options.interrupted) == last;
    return reached ? std::optional(Count(2) + top + corner) : std::nullopt;
}

}  // namespace

PieceOptions piece_options(Scene scene, Section section) {
    PieceOptions options{.scene = scene, .section = section};
    if (section != Section::turning) {
        options.max_nodes = 20'000'000;  // all states, not a section of them
    }
    return options;
}

void describe_witness(ProvedPiece& proved) {
    const Piece& piece = proved.piece;
    constexpr long most = 100'000;  // collisions: they are looked at one by one
    if (!piece.witness || piece.witness->chart != Chart::bridge || piece.witness->total() > most) {
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
        if (options.scene == Scene::dumbbell && !tells_counts_apart(bits, q)) {
            return Obstacle::maximum;
        }
        const auto n = options.scene != Scene::dumbbell ? std::optional<Count>(flight::paper_bound(q) - 1)
                       : q == 1                         ? std::optional<Count>(2)
                                                        : suspected_maximum<I>(q, options);
        return n ? attempt_piece<I>(proved, bits, {*n, *n, q, q, true}, options) : Obstacle::maximum;
    });
    describe_in_time(proved, options);
    return proved;
}

ProvedPiece prove_piece(const Rational& q_lo, const Rational& q_hi, long upper, long lower,
                        const PieceOptions& options) {
    ProvedPiece proved;
    proved.piece.q_lo = q_lo;
    proved.piece.q_hi = q_hi;
    proved.obstacle = escalate(options, [&]<class I>(const I&, int bits) {
        return attempt_piece<I>(proved, bits, {upper, lower, q_hi, q_lo}, options);
    });
    describe_in_time(proved, options);
    return proved;
}

ProvedPiece prove_step(const Rational& q_lo, const Rational& q_hi, long n, const PieceOptions& options) {
    ProvedPiece proved;
    proved.piece.q_lo = q_lo;
    proved.piece.q_hi = q_hi;
    proved.obstacle = escalate(options, [&]<class I>(const I&, int bits) {
        return attempt_piece<I>(proved, bits, {n - 1, n, q_lo, q_hi}, options);
    });
    return proved;
}

}  // namespace dumbbell::collisions
