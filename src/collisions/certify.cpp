#include "collisions/certify.hpp"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <utility>

#include "base/deadline.hpp"
#include "collisions/halving.hpp"
#include "collisions/plan.hpp"
#include "collisions/section.hpp"
#include "number/parallel.hpp"
#include "number/self_test.hpp"

namespace dumbbell::collisions {
namespace {

using Clock = std::chrono::steady_clock;

/// Not even begun.
ProvedPiece open_piece(const Rational& q_lo, const Rational& q_hi) {
    ProvedPiece open;
    open.piece.q_lo = q_lo;
    open.piece.q_hi = q_hi;
    open.obstacle = Obstacle::time;
    return open;
}

template <class Prove>
ProvedPiece timed(Prove prove) {
    const auto start = Clock::now();
    ProvedPiece proved = prove();
    proved.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return proved;
}

/// From the store if it has the piece; else proved, and kept if that came to its end.
ProvedPiece prove_or_recall(const PlannedPiece& planned, const CertifyRequest& request,
                            const PieceOptions& options) {
    const PieceStore* store = request.store;
    auto kept = store ? store->find(planned, *request.observer) : std::nullopt;
    const bool late = options.interrupted();
    if (kept) {
        ProvedPiece recalled;
        recalled.piece = std::move(*kept);
        if (!late && options.describes) {
            describe_witness(recalled);
        }
        return recalled;
    }
    if (late) {
        return open_piece(planned.q_lo, planned.q_hi);
    }
    ProvedPiece proved = prove_piece(planned.q_lo, planned.q_hi, planned.upper, planned.lower, options);
    if (store && proved.piece.upper) {
        store->keep(proved.piece);
    }
    return proved;
}

/// The pieces with which the range begins that an earlier run has finished: their steps need not be looked
/// for again.
std::vector<ProvedPiece> recalled_beginning(const CertifyRequest& request, const PieceOptions& options) {
    std::vector<ProvedPiece> recalled;
    for (Piece& piece : request.store ? request.store->beginning() : std::vector<Piece>()) {
        recalled.emplace_back().piece = std::move(piece);
        if (options.describes && !options.interrupted()) {
            describe_witness(recalled.back());
        }
    }
    return recalled;
}

/// Steps are looked for, and pieces proved between them, part by part: what is found in time is not lost.
auto plan_steps(const CertifyRequest& request, const PieceOptions& options, const Rational& from) {
    return [&, reached = from, looking = request.observer](const std::vector<ProvedPiece>&) mutable -> Plan {
        const Range& range = request.claim.range;
        if (reached == range.hi) {
            return {};
        }
        Plan plan = plan_staircase(request.claim, reached, options.interrupted, *looking);
        if (plan.pieces.empty()) {  // it is interrupted
            plan.pieces.push_back({reached, range.hi, 1, 0});
        }
        looking = &nobody;
        reached = plan.pieces.back().q_hi;
        return plan;
    };
}

/// The one loop over a range: what a planner plans is proved, or recalled.
template <class Planner>
std::vector<ProvedPiece> prove_range(std::vector<ProvedPiece> pieces, Planner next,
                                     const CertifyRequest& request, PieceOptions options) {
    std::atomic<std::size_t> finished = pieces.size();
    std::vector<ProvedPiece> proved;
    for (Plan batch = next(proved); !batch.pieces.empty(); batch = next(proved)) {
        std::ranges::move(proved, std::back_inserter(pieces));
        proved.assign(batch.pieces.size(), {});
        request.observer->enter("proving", "pieces");
        options.parallel = batch.pieces.size() < static_cast<std::size_t>(request.jobs);
        const std::size_t total = finished + proved.size() + 2 * batch.steps_beyond;
        in_parallel(proved.size(), [&](std::size_t i) {
            proved[i] = timed([&] { return prove_or_recall(batch.pieces[i], request, options); });
            request.observer->update(++finished, total, batch.pieces[i].upper);
        });
    }
    std::ranges::move(proved, std::back_inserter(pieces));
    std::ranges::sort(pieces, {}, [](const ProvedPiece& p) { return std::pair(p.piece.q_lo, p.piece.q_hi); });
    return pieces;
}

std::vector<ProvedPiece> prove_range(const CertifyRequest& request, PieceOptions options) {
    if (staircase_of(request.claim.system).step) {
        auto recalled = recalled_beginning(request, options);
        const Rational from = recalled.empty() ? request.claim.range.lo : recalled.back().piece.q_hi;
        return prove_range(std::move(recalled), plan_steps(request, options, from), request, options);
    }
    options.max_nodes = std::min<std::size_t>(options.max_nodes, 1'000'000);  // before it is halved
    Halving halving(request.claim, request.store, options.interrupted);
    const auto next = [&](std::vector<ProvedPiece>& proved) { return Plan{halving.next(proved)}; };
    return prove_range({}, next, request, options);
}

}  // namespace

std::vector<ProvedPiece> certify(const CertifyRequest& request) {
    require_sound_arithmetic();
    const Range& range = request.claim.range;
    if (out_of_reach(request.claim)) {
        return {open_piece(range.lo, range.hi)};
    }
    PieceOptions options = piece_options(request.claim.system);
    options.describes = request.describes && row_of(options.system.section).has_orbits;
    options.interrupted = deadline(request.budget);
    return with_threads(request.jobs, [&] {
        if (!range.is_single()) {
            return prove_range(request, options);
        }
        options.parallel = true;
        options.observer = request.observer;
        std::vector<ProvedPiece> alone;  // moved to: its trees can be large
        alone.push_back(options.interrupted() ? open_piece(range.lo, range.lo)
                                              : timed([&] { return prove_single(range.lo, options); }));
        return alone;
    });
}

Rational undecided_share(const std::vector<ProvedPiece>& pieces) {
    const Rational whole = pieces.back().piece.q_hi - pieces.front().piece.q_lo;
    if (whole == 0) {
        return pieces.front().piece.status() == Status::exact ? 0 : 1;
    }
    Rational undecided = 0;
    for (const ProvedPiece& proved : pieces) {
        if (proved.piece.status() != Status::exact) {
            undecided += proved.piece.q_hi - proved.piece.q_lo;
        }
    }
    return undecided / whole;
}

}  // namespace dumbbell::collisions
